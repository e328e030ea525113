class_name PointOfImpactFormula
extends RefCounted
## Puts the numbers of the lesson on the point of impact into its formula lines.

var _formula: Formula


## Says to [param formula] what the names in [PointOfImpactTexts] stand for.
func _init(formula: Formula) -> void:
	_formula = formula
	_define_symbols()
	_define_fields()
	for number: String in ["v_pair", "old_distance", "new_distance", "r_value", "t"]:
		_formula.define_number(number, Palette.Role.INK)
	_formula.define_number("a", Palette.Role.A)
	_formula.define_number("b", Palette.Role.B)
	_formula.define_number("reset_pair", Palette.Role.REST)
	_formula.define_number("poi_pair", Palette.Role.PROJECTION)
	_formula.define_number("wrong_t", Palette.Role.WRONG)


## Shows the lines of all steps up to [param step] with the numbers of [param model].
func show_model(model: PointOfImpactModel, step: int) -> void:
	_formula.show_lines(PointOfImpactTexts.lines(model, step))
	_put_fields(model)
	_formula.set_vector("v_pair", model.motion())
	_formula.set_number("old_distance", model.old_distance())
	_formula.set_number("new_distance", model.new_distance())
	_formula.set_number("r_value", model.radius)
	_formula.set_number("a", model.way_to_contact())
	_formula.set_number("b", model.way_of_frame())
	_formula.set_text("t", NumberText.short(model.fraction()))
	_formula.set_text("wrong_t", NumberText.short(model.fraction_with_mistake()))
	_put_results(model)


func _put_results(model: PointOfImpactModel) -> void:
	_formula.set_text("reset_pair", TranslationServer.translate("not needed"))
	_formula.set_text("poi_pair", TranslationServer.translate("none"))
	if model.is_reset():
		_formula.set_vector("reset_pair", model.reset_position())
	var impact := model.impact()
	if impact.hit:
		_formula.set_vector("poi_pair", impact.position)


func _define_symbols() -> void:
	_formula.define_symbol("a_symbol", "a", Palette.Role.A)
	_formula.define_symbol("b_symbol", "b", Palette.Role.B)
	_formula.define_symbol("n", "n̂", Palette.Role.UNIT)
	_formula.define_symbol("poi", "POI", Palette.Role.PROJECTION)
	_formula.define_symbol("reset", TranslationServer.translate("reset"), Palette.Role.REST)
	_formula.define_symbol("wrong", TranslationServer.translate("wrong"), Palette.Role.WRONG)


func _define_fields() -> void:
	_formula.define_number("old_x", Palette.Role.INK, tr("x of the old position"))
	_formula.define_number("old_y", Palette.Role.INK, tr("y of the old position"))
	_formula.define_number("new_x", Palette.Role.INK, tr("x of the new position"))
	_formula.define_number("new_y", Palette.Role.INK, tr("y of the new position"))
	_formula.define_number("sx", Palette.Role.INK, tr("x of the line's start"))
	_formula.define_number("sy", Palette.Role.INK, tr("y of the line's start"))
	_formula.define_number("ex", Palette.Role.INK, tr("x of the line's end"))
	_formula.define_number("ey", Palette.Role.INK, tr("y of the line's end"))
	_formula.define_number("r", Palette.Role.INK, tr("radius of the ball"))
	_formula.define_number("speed", Palette.Role.INK, tr("speed in pixels per frame"))


func _put_fields(model: PointOfImpactModel) -> void:
	_formula.set_number("old_x", model.old_position.x)
	_formula.set_number("old_y", model.old_position.y)
	_formula.set_number("new_x", model.new_position.x)
	_formula.set_number("new_y", model.new_position.y)
	_formula.set_number("sx", model.line.start.x)
	_formula.set_number("sy", model.line.start.y)
	_formula.set_number("ex", model.line.end.x)
	_formula.set_number("ey", model.line.end.y)
	_formula.set_number("r", model.radius)
	_formula.set_number("speed", model.motion().length())
