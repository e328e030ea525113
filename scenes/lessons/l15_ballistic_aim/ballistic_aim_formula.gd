class_name BallisticAimFormula
extends RefCounted
## The formula of the lesson on aiming under gravity: its lines, and what each name in them is.

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of [param step] with the numbers of [param model].
func show_model(model: BallisticAimModel, step: BallisticAimModel.Step) -> void:
	_put_what_is_typed(model)
	_put_known(model)
	_put_quadratic(model)
	for place in model.shots().size():
		_put_shot(model, place)
	_put_least(model)
	_formula.show_lines(_lines(model, step))


func _lines(model: BallisticAimModel, step: BallisticAimModel.Step) -> PackedStringArray:
	var found: PackedStringArray = ["{P} = ( {x} , {y} )   {s_} = {s}   {g_} = {g}"]
	if model.moves:
		found.append("{V} = ( {vx} , {vy} )")
	if model.target.length() == 0.0:
		return found
	match step:
		BallisticAimModel.Step.STRAIGHT:
			found.append_array(_straight_lines())
		BallisticAimModel.Step.DROP:
			found.append_array(_straight_lines())
			found.append("{g_} t² / 2 = {g_value}·{t0}² / 2 = {drop}")
		BallisticAimModel.Step.TIMES:
			found.append_array(_time_lines(model))
		BallisticAimModel.Step.LEAST:
			found.append_array(_least_lines(model))
		_:
			found.append_array(_aim_lines(model))
	if model.mistake != 0 and BallisticAimModel.is_of_arcs(step):
		found.append(_wrong_line(model))
	return found


func _straight_lines() -> PackedStringArray:
	return [
		"|{P}| = √({x_value}² + {y_value}²) = {length}",
		"t = |{P}| / {s_} = {length} / {s_value} = {t0}",
	]


func _time_lines(model: BallisticAimModel) -> PackedStringArray:
	if not model.is_fixed():
		return ["{D}(t) = " + _way_in_words(model), _all_times(model)]
	var found: PackedStringArray = [
		"b = {s_}² + {g_} {P}.y = {s_value}² + {g_value}·{y_value} = {b}",
		"|{P}| = {length}     {g_} |{P}| = {g_value}·{length} = {pulled}",
		"w = (b − {g_} |{P}|) (b + {g_} |{P}|) = ({b} − {pulled}) ({b} + {pulled}) = {w}",
	]
	if not model.has_shot():
		found.append(tr("w has no root: no t"))
		return found
	found.append("{t1} = |{P}| √(2 / (b + √w)) = {length} √(2 / ({b} + {root})) = {time1}")
	if model.shots().size() > 1:
		found.append("{t2} = √(2 (b + √w)) / {g_} = √(2·({b} + {root})) / {g_value} = {time2}")
	return found


static func _way_in_words(model: BallisticAimModel) -> String:
	var words := "{P}"
	if model.moves:
		words += " + {V} t"
	if not model.falls and model.gravity > 0.0:
		words += " − (0, {g_} t² / 2)"
	return words


func _all_times(model: BallisticAimModel) -> String:
	var found: PackedStringArray = []
	for place in model.shots().size():
		found.append("{t%d} = {time%d}" % [place + 1, place + 1])
	return "     ".join(found) if found else tr("no t")


# Of the aim that is flown.
func _aim_lines(model: BallisticAimModel) -> PackedStringArray:
	if not model.has_shot():
		return [tr("no direction")]
	var way := "{P_pair}"
	if model.moves:
		way += " + {time} {V_pair}"
	if not model.falls and model.gravity > 0.0:
		way += " − (0, {g_value}·{time}² / 2)"
	var found: PackedStringArray = [_all_times(model)]
	var is_copy := way == "{P_pair}"
	found.append("{Dn} = {D_pair}" if is_copy else "{Dn} = %s = {D_pair}" % way)
	found.append(
		"|{Dn}| = {s_} {tn} = {s_value}·{time} = {reach}     {dn} = {Dn} / |{Dn}| = {d_pair}"
	)
	for i in found.size():
		found[i] = _with_number(found[i], model.arc_flown())
	return found


static func _with_number(line: String, place: int) -> String:
	var number := str(place + 1)
	for name_in_line: String in ["D", "d", "t"]:
		line = line.replace("{%sn}" % name_in_line, "{%s%s}" % [name_in_line, number])
	for name_in_line: String in ["{time", "{D_pair", "{reach", "{d_pair"]:
		line = line.replace(name_in_line + "}", name_in_line + number + "}")
	return line


