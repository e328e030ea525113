class_name CollisionFrictionFormula
extends RefCounted
## The formula of the lesson on friction at a bounce: its lines, and what each name in them is.

const _VELOCITY := "{v} = ( {vx} , {vy} )   {o} = {spin}   r = {radius}"
const _ALONG := "{v} · {t} = {vxn}·{tx} + {vyn}·{ty} = {vt}"
const _SLIP := "{u} = {v} · {t} − r {o} = {vt} − {rn}·{on} = {slip}"
const _CLOSING := "{v} · {n} = {vxn}·{nx} + {vyn}·{ny} = {vn}"
const _PUSH := "{jn} = −(1 + C) {v} · {n} = −(1 + {cn})·{vn} = {push}"
const _STICKS := "|{u}| / 3 = {needed} ≤ {limit} = µ {jn}"
const _SLIPS := "|{u}| / 3 = {needed} > {limit} = µ {jn}"
const _IMPULSE := "{J} = {jn} {n} + {jt} {t} = {J_pair}"
const _AXES := "{n} = {n_pair}   {t} = {t_pair}"

const _AFTER: PackedStringArray = [
	"{J} = {J_pair}   {jt} = {grip}",
	"{va} = {v} + {J} = {v_pair} + {J_pair} = {va_pair}",
	"{oa} = {o} − 2 {jt} / r = {on} − 2·{grip} / {rn} = {oan}",
]
const _AFTER_OF_TWO: PackedStringArray = [
	"{J} = {J_pair}   {jt} = {grip}",
	"{va} = {v} + {J} / 2 = {v_pair} + {J_pair} / 2 = {va_pair}",
	"{v2a} = −{J} / 2 = {v2a_pair}",
	"{oa} = {o} − {jt} / r = {oan}",
	"{o2a} = −{jt} / r = {o2an}",
]
const _LEDGER: PackedStringArray = [
	"{t} = {t_pair}   {va} = {va_pair}   {oa} = {oan}",
	"E = |{v}|² / 2 + r² {o}² / 4 = {E}",
	"E′ = |{va}|² / 2 + r² {oa}² / 4 = {Ea}",
	"L = r {v} · {t} + r² {o} / 2 = {L}",
	"L′ = r {va} · {t} + r² {oa} / 2 = {La}",
]
const _LEDGER_OF_TWO: PackedStringArray = [
	"{t} = {t_pair}   {va} = {va_pair}   {v2a} = {v2a_pair}",
	"{oa} = {oan}   {o2a} = {o2an}",
	"E = |{v}|² / 2 + r² {o}² / 4 = {E}",
	"E′ = (|{va}|² + |{v2a}|²) / 2 + r² ({oa}² + {o2a}²) / 4 = {Ea}",
	"L = r {v} · {t} + r² {o} / 2 = {L}",
	"L′ = r ({va} − {v2a}) · {t} + r² ({oa} + {o2a}) / 2 = {La}",
]
const _FLIGHT: PackedStringArray = [
	"{n} = {n_pair}   {va} = {va_pair}",
	"T = {T}   c = r {n} = {c_pair}",
	"P = c + T {va} = {c_pair} + {Tn}·{va_pair} = {P_pair}",
]
const _FALL := "P = c + T {va} + (0, g T² / 2) = {P_pair}"
const _FLIGHT_OF_TWO: PackedStringArray = [
	"{n} = {n_pair}   {v2a} = {v2a_pair}",
	"T = {T}   c₂ = −r {n} = {c_pair}",
	"P = c₂ + T {v2a} = {c_pair} + {Tn}·{v2a_pair} = {P_pair}",
]

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of [param step] with the numbers of [param model].
func show_model(
	model: CollisionFrictionModel, contact: FrictionContact, flight: ContactFlight, step: int
) -> void:
	_put_given(model)
	_put_symbols(contact)
	_put_parts(contact)
	_put_impulses(contact)
	_put_leaving(contact)
	_put_ledger(contact)
	_put_flight(contact, flight)
	_formula.show_lines(_lines(model, contact, step))


