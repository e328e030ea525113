class_name MovingPlatformsFormula
extends RefCounted
## The formula of the lesson on surfaces that move: its lines, and what each name in them is.

const _BALL := "P = ( {px} , {py} )   {v} = ( {vx} , {vy} )"
const _ENDS := "A = ( {ax} , {ay} )   B = ( {bx} , {by} )"
const _WALL := "{w} = ( {wx} , {wy} )   C = {bounciness}"
const _PADDLE := "ω = {turning}   C = {bounciness}"
# Without the places, from where they no longer matter.
const _VELOCITIES := "{v} = ( {vx} , {vy} )   {w} = ( {wx} , {wy} )"
const _VELOCITY := "{v} = ( {vx} , {vy} )   ω = {turning}"
const _BELT := "{v} = {speed}   {s} = {surface_speed}   µ = {friction}"
const _PLATFORM := "{V} = {surface_speed}   h = {way}   µ = {friction}"
const _PRESS := "h₀ = {way}   {u0} = {speed}   {V} = {surface_speed}"

const _ARM: PackedStringArray = [
	"r = {arm}   {w} = ω (−r.y, r.x) = {w_pair}",
]
const _SEEN := "{U} = {v} − {w} = {v_pair} − {w_pair} = {U_pair}"
const _BOUNCE: PackedStringArray = [
	"C = {bounciness}   n = {n_pair}   {U} · n = {U_n}",
	"{Ub} = {U} − (1 + C) ({U} · n) n = {Ub_pair}",
]
const _BACK := "{va} = {Ub} + {w} = {Ub_pair} + {w_pair} = {va_pair}"

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of [param step] with the numbers of [param model].
func show_model(model: MovingPlatformsModel, step: MovingPlatformsModel.Step) -> void:
	_put_symbols()
	_put_what_is_typed(model)
	if model.is_carried():
		_put_carried(model)
	elif model.kind == MovingSurface.Kind.PRESS:
		_put_press(model)
	elif model.impact().hit:
		_put_impact(model)
	_formula.show_lines(_given(model, step) + _lines(model, step))


static func _given(
	model: MovingPlatformsModel, step: MovingPlatformsModel.Step
) -> PackedStringArray:
	var is_first := step == MovingPlatformsModel.Step.WATCH or not _is_known(model)
	match model.kind:
		MovingSurface.Kind.BELT:
			return [_ENDS, _BELT] if is_first else [_BELT]
		MovingSurface.Kind.PLATFORM:
			return [_PLATFORM]
		MovingSurface.Kind.PADDLE:
			return [_BALL, _ENDS, _PADDLE] if is_first else [_VELOCITY]
		MovingSurface.Kind.PRESS:
			return [_PRESS]
	return [_BALL, _ENDS, _WALL] if is_first else [_VELOCITIES]


static func _is_known(model: MovingPlatformsModel) -> bool:
	return model.is_carried() or model.impact().hit


func _lines(model: MovingPlatformsModel, step: MovingPlatformsModel.Step) -> PackedStringArray:
	match model.kind:
		MovingSurface.Kind.BELT:
			return _lines_on_belt(model, step)
		MovingSurface.Kind.PLATFORM:
			return _lines_on_platform(model, step)
		MovingSurface.Kind.PRESS:
			return _lines_on_press(model, step)
	if not model.impact().hit:
		return [tr("no impact")]
	return _lines_on_impact(model, step)


static func _lines_on_impact(
	model: MovingPlatformsModel, step: MovingPlatformsModel.Step
) -> PackedStringArray:
	var found: PackedStringArray = []
	match step:
		MovingPlatformsModel.Step.FRAME:
			if model.kind == MovingSurface.Kind.PADDLE:
				found.append_array(_ARM)
			found.append(_SEEN)
		MovingPlatformsModel.Step.LAW:
			found = ["{U} = {U_pair}"]
			found.append_array(_BOUNCE)
		MovingPlatformsModel.Step.BACK:
			found = [_BACK]
		MovingPlatformsModel.Step.FLY:
			found = ["{va} = {va_pair}"]
	if model.mistake_shows() and step >= MovingPlatformsModel.Step.BACK:
		found.append("{wrong}: {wrong_pair}")
	return found


static func _lines_on_belt(
	model: MovingPlatformsModel, step: MovingPlatformsModel.Step
) -> PackedStringArray:
	var run := model.run()
	var found: PackedStringArray = []
	match step:
		MovingPlatformsModel.Step.FRAME:
			found = ["{u} = {v} − {s} = {v_value} − {s_value} = {u_value}"]
		MovingPlatformsModel.Step.LAW:
			found = [
				"G = {pull}   N = {pressure}",
				"{f} = µ N = {mu}·{pressure} = {grip}",
			]
		MovingPlatformsModel.Step.BACK:
			if run.run_case == CarriedRun.Case.ROLLS_LATER:
				found = _lines_on_rolling(run)
		MovingPlatformsModel.Step.FLY:
			if run.rolls():
				found = ["{va} = {va_value}"]
	if model.mistake_shows() and step >= MovingPlatformsModel.Step.BACK:
		found.append("{wrong}: {wrong_speed}")
	return found


