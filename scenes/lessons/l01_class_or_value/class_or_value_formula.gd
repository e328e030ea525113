class_name ClassOrValueFormula
extends RefCounted
## The code of the lesson on objects and values: its lines, and what each name in them is.

const _VALUES: PackedStringArray = [
	"{position} {position_pair}   {old} {old_pair}",
	"{value} {value_pair}   {old_value} {old_value_pair}",
]
# A Vector2 has 32 bits: 9 digits tell it from every other.
const _DIGITS_OF_VALUE := 9
const _DIGITS_OF_OBJECT := 12

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the code up to [param step], counted from 0, and from the change on what the names hold, as
## in [param model].
func show_model(model: ClassOrValueModel, step: int) -> void:
	var is_changed := step >= ClassOrValueTexts.Step.CHANGE
	_put_symbols()
	_put_numbers(model, model.position if is_changed else model.first_place())
	var lines := _first_lines(is_changed)
	if step >= ClassOrValueTexts.Step.SECOND_NAME:
		lines.append("{old} = {position}.copy()" if model.copies else "{old} = {position}")
		lines.append("{old_value} = {value}")
	if is_changed:
		lines.append("{position}.set_xy( {x} , {y} )")
		lines.append("{value} = Vector2{value_pair}")
		lines.append_array(_VALUES)
	_formula.show_lines(lines)


# Until the change, the first numbers are those that can be typed over.
func _first_lines(is_changed: bool) -> PackedStringArray:
	if is_changed:
		return ["{position} = Vec2.new{first_pair}", "{value} = Vector2{first_value_pair}"]
	return ["{position} = Vec2.new( {x} , {y} )", "{value} = Vector2{first_value_pair}"]


func _put_symbols() -> void:
	_formula.put_symbol("position", "position", Palette.Role.A)
	_formula.put_symbol("old", "old", Palette.Role.UNIT)
	_formula.put_symbol("value", "value", Palette.Role.B)
	_formula.put_symbol("old_value", "old_value", Palette.Role.UNIT)


func _put_numbers(model: ClassOrValueModel, place: Vec2) -> void:
	_formula.put_number("x", place.x, Palette.Role.A, tr("x of position"))
	_formula.put_number("y", place.y, Palette.Role.A, tr("y of position"))
	_put_object("first_pair", model.first_place(), Palette.Role.A)
	_put_object("position_pair", model.position, Palette.Role.A)
	var old := NumberText.pair(model.old.x, model.old.y, _DIGITS_OF_OBJECT)
	_formula.put_answer("old_pair", old, Palette.Role.UNIT)
	_put_value("first_value_pair", model.first_place().to_vector2(), Palette.Role.B)
	_put_value("value_pair", model.value, Palette.Role.B)
	var old_value := NumberText.pair(model.old_value.x, model.old_value.y, _DIGITS_OF_VALUE)
	_formula.put_answer("old_value_pair", old_value, Palette.Role.UNIT)


func _put_object(name_in_line: String, object: Vec2, role: Palette.Role) -> void:
	_formula.put_text(name_in_line, NumberText.pair(object.x, object.y, _DIGITS_OF_OBJECT), role)


func _put_value(name_in_line: String, value: Vector2, role: Palette.Role) -> void:
	_formula.put_text(name_in_line, NumberText.pair(value.x, value.y, _DIGITS_OF_VALUE), role)
