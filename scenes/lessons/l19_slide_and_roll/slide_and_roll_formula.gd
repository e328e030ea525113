class_name SlideAndRollFormula
extends RefCounted
## The formula of the lesson on sliding and rolling: its lines, and what each name in them is.

const _PLACES := "A = ( {Ax} , {Ay} )   B = ( {Bx} , {By} )"
const _SIZES := "w = {w}   h = {h}   L = √(w² + h²) = {L}"
const _PULL: PackedStringArray = [
	"{G} = g h / L = {g}·{h} / {L} = {pull}",
	"{N} = g w / L = {g}·{w} / {L} = {pressure}",
]
const _SHORT_PULL := "{G} = {pull}   {N} = {pressure}"
const _SLIP: PackedStringArray = [
	"{f} ≤ µ {N} = {mu}·{pressure} = {grip}",
	"{G} − 3 µ {N} = {pull} − 3·{grip} = {growth}",
]

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of [param step] with the numbers of [param model].
func show_model(model: SlideAndRollModel, race: BallRace, step: int) -> void:
	_put_given(model)
	_put_forces(model, race)
	_formula.show_lines(_lines(model, race, step))


func _lines(model: SlideAndRollModel, race: BallRace, step: int) -> PackedStringArray:
	var found: PackedStringArray = [_PLACES, "g = {gravity}   v₀ = {speed}   r = {radius}"]
	if step >= SlideAndRollModel.Step.SLIP:
		found[1] = "µ = {friction}   " + found[1]
	if step == SlideAndRollModel.Step.PULL:
		found.append(_SIZES)
		found.append_array(_PULL)
	elif step > SlideAndRollModel.Step.PULL:
		found.append(_SHORT_PULL)
	match step:
		SlideAndRollModel.Step.SLIP:
			found.append_array(_SLIP)
		SlideAndRollModel.Step.MARK:
			found.append("w = {w}   h = {h}")
			found.append("tan = h / w = {h} / {w} = {tan}   tan / 3 = {mark}")
			found.append(_line_on_mark(model))
		SlideAndRollModel.Step.ROLL:
			found.append_array(_lines_on_roll(race))
	if step >= SlideAndRollModel.Step.RACE:
		found.append_array(_lines_on_race(model, race))
	return found


# With the numbers that decide: on a slope of 3 to 4 the mark itself is rounded to a short number.
static func _line_on_mark(model: SlideAndRollModel) -> String:
	if model.incline(model.friction).can_hold():
		return "3 µ {N} = {three_grips} ≥ {pull} = {G}"
	return "3 µ {N} = {three_grips} < {pull} = {G}"


static func _lines_on_roll(race: BallRace) -> PackedStringArray:
	match race.run_case:
		SlideAndRollModel.Case.RESTS:
			return ["{a} = 0"]
		SlideAndRollModel.Case.ROLLS:
			return [
				"{f} = {G} / 3 = {pull} / 3 = {third}",
				"{a} = {G} − {f} = {pull} − {third} = {two_thirds}"
			]
		SlideAndRollModel.Case.ROLLS_LATER:
			return [
				"t₁ = v₀ / (3 µ {N} − {G}) = {v0} / ({three_grips} − {pull}) = {t1}",
				"v₁ = v₀ + ({G} − µ {N}) t₁ = {v1}",
				"{a} = 2 {G} / 3 = 2·{pull} / 3 = {two_thirds}",
			]
	return ["{f} = µ {N} = {grip}", "{a} = {G} − {f} = {pull} − {grip} = {slips}"]


static func _lines_on_race(model: SlideAndRollModel, race: BallRace) -> PackedStringArray:
	if race.run_case == SlideAndRollModel.Case.RESTS or not race.arrives():
		return []
	if model.speed > 0.0:
		return ["t = {t_end}   v = {v_end}"]
	return [
		"L = {L}   {a} = {last}",
		"t = √(2 L / {a}) = √(2·{L} / {last}) = {t_end}",
		"{slides}: t₀ = √(2 L / {G}) = {t_slide}",
	]


# Each of these has its counterpart in SlideAndRollModel.enter.
func _put_given(model: SlideAndRollModel) -> void:
	_formula.put_number("Ax", model.start.x, Palette.Role.INK, tr("x of the start"))
	_formula.put_number("Ay", model.start.y, Palette.Role.INK, tr("y of the start"))
	_formula.put_number("Bx", model.end.x, Palette.Role.INK, tr("x of the end"))
	_formula.put_number("By", model.end.y, Palette.Role.INK, tr("y of the end"))
	_formula.put_number("gravity", model.gravity, Palette.Role.B, tr("gravity"))
	_formula.put_number("speed", model.speed, Palette.Role.UNIT, tr("speed at the start"))
	_formula.put_number("radius", model.radius, Palette.Role.INK, tr("radius of the ball"))
	_formula.put_number("friction", model.friction, Palette.Role.REST, tr("friction"))


func _put_forces(model: SlideAndRollModel, race: BallRace) -> void:
	var incline := model.incline(model.friction)
	var grip := model.friction * incline.pressure
	var green := Palette.Role.A
	var blue := Palette.Role.PROJECTION
	var purple := Palette.Role.REST
	_formula.put_symbol("G", "G", green)
	_formula.put_symbol("N", "N", blue)
	_formula.put_symbol("f", "f", purple)
	_formula.put_symbol("a", "a", Palette.Role.INK)
	_formula.put_symbol("slides", tr("without friction"), Palette.Role.QUIET)
	_formula.put_number("w", model.width(), Palette.Role.INK)
	_formula.put_number("h", model.height(), Palette.Role.INK)
	_formula.put_number("L", incline.length, Palette.Role.INK)
	_formula.put_number("g", model.gravity, Palette.Role.B)
	_formula.put_number("mu", model.friction, purple)
	_formula.put_number("v0", model.speed, Palette.Role.UNIT)
	_formula.put_number("pull", incline.pull, green)
	_formula.put_number("pressure", incline.pressure, blue)
	_formula.put_number("grip", grip, purple)
	_formula.put_number("three_grips", 3.0 * grip, purple)
	_formula.put_sum("growth", model.slip_growth(), incline.pull + 3.0 * grip, Palette.Role.INK)
	_formula.put_number("tan", model.slope(), Palette.Role.INK)
	_formula.put_number("mark", model.mark(), Palette.Role.INK)
	_formula.put_number("third", incline.pull / 3.0, purple)
	_formula.put_number("two_thirds", 2.0 * incline.pull / 3.0, Palette.Role.INK)
	_formula.put_sum("slips", incline.pull - grip, incline.pull + grip, Palette.Role.INK)
	_formula.put_number("last", model.last_acceleration(race.run_case), Palette.Role.INK)
	if race.ball.roll_time > 0.0:
		_formula.put_number("t1", race.ball.roll_time, Palette.Role.INK)
		_formula.put_number("v1", race.ball.after(race.ball.roll_time).speed, Palette.Role.INK)
	if race.arrives():
		_formula.put_number("t_end", race.ball.end_time, Palette.Role.INK)
		_formula.put_number("v_end", race.ball.end_speed, Palette.Role.INK)
	if race.sliding.end_time < INF:
		_formula.put_number("t_slide", race.sliding.end_time, Palette.Role.QUIET)
