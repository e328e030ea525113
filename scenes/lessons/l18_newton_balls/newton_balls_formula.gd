class_name NewtonBallsFormula
extends RefCounted
## The formula of the lesson on balls that meet: its lines, and what each name in them is.

const _GIVEN: PackedStringArray = [
	"{m1s} = {m1}   {v1} = ( {vx1} , {vy1} )",
	"{m2s} = {m2}   {v2} = ( {vx2} , {vy2} )",
	"C = {C}",
]
# What a wall may have changed before the balls meet.
const _GIVEN_IN_BOX: PackedStringArray = [
	"{m1s} = {m1}   {v1} = {v1_pair}",
	"{m2s} = {m2}   {v2} = {v2_pair}",
	"C = {C}",
]
const _CLOSING := "w = ({v1} − {v2}) · {n} = {dvx}·{nx} + {dvy}·{ny} = {w}"
const _CENTER := (
	"{V} = ({m1s} {v1} + {m2s} {v2}) / ({m1s} + {m2s})" + " = ({p1} + {p2}) / {M} = {V_pair}"
)
const _LINES: Dictionary[NewtonBallsModel.Step, Array] = {
	NewtonBallsModel.Step.MEET: [],
	NewtonBallsModel.Step.NORMAL: ["d = c₂ − c₁ = {d}   {n} = d / |d| = {n_pair}", _CLOSING],
	NewtonBallsModel.Step.CENTER: [_CENTER],
	NewtonBallsModel.Step.FRAME:
	[
		"{V} = {V_pair}   {n} = {n_pair}",
		"{u1} = {v1} − {V} = {u1_pair}   {u1} · {n} = {u1n}",
		"{u2} = {v2} − {V} = {u2_pair}   {u2} · {n} = {u2n}",
		"{u1a} · {n} = −C ({u1} · {n}) = {u1an}",
		"{u2a} · {n} = −C ({u2} · {n}) = {u2an}",
	],
	NewtonBallsModel.Step.IMPULSE:
	[
		"{n} = {n_pair}",
		_CLOSING,
		"μ = {m1s} {m2s} / ({m1s} + {m2s}) = {m1v}·{m2v} / {M} = {mu}",
		"{J} = (1 + C) μ w = (1 + {Cv})·{mu}·{w} = {J_number}",
	],
	NewtonBallsModel.Step.AFTER:
	[
		"{J} = {J_number}   {n} = {n_pair}",
		"{v1a} = {v1} − ({J} / {m1s}) {n} = {v1_pair} − {j1}·{n_pair} = {v1a_pair}",
		"{v2a} = {v2} + ({J} / {m2s}) {n} = {v2_pair} + {j2}·{n_pair} = {v2a_pair}",
	],
	NewtonBallsModel.Step.MOMENTUM:
	[
		"{v1a} = {v1a_pair}   {v2a} = {v2a_pair}",
		"p₁ = {m1s} {v1} = {p1}   p₂ = {m2s} {v2} = {p2}",
		"{P} = p₁ + p₂ = {p1} + {p2} = {P_pair}",
		"p₁′ = {m1s} {v1a} = {p1a}   p₂′ = {m2s} {v2a} = {p2a}",
		"{Pa} = p₁′ + p₂′ = {p1a} + {p2a} = {Pa_pair}",
	],
	NewtonBallsModel.Step.ENERGY:
	[
		"{v1a} = {v1a_pair}   {v2a} = {v2a_pair}",
		"E = {m1s} |{v1}|² / 2 + {m2s} |{v2}|² / 2 = {E1} + {E2} = {E}",
		"E′ = {m1s} |{v1a}|² / 2 + {m2s} |{v2a}|² / 2 = {E1a} + {E2a} = {Ea}",
		"μ = {mu}   w = {w}",
		"E − E′ = (1 − C²) μ w² / 2 = {loss}",
	],
}

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of [param step] for [param model] and its [param meeting], which may be null.
func show_model(model: NewtonBallsModel, meeting: BallMeeting, step: int) -> void:
	_put_given(model, meeting)
	var lines := (_GIVEN_IN_BOX if model.has_box and meeting else _GIVEN).duplicate()
	if meeting:
		_put_along(meeting)
		_put_center(meeting)
		_put_after(meeting)
		_put_energy(meeting)
		lines.append_array(PackedStringArray(_LINES[step]))
	if NewtonBallsTexts.is_compared(model, meeting, step):
		var wrong := NewtonBallsMistakes.velocities_after(model.shown_mistake(), meeting)
		_put_sum("wrong1", wrong[0], meeting.speed_scale(), Palette.Role.WRONG)
		_put_sum("wrong2", wrong[1], meeting.speed_scale(), Palette.Role.WRONG)
		lines.append("{wrong}: {wrong1}   {wrong}: {wrong2}")
	_formula.show_lines(lines)


# Each of these with a title has its counterpart in NewtonBallsModel.enter.
func _put_given(model: NewtonBallsModel, meeting: BallMeeting) -> void:
	var indices := Vector2i(meeting.first, meeting.second) if meeting else Vector2i(0, 1)
	var roles: Array[Palette.Role] = [Palette.Role.A, Palette.Role.B]
	for place: int in 2:
		var ball := model.balls[indices[place]]
		var number := str(place + 1)
		var role := roles[place]
		var subscript: String = ["₁", "₂"][place]
		_formula.put_symbol("m%ss" % number, "m" + subscript, role)
		_formula.put_symbol("v" + number, "v" + subscript, role)
		_formula.put_symbol("v%sa" % number, "v%s′" % subscript, role)
		_formula.put_number("m" + number, ball[4], role, tr("mass of ball %s") % number)
		_formula.put_number("m%sv" % number, ball[4], role)
		_formula.put_number(
			"vx" + number, ball[2], role, tr("x of the velocity of ball %s") % number
		)
		_formula.put_number(
			"vy" + number, ball[3], role, tr("y of the velocity of ball %s") % number
		)
	_formula.put_number("C", model.bounciness, Palette.Role.INK, tr("bounciness C"))
	_formula.put_number("Cv", model.bounciness, Palette.Role.INK)
	_formula.put_symbol("wrong", tr("mistake"), Palette.Role.WRONG)