# While it slips, f works against u: it points to the end where u is below 0.
static func _lines_on_rolling(run: CarriedRun) -> PackedStringArray:
	if run.pull() == 0.0:
		return [
			"{f} = {grip}   {u} = {u_value}",
			"t = |{u}| / (3 {f}) = {u_size} / {three_grips} = {t}",
			"{va} = {v} − {u} / 3 = {v_value} − {u_third} = {va_value}",
		]
	var way := "−" if run.slip > 0.0 else "+"
	return [
		"{f} = {grip}   G = {pull}   {u} = {u_value}",
		"t = |{u}| / (3 {f} %s G) = {u_size} / {fading} = {t}" % way,
		"{va} = {v} + (G %s {f}) t = {v_value} + {slipping}·{t} = {va_value}" % way,
	]


static func _lines_on_platform(
	model: MovingPlatformsModel, step: MovingPlatformsModel.Step
) -> PackedStringArray:
	var found: PackedStringArray = []
	match step:
		MovingPlatformsModel.Step.WATCH:
			found = ["T = h / {V} = {h_value} / {s_value} = {turn_time}"]
		MovingPlatformsModel.Step.FRAME:
			found = ["{u} = {V} − (−{V}) = {s_value} + {s_value} = {u_value}"]
		MovingPlatformsModel.Step.LAW:
			found = ["N = {pressure}", "{f} = µ N = {mu}·{pressure} = {grip}"]
		MovingPlatformsModel.Step.FLY when model.run().rolls():
			found = ["{va} = {va_value}"]
		MovingPlatformsModel.Step.BACK:
			if model.run().rolls():
				found = [
					"{f} = {grip}   {u} = {u_value}",
					"t = {u} / (3 {f}) = {u_value} / {three_grips} = {t}",
					"{va} = {V} − {u} / 3 = {s_value} − {u_third} = {va_value}",
				]
	if model.mistake == MovingPlatformsMistakes.BELT_SPEED and model.mistake_shows():
		if step >= MovingPlatformsModel.Step.BACK:
			found.append("{wrong}: {wrong_speed}")
	return found


static func _lines_on_press(
	model: MovingPlatformsModel, step: MovingPlatformsModel.Step
) -> PackedStringArray:
	var found: PackedStringArray = []
	match step:
		MovingPlatformsModel.Step.FRAME:
			found = ["{U} = {u0} + {V} = {u0_value} + {s_value} = {U_value}"]
		MovingPlatformsModel.Step.LAW:
			found = [
				"{U} = {U_value}",
				"u₁ = {U} + {V} = {U_value} + {s_value} = {u1}",
			]
		MovingPlatformsModel.Step.BACK:
			found = [
				"u₃ = {u0} + 3·2 {V} = {u0_value} + {six_V} = {u3}",
				"h₃ = h₀ ({u0} − {V}) / (u₃ − {V}) = {h_value}·{d0} / {d3} = {h3}",
			]
		MovingPlatformsModel.Step.FLY:
			found = ["T = h₀ / {V} = {h_value} / {s_value} = {turn_time}"]
	if model.mistake_shows() and step == MovingPlatformsModel.Step.BACK:
		found.append("{wrong}: {wrong_speed}")
	return found


func _put_symbols() -> void:
	_formula.put_symbol("v", "v", Palette.Role.A)
	_formula.put_symbol("u0", "u₀", Palette.Role.A)
	_formula.put_symbol("w", "w", Palette.Role.B)
	_formula.put_symbol("s", "s", Palette.Role.B)
	_formula.put_symbol("V", "V", Palette.Role.B)
	_formula.put_symbol("U", "U", Palette.Role.REST)
	_formula.put_symbol("u", "u", Palette.Role.REST)
	_formula.put_symbol("Ub", "U′", Palette.Role.REST)
	_formula.put_symbol("f", "f", Palette.Role.UNIT)
	_formula.put_symbol("va", "v′", Palette.Role.PROJECTION)
	_formula.put_symbol("wrong", tr("mistake"), Palette.Role.WRONG)


# Each of these has its counterpart in MovingPlatformsModel.enter.
func _put_what_is_typed(model: MovingPlatformsModel) -> void:
	var ink := Palette.Role.INK
	_formula.put_number("px", model.ball.x, ink, tr("x of the ball"))
	_formula.put_number("py", model.ball.y, ink, tr("y of the ball"))
	_formula.put_number("vx", model.velocity.x, Palette.Role.A, tr("x of v"))
	_formula.put_number("vy", model.velocity.y, Palette.Role.A, tr("y of v"))
	_formula.put_number("ax", model.surface_start.x, ink, tr("x of the start"))
	_formula.put_number("ay", model.surface_start.y, ink, tr("y of the start"))
	_formula.put_number("bx", model.surface_end.x, ink, tr("x of the end"))
	_formula.put_number("by", model.surface_end.y, ink, tr("y of the end"))
	_formula.put_number("wx", model.surface_velocity.x, Palette.Role.B, tr("x of w"))
	_formula.put_number("wy", model.surface_velocity.y, Palette.Role.B, tr("y of w"))
	_formula.put_number("turning", model.turning, Palette.Role.B, tr("turn ω, in radians a second"))
	_formula.put_number("bounciness", model.bounciness, ink, tr("bounciness C"))
	_formula.put_number("speed", model.speed, Palette.Role.A, tr("speed at the start"))
	_formula.put_number(
		"surface_speed", model.surface_speed, Palette.Role.B, tr("speed of the surface")
	)
	_formula.put_number("friction", model.friction, Palette.Role.UNIT, tr("friction"))
	_formula.put_number("way", model.way, ink, tr("way"))


