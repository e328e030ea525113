class_name MoreDimensionsFormula
extends RefCounted
## Puts the numbers of the lesson on more dimensions into its formula lines.

var _formula: Formula


## Says to [param formula] what the names in [MoreDimensionsTexts] stand for.
func _init(formula: Formula) -> void:
	_formula = formula
	_formula.define_symbol("a", "a", Palette.Role.A)
	_formula.define_symbol("b", "b", Palette.Role.B)
	for i in MoreDimensionsModel.MOST:
		var place := i + 1
		_formula.define_number("a%d" % place, Palette.Role.A, tr("Component %d of a") % place)
		_formula.define_number("b%d" % place, Palette.Role.B, tr("Component %d of b") % place)
		_formula.define_number("pa%d" % place, Palette.Role.A)
		_formula.define_number("pb%d" % place, Palette.Role.B)
		_formula.define_number("p%d" % place, Palette.Role.PROJECTION)
	_formula.define_number("length_a", Palette.Role.A)
	_formula.define_number("length_b", Palette.Role.B)
	for number: String in ["dot", "sign", "cosine", "angle"]:
		_formula.define_number(number, Palette.Role.INK)


## Shows the lines up to [param step] with the numbers of [param model].
func show_model(model: MoreDimensionsModel, step: int) -> void:
	_formula.show_lines(MoreDimensionsTexts.lines(model, step))
	for i in model.dimension():
		var place := i + 1
		_formula.set_number("a%d" % place, model.a[i])
		_formula.set_number("b%d" % place, model.b[i])
		_formula.set_number("pa%d" % place, model.a[i])
		_formula.set_number("pb%d" % place, model.b[i])
		_formula.set_number("p%d" % place, model.products()[i])
	_formula.set_number("dot", model.dot())
	_formula.set_text("sign", MoreDimensionsTexts.comparison(model))
	_formula.set_number("length_a", model.length_of_a())
	_formula.set_number("length_b", model.length_of_b())
	_formula.set_number("cosine", model.cosine())
	_formula.set_text("angle", NumberText.short(model.angle_degrees()))
