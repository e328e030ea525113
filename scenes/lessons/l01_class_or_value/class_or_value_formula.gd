class_name ClassOrValueFormula
extends RefCounted
## The code of the lesson on objects and values: its lines, and what each name in them is.

# The lines that each step adds.
const _LINES: Array[Array] = [
	["{position} = Vec2.new( {x} , {y} )", "{value} = Vector2(…)"],
	["{old} = {position}", "{old_value} = {value}"],
	[
		"{position} {position_pair}   {old} {old_pair}",
		"{value} {value_pair}   {old_value} {old_value_pair}",
	],
	[],
]
# The same where the second name is for a copy.
const _LINES_WITH_COPY: Array[Array] = [
	["{position} = Vec2.new( {x} , {y} )", "{value} = Vector2(…)"],
	["{old} = {position}.copy()", "{old_value} = {value}"],
	[
		"{position} {position_pair}   {old} {old_pair}",
		"{value} {value_pair}   {old_value} {old_value_pair}",
	],
	[],
]

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of all steps up to [param step], counted from 0, with the numbers of
## [param model].
func show_model(model: ClassOrValueModel, step: int) -> void:
	_formula.put_symbol("position", "position", Palette.Role.A)
	_formula.put_symbol("old", "old", Palette.Role.UNIT)
	_formula.put_symbol("value", "value", Palette.Role.B)
	_formula.put_symbol("old_value", "old_value", Palette.Role.UNIT)
	_formula.put_number("x", model.position.x, Palette.Role.A, tr("x of position"))
	_formula.put_number("y", model.position.y, Palette.Role.A, tr("y of position"))
	_formula.put_vector("position_pair", model.position, Palette.Role.A)
	_formula.put_vector("old_pair", model.old, Palette.Role.UNIT)
	_formula.put_vector("value_pair", Vec2.from_vector2(model.value), Palette.Role.B)
	_formula.put_vector("old_value_pair", Vec2.from_vector2(model.old_value), Palette.Role.UNIT)
	var lines: PackedStringArray = []
	var lines_of_steps := _LINES_WITH_COPY if model.copies else _LINES
	for added: PackedStringArray in lines_of_steps.slice(0, step + 1):
		lines.append_array(added)
	_formula.show_lines(lines)