static func _lines(
	model: CollisionFrictionModel, contact: FrictionContact, step: int
) -> PackedStringArray:
	var found: PackedStringArray = [_VELOCITY, _line_of_surface(model)]
	match step:
		CollisionFrictionModel.Step.SLIP:
			found.append_array(["{t} = {t_pair}", _ALONG, _SLIP])
		CollisionFrictionModel.Step.PUSH:
			found.append_array(["{n} = {n_pair}", _CLOSING, _PUSH])
		CollisionFrictionModel.Step.CONE:
			found.append_array(_lines_on_cone(contact))
		CollisionFrictionModel.Step.AFTER:
			found.append_array(_AFTER_OF_TWO if model.two_balls else _AFTER)
		CollisionFrictionModel.Step.LEDGER:
			found.append_array(_LEDGER_OF_TWO if model.two_balls else _LEDGER)
		CollisionFrictionModel.Step.FLY:
			found.append_array(_FLIGHT_OF_TWO if model.two_balls else _FLIGHT)
			if model.pull().y > 0.0:
				found[-1] = _FALL
	return found


# Where friction is switched off, µ cannot be typed.
static func _line_of_surface(model: CollisionFrictionModel) -> String:
	var line := (
		"µ = {friction}   C = {bounciness}" if model.has_friction else "µ = {mu}   C = {bounciness}"
	)
	return line if model.two_balls else line + "   g = {gravity}"


static func _lines_on_cone(contact: FrictionContact) -> PackedStringArray:
	var found: PackedStringArray = [_AXES, "{u} = {slip}   {jn} = {push}"]
	if contact.friction == 0.0:
		found.append("{jt} = −µ {jn} = {grip}")
	elif contact.regime() == Friction.Regime.STICK:
		found.append_array([_STICKS, "{jt} = −{u} / 3 = {grip}"])
	elif contact.slip() > 0.0:
		found.append_array([_SLIPS, "{jt} = −µ {jn} = {grip}"])
	else:
		found.append_array([_SLIPS, "{jt} = µ {jn} = {grip}"])
	found.append(_IMPULSE)
	return found


# Each of these has its counterpart in CollisionFrictionModel.enter.
func _put_given(model: CollisionFrictionModel) -> void:
	_formula.put_number("vx", model.velocity.x, Palette.Role.A, tr("x of v"))
	_formula.put_number("vy", model.velocity.y, Palette.Role.A, tr("y of v"))
	_formula.put_number("spin", model.spin, Palette.Role.INK, tr("spin of the ball"))
	_formula.put_number("radius", model.radius, Palette.Role.INK, tr("radius of the ball"))
	_formula.put_number("friction", model.friction, Palette.Role.REST, tr("friction"))
	_formula.put_number("mu", 0.0, Palette.Role.REST)
	_formula.put_number("bounciness", model.bounciness, Palette.Role.PROJECTION, tr("bounciness"))
	_formula.put_number("gravity", model.gravity, Palette.Role.INK, tr("gravity"))


func _put_symbols(contact: FrictionContact) -> void:
	var first := "₁" if contact.other else ""
	_formula.put_symbol("v", "v" + first, Palette.Role.A)
	_formula.put_symbol("va", "v%s′" % first, Palette.Role.A)
	_formula.put_symbol("v2a", "v₂′", Palette.Role.B)
	_formula.put_symbol("o", "ω" + first, Palette.Role.INK)
	_formula.put_symbol("oa", "ω%s′" % first, Palette.Role.INK)
	_formula.put_symbol("o2a", "ω₂′", Palette.Role.INK)
	_formula.put_symbol("t", "t", Palette.Role.QUIET)
	_formula.put_symbol("n", "n", Palette.Role.QUIET)
	_formula.put_symbol("u", "u", Palette.Role.UNIT)
	_formula.put_symbol("jn", "jn", Palette.Role.PROJECTION)
	_formula.put_symbol("jt", "jt", Palette.Role.REST)
	_formula.put_symbol("J", "J", Palette.Role.REST)


