class_name LineDistanceFormula
extends RefCounted
## Puts the numbers of the lesson on the distance from a line into its formula lines.

var _formula: Formula


## Says to [param formula] what the names in [LineDistanceTexts] stand for.
func _init(formula: Formula) -> void:
	_formula = formula
	_define_symbols()
	_define_fields()
	for number: String in ["ly", "lx", "length"]:
		_formula.define_number(number, Palette.Role.INK)
	for number: String in ["d_pair", "dx", "dy"]:
		_formula.define_number(number, Palette.Role.A)
	for number: String in ["n_pair", "nx", "ny"]:
		_formula.define_number(number, Palette.Role.UNIT)
	_formula.define_number("distance", Palette.Role.PROJECTION)
	_formula.define_number("gap", Palette.Role.INK)
	_formula.define_number("nearest", Palette.Role.REST)
	_formula.define_number("segment", Palette.Role.REST)
	_formula.define_number("wrong_distance", Palette.Role.WRONG)


## Shows the lines of all steps up to [param step] with the numbers of [param model].
func show_model(model: LineDistanceModel, step: int) -> void:
	_formula.show_lines(LineDistanceTexts.lines(model, step))
	_put_fields(model)
	_put_vectors(model.line.along(), model.difference(), model.line.normal())
	_formula.set_text("distance", NumberText.short(model.distance()))
	_formula.set_text("gap", NumberText.short(model.gap()))
	_formula.set_vector("nearest", model.nearest())
	_formula.set_text("segment", NumberText.short(model.segment_distance()))
	_formula.set_text("wrong_distance", NumberText.short(model.distance_with_mistake()))


func _define_symbols() -> void:
	_formula.define_symbol("l", "l", Palette.Role.INK)
	_formula.define_symbol("c", "c", Palette.Role.INK)
	_formula.define_symbol("p", "p", Palette.Role.A)
	_formula.define_symbol("d", "d", Palette.Role.A)
	_formula.define_symbol("n", "n̂", Palette.Role.UNIT)
	_formula.define_symbol("wrong", TranslationServer.translate("wrong"), Palette.Role.WRONG)


func _define_fields() -> void:
	_formula.define_number("sx", Palette.Role.INK, tr("x of the line's start"))
	_formula.define_number("sy", Palette.Role.INK, tr("y of the line's start"))
	_formula.define_number("ex", Palette.Role.INK, tr("x of the line's end"))
	_formula.define_number("ey", Palette.Role.INK, tr("y of the line's end"))
	_formula.define_number("cx", Palette.Role.INK, tr("x of the ball's centre"))
	_formula.define_number("cy", Palette.Role.INK, tr("y of the ball's centre"))
	_formula.define_number("r", Palette.Role.INK, tr("radius of the ball"))
	_formula.define_number("share", Palette.Role.A, tr("place of p: 0 at the start, 1 at the end"))


func _put_fields(model: LineDistanceModel) -> void:
	_formula.set_number("sx", model.line.start.x)
	_formula.set_number("sy", model.line.start.y)
	_formula.set_number("ex", model.line.end.x)
	_formula.set_number("ey", model.line.end.y)
	_formula.set_number("cx", model.ball.position.x)
	_formula.set_number("cy", model.ball.position.y)
	_formula.set_number("r", model.ball.radius)
	_formula.set_number("share", model.from_share)


func _put_vectors(along: Vec2, difference: Vec2, normal: Vec2) -> void:
	_formula.set_text("lx", NumberText.short(along.x))
	_formula.set_text("ly", NumberText.short(along.y))
	_formula.set_number("length", along.length())
	_formula.set_vector("d_pair", difference)
	_formula.set_number("dx", difference.x)
	_formula.set_number("dy", difference.y)
	_formula.set_vector("n_pair", normal)
	_formula.set_number("nx", normal.x)
	_formula.set_number("ny", normal.y)
