class_name TimedShotFormula
extends RefCounted
## The formula of the lesson on the moment to fire: its lines, and what each name in them is.

const _PAIR := "{%s} = ( {%sx} , {%sy} )"

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of [param step] with the numbers of [param model].
func show_model(model: TimedShotModel, step: TimedShotModel.Step) -> void:
	_put_symbols()
	_put_what_is_typed(model)
	_put_line(model)
	_put_circle(model)
	_put_times(model)
	_formula.show_lines(_lines(model, step))


func _lines(model: TimedShotModel, step: TimedShotModel.Step) -> PackedStringArray:
	var moves := "C" if model.kind == TimedShotModel.Kind.CIRCLE else "V"
	var found: PackedStringArray = [_typed("S", "W"), _typed("T", moves)]
	match model.kind:
		TimedShotModel.Kind.CIRCLE:
			found.append(tr("turn") + " = {circling}°")
		TimedShotModel.Kind.TURNING:
			found.append(tr("turn") + " = {turning}°")
	if step == TimedShotModel.Step.CROSS:
		found.append_array(_crossing_lines(model))
	elif step == TimedShotModel.Step.WINDOW:
		found.append("R = {R}")
		if model.has_shot():
			found.append_array(_window_lines(model))
	elif step > TimedShotModel.Step.CROSS:
		found.append_array(_moment_lines(model))
	return found


# Two pairs that can be typed over.
static func _typed(first: String, second: String) -> String:
	var one := _PAIR % [first, first.to_lower(), first.to_lower()]
	return one + "   " + _PAIR % [second, second.to_lower(), second.to_lower()]


func _crossing_lines(model: TimedShotModel) -> PackedStringArray:
	match model.kind:
		TimedShotModel.Kind.CIRCLE:
			return _circle_lines(model)
		TimedShotModel.Kind.TURNING:
			return [tr("direction: d = (T + V t − S) / (s t)")]
	var found: PackedStringArray = [
		"P = {T} − {S} = {P_pair}     n = (−{V}.y, {V}.x) = {n_pair}",
		"P · n = {P_x}·{n_x} + {P_y}·{n_y} = {P_n}     {W} · n = {W_x}·{n_x} + {W_y}·{n_y} = {W_n}",
	]
	if model.bullet.dot(model.across()) == 0.0:
		found.append(tr("W · n is 0: no f"))
		return found
	found.append("f = P · n / ({W} · n) = {P_n} / {W_n} = {flight}")
	if model.flight() > 0.0:
		found.append("X = {S} + f {W} = {S_pair} + {flight} {W_pair} = {X_pair}")
	return found


func _circle_lines(model: TimedShotModel) -> PackedStringArray:
	var found: PackedStringArray = ["|{T} − {C}| = {rho}"]
	if model.flight() <= 0.0:
		found.append(tr("no f"))
		return found
	found.append("f = {flight}     X = {S} + f {W} = {S_pair} + {flight} {W_pair} = {X_pair}")
	found.append("|X − {C}| = {rho}")
	return found


func _moment_lines(model: TimedShotModel) -> PackedStringArray:
	if not model.has_shot():
		return [tr("no moment")]
	match model.kind:
		TimedShotModel.Kind.CIRCLE:
			return [
				tr("from T to X:") + " {gap}°",
				"{hit_symbol} = {gap_value} / {turn_value} = {hit}",
				_fire_line(model),
			]
		TimedShotModel.Kind.TURNING:
			return [
				"{fire_symbol} = {fire}     f = {flight}     {hit_symbol} = {fire} + {flight} = {hit}",
				"X = {T} + {hit_symbol} {V} = {T_pair} + {hit} {V_pair} = {X_pair}",
				tr("from S to X:") + " {aim}°     " + tr("barrel then:") + " {turned}°",
			]
	return [
		"X − {T} = {X_T}     (X − {T}) · {V} = {X_T_x}·{V_x} + {X_T_y}·{V_y} = {X_T_V}",
		"{hit_symbol} = (X − {T}) · {V} / ({V} · {V}) = {X_T_V} / {V_V} = {hit}",
		_fire_line(model),
	]


