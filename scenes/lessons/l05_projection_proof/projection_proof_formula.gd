class_name ProjectionProofFormula
extends RefCounted
## Puts the numbers of the proof into its formula lines.

## What is smaller than this share of the vector is rounding, and shown as 0; the readout tells it.
const _ROUNDING := 1e-12

var _formula: Formula


## Says to [param formula] what the names in [ProjectionProofTexts] stand for.
func _init(formula: Formula) -> void:
	_formula = formula
	_define_symbols()
	_formula.define_number("ax", Palette.Role.A, tr("x of a"))
	_formula.define_number("ay", Palette.Role.A, tr("y of a"))
	_formula.define_number("bx", Palette.Role.B, tr("x of b"))
	_formula.define_number("by", Palette.Role.B, tr("y of b"))
	for name_in_line: String in ["a_x", "a_y", "a_turned_pair"]:
		_formula.define_number(name_in_line, Palette.Role.A)
	for name_in_line: String in ["b_x", "b_y", "b_length", "b_turned_pair"]:
		_formula.define_number(name_in_line, Palette.Role.B)
	for name_in_line: String in ["cosine", "sine", "cosine_value", "sine_value"]:
		_formula.define_number(name_in_line, Palette.Role.UNIT)
	for name_in_line: String in ["beta", "difference"]:
		_formula.define_number(name_in_line, Palette.Role.INK)
	_formula.define_number("scalar", Palette.Role.PROJECTION)


## Shows the lines of [param step] with the numbers of [param model].
func show_model(model: ProjectionProofModel, step: ProjectionProofTexts.Step) -> void:
	for name_in_line: String in ["ax", "a_x"]:
		_formula.set_number(name_in_line, model.a.x)
	for name_in_line: String in ["ay", "a_y"]:
		_formula.set_number(name_in_line, model.a.y)
	for name_in_line: String in ["bx", "b_x"]:
		_formula.set_number(name_in_line, model.b.x)
	for name_in_line: String in ["by", "b_y"]:
		_formula.set_number(name_in_line, model.b.y)
	_formula.set_number("b_length", model.b.length())
	_formula.set_number("cosine", model.cosine())
	_formula.set_number("sine", model.sine())
	_show_result("cosine_value", model.cosine())
	_show_result("sine_value", model.sine())
	_show_result("scalar", model.dot_with_unit())
	_show_result("difference", model.x_of_turned_a() - model.dot_with_unit())
	_formula.set_text("beta", NumberText.short(Vec2.rad_to_deg(model.beta())) + "°")
	show_turn(model, step)


## Shows the numbers that change while the drawing turns.
func show_turn(model: ProjectionProofModel, step: ProjectionProofTexts.Step) -> void:
	_formula.show_lines(ProjectionProofTexts.lines(model, step))
	_formula.set_vector("a_turned_pair", _without_rounding(model.turned(model.a)))
	_formula.set_vector("b_turned_pair", _without_rounding(model.turned(model.b)))


func _define_symbols() -> void:
	_formula.define_symbol("a", "a", Palette.Role.A)
	_formula.define_symbol("b", "b", Palette.Role.B)
	_formula.define_symbol("a_turned", "a′", Palette.Role.A)
	_formula.define_symbol("b_turned", "b′", Palette.Role.B)
	_formula.define_symbol("e", ProjectionProofTexts.UNIT, Palette.Role.UNIT)
	_formula.define_symbol("p", "p", Palette.Role.PROJECTION)


# At the end of a line a negative number needs no parentheses.
func _show_result(name_in_line: String, value: float) -> void:
	_formula.set_text(name_in_line, NumberText.short(value))


static func _without_rounding(vector: Vec2) -> Vec2:
	var least := vector.length() * _ROUNDING
	var across := vector.x if absf(vector.x) > least else 0.0
	return Vec2.new(across, vector.y if absf(vector.y) > least else 0.0)