func _least_lines(model: BallisticAimModel) -> PackedStringArray:
	if not model.is_fixed() or model.gravity == 0.0:
		return _aim_lines(model)
	var found: PackedStringArray = ["|{P}| = √({x_value}² + {y_value}²) = {length}"]
	if model.target.y > 0.0:
		# As BallisticAim computes it: the digits of the difference would cancel.
		found.append("|{P}| − {P}.y = {P}.x² / (|{P}| + {P}.y)")
		found.append(
			(
				"{s0}² = {g_} {P}.x² / (|{P}| + {P}.y) = "
				+ "{g_value}·{x_squared} / ({length} + {y_value}) = {least_squared}"
			)
		)
	else:
		found.append(
			"{s0}² = {g_} (|{P}| − {P}.y) = {g_value}·({length} − {y_value}) = {least_squared}"
		)
	found.append("{s0} = {least}")
	return found


func _wrong_line(model: BallisticAimModel) -> String:
	if not model.wrong_shot().hit:
		return "{wrong}: " + tr("no d")
	_formula.put_vector("wrong_d", model.wrong_shot().direction, Palette.Role.WRONG)
	return "{wrong}: d = {wrong_d}"


# Each of these has its counterpart in BallisticAimModel.enter.
func _put_what_is_typed(model: BallisticAimModel) -> void:
	_formula.put_number("x", model.target.x, Palette.Role.B, tr("x of the target"))
	_formula.put_number("y", model.target.y, Palette.Role.B, tr("y of the target"))
	_formula.put_number("vx", model.velocity.x, Palette.Role.B, tr("x of V"))
	_formula.put_number("vy", model.velocity.y, Palette.Role.B, tr("y of V"))
	_formula.put_number("s", model.speed, Palette.Role.A, tr("speed of the bullet"))
	_formula.put_number("g", model.gravity, Palette.Role.UNIT, tr("gravity"))


func _put_known(model: BallisticAimModel) -> void:
	_formula.put_symbol("P", "P", Palette.Role.B)
	_formula.put_symbol("V", "V", Palette.Role.B)
	_formula.put_symbol("s_", "s", Palette.Role.A)
	_formula.put_symbol("g_", "g", Palette.Role.UNIT)
	_formula.put_symbol("D", "D", Palette.Role.INK)
	_formula.put_symbol("wrong", tr("mistake"), Palette.Role.WRONG)
	_formula.put_vector("P_pair", model.target, Palette.Role.B)
	_formula.put_vector("V_pair", model.velocity, Palette.Role.B)
	_formula.put_number("x_value", model.target.x, Palette.Role.B)
	_formula.put_number("y_value", model.target.y, Palette.Role.B)
	_formula.put_number("s_value", model.speed, Palette.Role.A)
	_formula.put_number("g_value", model.gravity, Palette.Role.UNIT)
	_formula.put_number("length", model.target.length(), Palette.Role.B)
	_formula.put_number("t0", model.straight_time(), Palette.Role.INK)
	_formula.put_number("drop", model.fall_after(model.straight_time()), Palette.Role.UNIT)


func _put_quadratic(model: BallisticAimModel) -> void:
	var b := model.b()
	var terms := model.speed * model.speed + model.gravity * absf(model.target.y)
	_formula.put_sum("b", b, terms, Palette.Role.INK)
	_formula.put_sum("w", model.w(), terms * terms, Palette.Role.INK)
	_formula.put_number("pulled", model.gravity * model.target.length(), Palette.Role.INK)
	_formula.put_number("root", sqrt(maxf(model.w(), 0.0)), Palette.Role.INK)


func _put_shot(model: BallisticAimModel, place: int) -> void:
	var shot := model.shots()[place]
	var number := str(place + 1)
	var role := BallisticAimDrawing.ROLES[place]
	for symbol: String in ["t", "D", "d"]:
		_formula.put_symbol(symbol + number, symbol + BallisticAimTexts.SUBSCRIPTS[place], role)
	_formula.put_number("time" + number, shot.time, role)
	var moved := model.own_velocity().scaled(shot.time)
	var fall := 0.0 if model.falls else model.fall_after(shot.time)
	var aim := model.target.plus(moved).minus(Vec2.new(0.0, fall))
	var terms := Vec2.new(
		absf(model.target.x) + absf(moved.x), absf(model.target.y) + absf(moved.y) + fall
	)
	_formula.put_vector_sum("D_pair" + number, aim, terms, role)
	_formula.put_number("reach" + number, model.speed * shot.time, role)
	_formula.put_vector("d_pair" + number, shot.direction, role)


func _put_least(model: BallisticAimModel) -> void:
	var least := model.least_speed()
	_formula.put_symbol("s0", "s₀", Palette.Role.A)
	_formula.put_number("least", least, Palette.Role.A)
	_formula.put_number("x_squared", model.target.x * model.target.x, Palette.Role.B)
	_formula.put_number("least_squared", least * least, Palette.Role.A)