func _put_along(meeting: BallMeeting) -> void:
	var ink := Palette.Role.INK
	var between := meeting.two.position.minus(meeting.one.position)
	var size := meeting.one.position.length() + meeting.two.position.length()
	_put_sum("d", between, size, ink)
	_formula.put_symbol("n", "n", Palette.Role.UNIT)
	_put_sum("n_pair", meeting.normal, size / between.length(), Palette.Role.UNIT)
	_formula.put_vector("v1_pair", meeting.one.velocity, Palette.Role.A)
	_formula.put_vector("v2_pair", meeting.two.velocity, Palette.Role.B)
	var closing := meeting.one.velocity.minus(meeting.two.velocity)
	_formula.put_number("dvx", closing.x, ink)
	_formula.put_number("dvy", closing.y, ink)
	_formula.put_number("nx", meeting.normal.x, Palette.Role.UNIT)
	_formula.put_number("ny", meeting.normal.y, Palette.Role.UNIT)
	_formula.put_number("w", meeting.closing_speed(), ink)


func _put_center(meeting: BallMeeting) -> void:
	var blue := Palette.Role.PROJECTION
	_formula.put_vector("p1", meeting.one.velocity.scaled(meeting.one.mass), Palette.Role.A)
	_formula.put_vector("p2", meeting.two.velocity.scaled(meeting.two.mass), Palette.Role.B)
	_formula.put_number("M", meeting.total_mass(), Palette.Role.INK)
	_formula.put_symbol("V", "V", blue)
	var center := meeting.center_velocity()
	_put_sum("V_pair", center, meeting.speed_scale(), blue)
	var balls: Array[Ball] = [meeting.one, meeting.two]
	var roles: Array[Palette.Role] = [Palette.Role.A, Palette.Role.B]
	for place: int in 2:
		var number := str(place + 1)
		var subscript: String = ["₁", "₂"][place]
		var seen := balls[place].velocity.minus(center)
		var along := seen.dot(meeting.normal)
		_formula.put_symbol("u" + number, "u" + subscript, roles[place])
		_formula.put_symbol("u%sa" % number, "u%s′" % subscript, roles[place])
		_put_sum("u%s_pair" % number, seen, 2.0 * meeting.speed_scale(), roles[place])
		_formula.put_sum("u%sn" % number, along, 2.0 * meeting.speed_scale(), roles[place])
		_formula.put_sum(
			"u%san" % number,
			-meeting.bounciness * along,
			2.0 * meeting.speed_scale() * meeting.bounciness,
			roles[place]
		)


func _put_after(meeting: BallMeeting) -> void:
	_formula.put_number("mu", meeting.reduced_mass(), Palette.Role.INK)
	_formula.put_symbol("J", "J", Palette.Role.REST)
	_formula.put_number("J_number", meeting.impulse(), Palette.Role.REST)
	_formula.put_number("j1", meeting.impulse() / meeting.one.mass, Palette.Role.REST)
	_formula.put_number("j2", meeting.impulse() / meeting.two.mass, Palette.Role.REST)
	var after := meeting.velocities_after()
	var size := meeting.speed_scale()
	_put_sum("v1a_pair", after[0], size + meeting.impulse() / meeting.one.mass, Palette.Role.A)
	_put_sum("v2a_pair", after[1], size + meeting.impulse() / meeting.two.mass, Palette.Role.B)
	var blue := Palette.Role.PROJECTION
	var sizes := meeting.one.mass * meeting.one.velocity.length()
	sizes += meeting.two.mass * meeting.two.velocity.length() + 2.0 * meeting.impulse()
	_formula.put_symbol("P", "P", blue)
	_formula.put_symbol("Pa", "P′", blue)
	_put_sum("P_pair", meeting.momentum(), sizes, blue)
	_put_sum("p1a", after[0].scaled(meeting.one.mass), sizes, Palette.Role.A)
	_put_sum("p2a", after[1].scaled(meeting.two.mass), sizes, Palette.Role.B)
	_put_sum("Pa_pair", meeting.momentum_of(after), sizes, blue)


func _put_energy(meeting: BallMeeting) -> void:
	var after := meeting.velocities_after()
	var one := meeting.one
	var two := meeting.two
	_formula.put_number("E1", one.mass * one.velocity.length_squared() / 2.0, Palette.Role.A)
	_formula.put_number("E2", two.mass * two.velocity.length_squared() / 2.0, Palette.Role.B)
	_formula.put_number("E1a", one.mass * after[0].length_squared() / 2.0, Palette.Role.A)
	_formula.put_number("E2a", two.mass * after[1].length_squared() / 2.0, Palette.Role.B)
	_formula.put_number("E", meeting.energy(), Palette.Role.INK)
	_formula.put_number("Ea", meeting.energy_of(after), Palette.Role.INK)
	_formula.put_number("loss", meeting.lost_energy(), Palette.Role.REST)


func _put_sum(name_in_line: String, sum: Vec2, size: float, role: Palette.Role) -> void:
	_formula.put_vector_sum(name_in_line, sum, Vec2.new(size, size), role)
