class_name ReflectionFormula
extends RefCounted
## Puts the numbers of the lesson on reflection into its formula lines.

var _formula: Formula


## Says to [param formula] what the names in [ReflectionTexts] stand for.
func _init(formula: Formula) -> void:
	_formula = formula
	_formula.define_symbol("v", "v", Palette.Role.A)
	_formula.define_symbol("n", "n", Palette.Role.UNIT)
	_formula.define_number("vx", Palette.Role.A, tr("x of v"))
	_formula.define_number("vy", Palette.Role.A, tr("y of v"))
	_formula.define_number("lx", Palette.Role.INK, tr("x of the line"))
	_formula.define_number("ly", Palette.Role.INK, tr("y of the line"))
	_formula.define_number("C", Palette.Role.B, tr("bounciness C, 0 to 1"))
	_formula.define_number("n_length", Palette.Role.UNIT, tr("length of n"))
	for name_in_line: String in ["v_x", "v_y", "v_pair"]:
		_formula.define_number(name_in_line, Palette.Role.A)
	for name_in_line: String in ["n_x", "n_y", "n_pair"]:
		_formula.define_number(name_in_line, Palette.Role.UNIT)
	for name_in_line: String in ["mirror", "out"]:
		_formula.define_number(name_in_line, Palette.Role.B)
	_formula.define_number("dot", Palette.Role.INK)
	_formula.define_number("part", Palette.Role.PROJECTION)
	_formula.define_number("slide", Palette.Role.REST)


## Shows the lines of [param step] with the numbers of [param model].
func show_model(model: ReflectionModel, step: ReflectionModel.Step) -> void:
	_formula.show_lines(ReflectionTexts.lines(model, step))
	_put_what_is_typed(model)
	var normal := model.used_normal()
	_formula.set_vector("v_pair", model.velocity)
	_formula.set_number("v_x", model.velocity.x)
	_formula.set_number("v_y", model.velocity.y)
	_formula.set_vector("n_pair", normal)
	_formula.set_number("n_x", normal.x)
	_formula.set_number("n_y", normal.y)
	_formula.set_text("dot", NumberText.short(model.velocity.dot(normal)))
	_formula.set_vector("part", model.normal_part())
	_formula.set_vector("slide", model.velocity_after(1.0))
	_formula.set_vector("mirror", model.velocity_after(2.0))
	_formula.set_vector("out", model.velocity_after(1.0 + model.bounciness))


func _put_what_is_typed(model: ReflectionModel) -> void:
	_formula.set_number("vx", model.velocity.x)
	_formula.set_number("vy", model.velocity.y)
	_formula.set_number("lx", model.along.x)
	_formula.set_number("ly", model.along.y)
	_formula.set_number("C", model.bounciness)
	_formula.set_number("n_length", model.normal_length)