func _fire_line(model: TimedShotModel) -> String:
	var line := "{fire_symbol} = {hit_symbol} − f = {hit} − {flight} = {fire}"
	if model.mistake == TimedShotMistakes.FLIGHT_ADDED:
		line += "     {wrong}: {hit} + {flight} = {wrong_fire}"
	elif model.mistake == TimedShotMistakes.IN_FRONT:
		line += "     {wrong}: {hit}"
	return line


func _window_lines(model: TimedShotModel) -> PackedStringArray:
	if model.kind != TimedShotModel.Kind.LINE:
		return [tr("from {early} to {late}")]
	var found: PackedStringArray = [
		"{W} − {V} = {W_pair} − {V_pair} = {U_pair}     |{W} − {V}| = {closing}",
		"{half} = R |{W} − {V}| / |{W} · n| = {R_value}·{closing} / {W_n_size} = {half_value}",
	]
	if model.mistake == TimedShotMistakes.BULLET_FORGOTTEN:
		found.append("{wrong}: R / |{V}| = {R_value} / {V_size} = {wrong_half}")
	return found


func _put_symbols() -> void:
	_formula.put_symbol("S", "S", Palette.Role.INK)
	_formula.put_symbol("W", "W", Palette.Role.A)
	_formula.put_symbol("T", "T", Palette.Role.B)
	_formula.put_symbol("V", "V", Palette.Role.B)
	_formula.put_symbol("C", "C", Palette.Role.UNIT)
	_formula.put_symbol("hit_symbol", tr("hit"), Palette.Role.INK)
	_formula.put_symbol("fire_symbol", tr("fire"), Palette.Role.PROJECTION)
	_formula.put_symbol("half", tr("half"), Palette.Role.PROJECTION)
	_formula.put_symbol("wrong", tr("mistake"), Palette.Role.WRONG)


# Each of these has its counterpart in TimedShotModel.enter.
func _put_what_is_typed(model: TimedShotModel) -> void:
	_formula.put_number("sx", model.muzzle.x, Palette.Role.INK, tr("x of the muzzle"))
	_formula.put_number("sy", model.muzzle.y, Palette.Role.INK, tr("y of the muzzle"))
	_formula.put_number("wx", model.bullet.x, Palette.Role.A, tr("x of W"))
	_formula.put_number("wy", model.bullet.y, Palette.Role.A, tr("y of W"))
	_formula.put_number("tx", model.target.x, Palette.Role.B, tr("x of the target"))
	_formula.put_number("ty", model.target.y, Palette.Role.B, tr("y of the target"))
	_formula.put_number("vx", model.velocity.x, Palette.Role.B, tr("x of V"))
	_formula.put_number("vy", model.velocity.y, Palette.Role.B, tr("y of V"))
	_formula.put_number("cx", model.centre.x, Palette.Role.UNIT, tr("x of the circle's centre"))
	_formula.put_number("cy", model.centre.y, Palette.Role.UNIT, tr("y of the circle's centre"))
	_formula.put_number("R", model.radius, Palette.Role.UNIT, tr("radii of bullet and target"))
	var each_second := tr("turn in one second")
	_formula.put_angle("circling", model.circling, Palette.Role.UNIT, each_second)
	_formula.put_angle("turning", model.turning, Palette.Role.UNIT, each_second)


func _put_line(model: TimedShotModel) -> void:
	var way := model.target.minus(model.muzzle)
	var n := model.across()
	_formula.put_vector("S_pair", model.muzzle, Palette.Role.INK)
	_formula.put_vector("W_pair", model.bullet, Palette.Role.A)
	_formula.put_vector("T_pair", model.target, Palette.Role.B)
	_formula.put_vector("V_pair", model.velocity, Palette.Role.B)
	_formula.put_vector("P_pair", way, Palette.Role.INK)
	_formula.put_vector("n_pair", n, Palette.Role.UNIT)
	_put_components("P", way, Palette.Role.INK)
	_put_components("W", model.bullet, Palette.Role.A)
	_put_components("V", model.velocity, Palette.Role.B)
	_put_components("n", n, Palette.Role.UNIT)
	_formula.put_sum("P_n", way.dot(n), way.length() * n.length(), Palette.Role.INK)
	_formula.put_number("W_n", model.bullet.dot(n), Palette.Role.INK)
	_formula.put_number("W_n_size", absf(model.bullet.dot(n)), Palette.Role.INK)
	_formula.put_number("V_V", model.velocity.length_squared(), Palette.Role.B)
	_formula.put_number("V_size", model.velocity.length(), Palette.Role.B)
	var closing := model.bullet.distance_to(model.velocity)
	_formula.put_number("closing", closing, Palette.Role.INK)
	_formula.put_vector("U_pair", model.bullet.minus(model.velocity), Palette.Role.INK)
	_formula.put_number("R_value", model.radius, Palette.Role.UNIT)