func _put_parts(contact: FrictionContact) -> void:
	var velocity := contact.ball.velocity
	var speed := velocity.length()
	var rim := absf(contact.ball.radius * contact.ball.spin)
	_formula.put_number("vxn", velocity.x, Palette.Role.A)
	_formula.put_number("vyn", velocity.y, Palette.Role.A)
	_formula.put_vector("v_pair", velocity, Palette.Role.A)
	for axis: Array in [["t", contact.tangent], ["n", contact.normal]]:
		var name_of_axis: String = axis[0]
		var vector: Vec2 = axis[1]
		_formula.put_number(name_of_axis + "x", vector.x, Palette.Role.QUIET)
		_formula.put_number(name_of_axis + "y", vector.y, Palette.Role.QUIET)
		_formula.put_vector(name_of_axis + "_pair", vector, Palette.Role.QUIET)
	_formula.put_sum("vt", contact.along_speed(), speed, Palette.Role.A)
	_formula.put_sum("vn", contact.normal_speed(), speed, Palette.Role.A)
	_formula.put_number("rn", contact.ball.radius, Palette.Role.INK)
	_formula.put_number("on", contact.ball.spin, Palette.Role.INK)
	_formula.put_sum("slip", contact.slip(), speed + rim, Palette.Role.UNIT)


func _put_impulses(contact: FrictionContact) -> void:
	var scale := contact.speed_scale()
	var push := contact.push()
	var grip := contact.grip()
	_formula.put_number("cn", contact.bounciness, Palette.Role.PROJECTION)
	_formula.put_number("push", push, Palette.Role.PROJECTION)
	_formula.put_sum("needed", absf(contact.slip()) / 3.0, scale, Palette.Role.UNIT)
	_formula.put_number("limit", contact.limit(), Palette.Role.REST)
	_formula.put_sum("grip", grip, scale, Palette.Role.REST)
	_formula.put_vector_sum(
		"J_pair", impulse_of(contact), Vec2.new(scale, scale), Palette.Role.REST
	)


## The whole impulse J = jn n + jt t of [param contact], per mass, in px/s.
static func impulse_of(contact: FrictionContact) -> Vec2:
	var along_normal := contact.normal.scaled(contact.push())
	return along_normal.plus(contact.tangent.scaled(contact.grip()))


func _put_leaving(contact: FrictionContact) -> void:
	var scale := contact.speed_scale()
	var sizes := Vec2.new(scale, scale)
	var rim := scale / contact.ball.radius
	var leaving := contact.after()
	_formula.put_vector_sum("va_pair", leaving[0].velocity, sizes, Palette.Role.A)
	_formula.put_sum("oan", leaving[0].spin, rim, Palette.Role.INK)
	if contact.other:
		_formula.put_vector_sum("v2a_pair", leaving[1].velocity, sizes, Palette.Role.B)
		_formula.put_sum("o2an", leaving[1].spin, rim, Palette.Role.INK)


func _put_ledger(contact: FrictionContact) -> void:
	var ink := Palette.Role.INK
	var size := contact.ball.radius * contact.speed_scale()
	var leaving := contact.after()
	_formula.put_number("E", FrictionContact.energy(contact.before()), ink)
	_formula.put_number("Ea", FrictionContact.energy(leaving), ink)
	_formula.put_sum("L", FrictionContact.angular_momentum(contact.before()), size, ink)
	_formula.put_sum("La", FrictionContact.angular_momentum(leaving), size, ink)


func _put_flight(contact: FrictionContact, flight: ContactFlight) -> void:
	var from := contact.after()[flight.compared_ball()].position
	var way := contact.speed_scale() * flight.compared_after
	var sizes := Vec2.new(absf(from.x) + way, absf(from.y) + way)
	_formula.put_number("T", flight.compared_after, Palette.Role.INK)
	_formula.put_number("Tn", flight.compared_after, Palette.Role.INK)
	_formula.put_vector("c_pair", from, Palette.Role.INK)
	_formula.put_vector_sum("P_pair", flight.place_by_formula(), sizes, Palette.Role.INK)
