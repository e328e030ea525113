class_name Formula
extends VBoxContainer
## Formulas with their numbers put in: every symbol in the color of its arrow, numbers that can be
## typed over.
##
## A line is a text with names in braces, such as `{a} · {b} = {dot}`. The lesson says what each
## name is, with [method put_symbol], [method put_number] and the like, and then shows its lines.

## A number was typed over.
signal number_entered(name: String, value: float)
## The pointer is on a symbol or number of this role; [constant Palette.Role.INK] when it has left.
signal role_pointed(role: Palette.Role)
## A sentence on what was typed and cannot be taken; "" once it can.
signal refused(message: String)

const _NAME_PATTERN := "\\{(\\w+)\\}"

var _roles: Dictionary[String, Palette.Role] = {}
var _symbols: Dictionary[String, String] = {}
var _editable: Dictionary[String, String] = {}
var _texts: Dictionary[String, String] = {}
var _values: Dictionary[String, float] = {}
var _parts: Dictionary[String, Array] = {}
var _shown: PackedStringArray = []

@onready var _name_finder := RegEx.create_from_string(_NAME_PATTERN)


## A symbol, such as `b̂`, in the color of [param role].
func put_symbol(name_in_line: String, symbol: String, role: Palette.Role) -> void:
	if _symbols.get(name_in_line, "") != symbol:
		_shown.clear()
	_symbols[name_in_line] = symbol
	_set_role(name_in_line, role)


## A number in the color of [param role]. With a [param title], such as `x of a`, it can be typed
## over.
func put_number(name_in_line: String, value: float, role: Palette.Role, title: String = "") -> void:
	if title:
		_editable[name_in_line] = title
	_values[name_in_line] = value
	put_text(name_in_line, NumberText.factor(value), role)


## A number at the end of a line, in the color of [param role]: unlike a factor, a negative one has
## no parentheses around it.
func put_result(name_in_line: String, value: float, role: Palette.Role) -> void:
	put_text(name_in_line, NumberText.short(value), role)


## A pair of numbers, such as (4, -3), in the color of [param role].
func put_vector(name_in_line: String, vector: Vec2, role: Palette.Role) -> void:
	put_text(name_in_line, NumberText.pair(vector.x, vector.y), role)


## A text, translated, in the color of [param role].
func put_text(name_in_line: String, text: String, role: Palette.Role) -> void:
	_set_role(name_in_line, role)
	_texts[name_in_line] = text
	if _parts.has(name_in_line):
		for part: Control in _parts[name_in_line]:
			_fill(part, name_in_line)


## Shows these lines from top to bottom; does nothing where they are shown already.
func show_lines(lines: PackedStringArray) -> void:
	if lines == _shown:
		return
	_shown = lines
	_parts.clear()
	for child in get_children():
		remove_child(child)
		child.queue_free()
	for line in lines:
		_add_line(line)


# Lines that are shown already have to be laid out anew when a color in them changes.
func _set_role(name_in_line: String, role: Palette.Role) -> void:
	if _roles.get(name_in_line, role) != role:
		_shown.clear()
	_roles[name_in_line] = role


func _add_line(line: String) -> void:
	var row := HFlowContainer.new()
	row.add_theme_constant_override(&"h_separation", 0)
	add_child(row)
	var at := 0
	for found in _name_finder.search_all(line):
		_add_plain(row, line.substr(at, found.get_start() - at))
		_add_named(row, found.get_string(1))
		at = found.get_end()
	_add_plain(row, line.substr(at))


func _add_plain(row: Control, text: String) -> void:
	if text:
		row.add_child(_new_label(text))


func _add_named(row: Control, name_in_line: String) -> void:
	var part: Control
	if _editable.has(name_in_line):
		part = _new_field(name_in_line)
	else:
		var symbol: String = _symbols.get(name_in_line, "")
		var label := _new_label(symbol)
		label.add_theme_color_override(&"font_color", Palette.color(_roles[name_in_line]))
		part = label
	part.mouse_filter = Control.MOUSE_FILTER_STOP if part is LineEdit else Control.MOUSE_FILTER_PASS
	part.mouse_entered.connect(role_pointed.emit.bind(_roles[name_in_line]))
	part.mouse_exited.connect(role_pointed.emit.bind(Palette.Role.INK))
	row.add_child(part)
	if not _parts.has(name_in_line):
		_parts[name_in_line] = []
	_parts[name_in_line].append(part)
	_fill(part, name_in_line)


func _new_label(text: String) -> Label:
	var label := Label.new()
	label.theme_type_variation = &"LabelMath"
	label.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	label.text_direction = Control.TEXT_DIRECTION_LTR
	label.text = text
	return label


func _new_field(name_in_line: String) -> NumberField:
	var field := NumberField.new()
	field.accessibility_name = _editable[name_in_line]
	field.tooltip_text = _editable[name_in_line]
	field.add_theme_color_override(&"font_color", Palette.color(_roles[name_in_line]))
	field.number_entered.connect(
		func(value: float) -> void: number_entered.emit(name_in_line, value)
	)
	field.refused.connect(refused.emit)
	return field


func _fill(part: Control, name_in_line: String) -> void:
	if part is NumberField:
		var value: float = _values.get(name_in_line, 0.0)
		(part as NumberField).show_number(value)
	elif _texts.has(name_in_line):
		(part as Label).text = _texts[name_in_line]
