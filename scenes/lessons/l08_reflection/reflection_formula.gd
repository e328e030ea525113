class_name ReflectionFormula
extends RefCounted
## The formula of the lesson on reflection: its lines, and what each name in them is.

const _BOUNCE := "{v} − (1 + C)({v} · {n}) {n} = {v_pair} − {times} {part} = {out}"

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of [param step] with the numbers of [param model].
func show_model(model: ReflectionModel, step: ReflectionModel.Step) -> void:
	_put_what_is_typed(model)
	_put_both_vectors(model.velocity, model.used_normal())
	_formula.put_symbol("n", model.normal_symbol(), Palette.Role.UNIT)
	_put_results(model)
	_formula.show_lines(_lines(model, step))


func _lines(model: ReflectionModel, step: ReflectionModel.Step) -> PackedStringArray:
	var found: PackedStringArray = [
		"{v} = ( {vx} , {vy} )     %s = ( {lx} , {ly} )" % tr("line"), _normal_line(model, step)
	]
	if model.refusal():
		found.append(tr("|{n}| is not 1: refused. {v} stays {v_pair}"))
		return found
	if step >= ReflectionModel.Step.SPLIT:
		found.append("{v} · {n} = {v_x}·{n_x} + {v_y}·{n_y} = {dot}")
		found.append("({v} · {n}) {n} = {dot} {n_pair} = {part}")
	match step:
		ReflectionModel.Step.NEXT_FRAME:
			found.append(_BOUNCE)
			var facing := "{n}" if model.faces_ball() else "(−{n})"
			found.append("{out} · " + facing + " = {out_x}·{m_x} + {out_y}·{m_y} = {out_dot}")
		ReflectionModel.Step.SLIDE:
			found.append("{v} − ({v} · {n}) {n} = {v_pair} − {part} = {slide}")
		ReflectionModel.Step.MIRROR:
			found.append("{v} − 2 ({v} · {n}) {n} = {v_pair} − 2 {part} = {mirror}")
		ReflectionModel.Step.BOUNCE:
			found.append(_BOUNCE)
	if model.mistake != 0:
		found.append("{wrong}: {wrong_pair}")
	return found


func _normal_line(model: ReflectionModel, step: ReflectionModel.Step) -> String:
	var line := "{n} = {n_pair}"
	if not model.has_unit_normal:
		line += "     |{n}| = {n_length}"
	# C comes with the last step; mistakes need it, too.
	if step >= ReflectionModel.Step.BOUNCE or model.mistake != 0:
		line += "     C = {C}"
	return line


# Each of these has its counterpart in ReflectionModel.enter.
func _put_what_is_typed(model: ReflectionModel) -> void:
	_formula.put_number("vx", model.velocity.x, Palette.Role.A, tr("x of v"))
	_formula.put_number("vy", model.velocity.y, Palette.Role.A, tr("y of v"))
	_formula.put_number("lx", model.along.x, Palette.Role.INK, tr("x of the line"))
	_formula.put_number("ly", model.along.y, Palette.Role.INK, tr("y of the line"))
	_formula.put_number("C", model.bounciness, Palette.Role.B, tr("bounciness C, 0 to 1"))
	_formula.put_number("n_length", model.normal_length, Palette.Role.UNIT, tr("length of n"))


func _put_both_vectors(velocity: Vec2, normal: Vec2) -> void:
	_formula.put_symbol("v", "v", Palette.Role.A)
	_formula.put_vector("v_pair", velocity, Palette.Role.A)
	_formula.put_number("v_x", velocity.x, Palette.Role.A)
	_formula.put_number("v_y", velocity.y, Palette.Role.A)
	_formula.put_vector("n_pair", normal, Palette.Role.UNIT)
	_formula.put_number("n_x", normal.x, Palette.Role.UNIT)
	_formula.put_number("n_y", normal.y, Palette.Role.UNIT)
	var scale := velocity.length() * normal.length()
	_formula.put_sum("dot", velocity.dot(normal), scale, Palette.Role.INK)


func _put_results(model: ReflectionModel) -> void:
	# Along the line, rounding is all that is left.
	var scale := model.velocity.length() if model.is_along_line() else 0.0
	var scales := Vec2.new(scale, scale)
	_formula.put_vector_sum("part", model.normal_part(), scales, Palette.Role.PROJECTION)
	_formula.put_vector("slide", model.velocity_after(1.0), Palette.Role.REST)
	_formula.put_vector("mirror", model.velocity_after(2.0), Palette.Role.B)
	_formula.put_vector("out", model.velocity_after(1.0 + model.bounciness), Palette.Role.B)
	_put_next_frame(model)
	_formula.put_number("times", 1.0 + model.bounciness, Palette.Role.INK)
	_formula.put_symbol("wrong", tr("mistake"), Palette.Role.WRONG)
	_formula.put_vector("wrong_pair", model.velocity_with_mistake(), Palette.Role.WRONG)


# Of the next frame: what moves, and the normal on the ball's side.
func _put_next_frame(model: ReflectionModel) -> void:
	var out := model.velocity_out()
	var normal := model.facing_normal()
	_formula.put_number("out_x", out.x, Palette.Role.B)
	_formula.put_number("out_y", out.y, Palette.Role.B)
	_formula.put_number("m_x", normal.x, Palette.Role.UNIT)
	_formula.put_number("m_y", normal.y, Palette.Role.UNIT)
	# What is shorter than v by far may still be more than rounding: its own terms say.
	var scale := absf(out.x * normal.x) + absf(out.y * normal.y)
	_formula.put_sum("out_dot", out.dot(normal), scale, Palette.Role.INK)