func _put_impact(model: MovingPlatformsModel) -> void:
	var met := model.impact()
	var rest := Palette.Role.REST
	var size := met.coming.length() + met.touched.length()
	var twice := size + met.seen.length()
	_formula.put_vector("v_pair", met.coming, Palette.Role.A)
	_put_sum("arm", met.arm, model.moving().reach() + met.center.length(), Palette.Role.INK)
	var reach := absf(model.turning) * (model.moving().reach() + met.center.length())
	_put_sum("w_pair", met.touched, met.touched.length() + reach, Palette.Role.B)
	_put_sum("U_pair", met.seen, size, rest)
	_formula.put_vector("n_pair", MovingPlatformsTexts.cleaned(met.normal, 1.0), Palette.Role.INK)
	_formula.put_sum("U_n", met.seen.dot(met.normal), size, rest)
	_put_sum("Ub_pair", met.bounced, twice, rest)
	_put_sum("va_pair", met.leaving, twice + met.touched.length(), Palette.Role.PROJECTION)
	if model.mistake_shows():
		_put_sum("wrong_pair", model.wrong_velocity(), 2.0 * twice, Palette.Role.WRONG)


func _put_carried(model: MovingPlatformsModel) -> void:
	var run := model.run()
	var rest := Palette.Role.REST
	var ink := Palette.Role.INK
	_formula.put_number("v_value", model.speed, Palette.Role.A)
	_formula.put_number("s_value", model.surface_speed, Palette.Role.B)
	_formula.put_number("u_value", run.slip, rest)
	_formula.put_number("u_size", absf(run.slip), rest)
	_formula.put_number("u_third", run.slip / 3.0, rest)
	_formula.put_number("pull", run.pull(), ink)
	_formula.put_number("pressure", run.pressure(), ink)
	_formula.put_number("mu", model.friction, Palette.Role.UNIT)
	_formula.put_number("grip", run.grip(), Palette.Role.UNIT)
	_formula.put_number("three_grips", 3.0 * run.grip(), Palette.Role.UNIT)
	_formula.put_number("fading", run.fading(), ink)
	_formula.put_sum("slipping", run.slipping_acceleration(), run.grip() + absf(run.pull()), ink)
	_formula.put_number("h_value", model.way, ink)
	_formula.put_number("t", run.roll_time, ink)
	var size := absf(model.speed) + absf(model.surface_speed) + absf(run.slip)
	if run.rolls():
		_formula.put_sum("va_value", model.rolling_speed(), size, Palette.Role.PROJECTION)
	if model.kind == MovingSurface.Kind.PLATFORM:
		_formula.put_number("turn_time", model.turn_time(), ink)
	if model.mistake_shows():
		_formula.put_number("wrong_speed", model.wrong_speed(), Palette.Role.WRONG)


func _put_press(model: MovingPlatformsModel) -> void:
	var rest := Palette.Role.REST
	var blue := Palette.Role.PROJECTION
	var u3 := Press.speed_after(3.0, model.speed, model.surface_speed)
	_formula.put_number("u0_value", model.speed, Palette.Role.A)
	_formula.put_number("s_value", model.surface_speed, Palette.Role.B)
	_formula.put_number("U_value", model.speed + model.surface_speed, rest)
	_formula.put_number("six_V", 6.0 * model.surface_speed, Palette.Role.B)
	_formula.put_number("u1", model.speed + 2.0 * model.surface_speed, blue)
	_formula.put_number("u3", u3, blue)
	_formula.put_number("h_value", model.way, Palette.Role.INK)
	_formula.put_number("d0", model.speed - model.surface_speed, Palette.Role.INK)
	_formula.put_number("d3", u3 - model.surface_speed, Palette.Role.INK)
	var h3 := Press.way_after(3.0, model.way, model.speed, model.surface_speed)
	_formula.put_number("h3", h3, blue)
	_formula.put_number("turn_time", model.crush_time(), Palette.Role.INK)
	if model.mistake_shows():
		_formula.put_number("wrong_speed", model.wrong_speed(), Palette.Role.WRONG)


func _put_sum(name_in_line: String, sum: Vec2, size: float, role: Palette.Role) -> void:
	_formula.put_vector_sum(name_in_line, sum, Vec2.new(size, size), role)
