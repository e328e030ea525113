class_name NormalsFormula
extends RefCounted
## Puts the numbers of the lesson on normals into its formula lines.

var _formula: Formula


## Says to [param formula] what the names in [NormalsTexts] stand for.
func _init(formula: Formula) -> void:
	_formula = formula
	_formula.define_symbol("v", "v", Palette.Role.A)
	_formula.define_symbol("n", "n", Palette.Role.B)
	_formula.define_symbol("e", "n̂", Palette.Role.UNIT)
	_formula.define_number("vx", Palette.Role.A, tr("x of v"))
	_formula.define_number("vy", Palette.Role.A, tr("y of v"))
	_formula.define_number("sx", Palette.Role.INK, tr("x of the start"))
	_formula.define_number("sy", Palette.Role.INK, tr("y of the start"))
	_formula.define_number("k", Palette.Role.UNIT, tr("How many times n̂ is drawn"))
	for number: String in ["n_pair", "n_x", "n_y", "n_length"]:
		_formula.define_number(number, Palette.Role.B)
	_formula.define_number("check", Palette.Role.INK)
	_formula.define_number("opposite_pair", Palette.Role.REST)
	_formula.define_number("e_pair", Palette.Role.UNIT)
	_formula.define_number("scaled_pair", Palette.Role.UNIT)
	_define_mistakes()


func _define_mistakes() -> void:
	_formula.define_symbol("w1", "✗ (y, x)", Palette.Role.WRONG)
	_formula.define_symbol("cross", "✗", Palette.Role.WRONG)
	_formula.define_symbol("w2", "✗ (y, −x)", Palette.Role.WRONG)
	for number: String in ["w1_pair", "w1_check", "w2_pair", "wrong_pair", "cut"]:
		_formula.define_number(number, Palette.Role.WRONG)


## Shows the lines of all steps up to [param step] with the numbers of [param model].
func show_model(model: NormalsModel, step: int) -> void:
	_formula.show_lines(NormalsTexts.lines(model, step))
	var v := model.v()
	var n := model.normal()
	_formula.set_number("vx", v.x)
	_formula.set_number("vy", v.y)
	_formula.set_number("sx", model.start.x)
	_formula.set_number("sy", model.start.y)
	_formula.set_number("k", model.times)
	_formula.set_vector("n_pair", n)
	_formula.set_number("n_x", n.x)
	_formula.set_number("n_y", n.y)
	_formula.set_number("n_length", n.length())
	_formula.set_number("check", v.dot(n))
	_formula.set_vector("opposite_pair", model.opposite())
	_formula.set_vector("e_pair", model.unit())
	_formula.set_vector("scaled_pair", model.scaled())
	_put_mistakes(model)


func _put_mistakes(model: NormalsModel) -> void:
	var v := model.v()
	_formula.set_vector("w1_pair", NormalsMistakes.swapped(v))
	_formula.set_number("w1_check", v.dot(NormalsMistakes.swapped(v)))
	_formula.set_vector("w2_pair", NormalsMistakes.wrong_sign(v))
	_formula.set_vector("wrong_pair", NormalsMistakes.wrong_unit(model.mistake, v))
	_formula.set_number("cut", floorf(v.length()))