func _put_circle(model: TimedShotModel) -> void:
	_formula.put_number("rho", model.circle_radius(), Palette.Role.UNIT)
	var turn := Conventions.shown(absf(model.circling))
	_formula.put_number("turn_value", turn, Palette.Role.UNIT)


func _put_times(model: TimedShotModel) -> void:
	var flight := model.flight()
	var blue := Palette.Role.PROJECTION
	_formula.put_number("flight", flight, Palette.Role.A)
	if flight > 0.0:
		var x := model.crossing()
		_formula.put_vector_sum("X_pair", x, _terms_of_crossing(model), Palette.Role.INK)
		_put_way_to_crossing(model, x.minus(model.target))
	if not model.has_shot():
		return
	var shot := model.shot()
	var hit := shot.fire + shot.flight
	if model.kind == TimedShotModel.Kind.TURNING:
		# Its line comes to X by the way of the target.
		_formula.put_vector("X_pair", model.target_after(hit), Palette.Role.INK)
	_formula.put_number("hit", hit, Palette.Role.INK)
	_formula.put_sum("fire", shot.fire, hit + flight, blue)
	var gap := absf(model.circling) * hit
	_formula.put_angle("gap", gap, Palette.Role.INK)
	_formula.put_number("gap_value", Conventions.shown(gap), Palette.Role.INK)
	_put_direction("aim", model.crossing().minus(model.muzzle), Palette.Role.INK)
	_put_direction("turned", model.bullet_velocity(shot.fire), Palette.Role.A)
	if model.mistake == TimedShotMistakes.FLIGHT_ADDED:
		_formula.put_number("wrong_fire", model.wrong_fire(), Palette.Role.WRONG)
	_formula.put_number("half_value", model.half_window(), blue)
	_formula.put_number("wrong_half", model.plain_half_window(), Palette.Role.WRONG)
	if model.kind != TimedShotModel.Kind.LINE:
		_formula.put_number("early", model.window()[0], blue)
		_formula.put_number("late", model.window()[1], blue)


func _put_components(name_in_line: String, vector: Vec2, role: Palette.Role) -> void:
	_formula.put_number(name_in_line + "_x", vector.x, role)
	_formula.put_number(name_in_line + "_y", vector.y, role)


func _put_direction(name_in_line: String, direction: Vec2, role: Palette.Role) -> void:
	var degrees := Conventions.in_range(Vec2.rad_to_deg(direction.angle_radians()))
	_formula.put_angle(name_in_line, degrees, role)


func _put_way_to_crossing(model: TimedShotModel, way: Vec2) -> void:
	var terms := way.length() * model.velocity.length()
	_formula.put_vector("X_T", way, Palette.Role.INK)
	_formula.put_number("X_T_x", way.x, Palette.Role.INK)
	_formula.put_number("X_T_y", way.y, Palette.Role.INK)
	_formula.put_sum("X_T_V", way.dot(model.velocity), terms, Palette.Role.INK)


# The sizes of all that is added up to X, by the way of the bullet or by that of the target.
static func _terms_of_crossing(model: TimedShotModel) -> Vec2:
	var flown := model.bullet.length() * model.flight()
	var moved := model.velocity.length() * absf(model.time_to_crossing())
	return Vec2.new(
		absf(model.muzzle.x) + absf(model.target.x) + flown + moved,
		absf(model.muzzle.y) + absf(model.target.y) + flown + moved
	)
