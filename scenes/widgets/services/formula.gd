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

const _NAME := "\\{(\\w+)\\}"
# Between two statements in a line there is a wide gap.
const _GAP := "\\s{3,}"
# A longer text between two names is put in word by word.
const _LONG_TEXT := 12

## Shows `?` in place of each number that cannot be typed over, and of other answers.
var hides_numbers := false:
	set(value):
		hides_numbers = value
		show_lines(_shown)

var _roles: Dictionary[String, Palette.Role] = {}
var _symbols: Dictionary[String, String] = {}
var _titles: Dictionary[String, String] = {}
var _texts: Dictionary[String, String] = {}
# The names of angles.
var _angles: PackedStringArray = []
# The names of texts that are answers.
var _answers: PackedStringArray = []
var _numbers: Dictionary[String, FormulaStatement.Number] = {}
var _shown: PackedStringArray = []
var _lines: Array[FormulaLine] = []

@onready var _is_strong := Palette.is_high_contrast
@onready var _name_finder := RegEx.create_from_string(_NAME)
@onready var _gap_finder := RegEx.create_from_string(_GAP)


## A symbol, such as `b̂`, in the color of [param role].
func put_symbol(name_in_line: String, symbol: String, role: Palette.Role) -> void:
	var shown := Conventions.in_unit(symbol)
	if _symbols.get(name_in_line, "") != shown:
		_make_old(name_in_line)
	_symbols[name_in_line] = shown
	_set_role(name_in_line, role)


## A number in the color of [param role]. With a [param title], such as `x of a`, it can be typed
## over. [FormulaStatement] finds how many digits it needs.
func put_number(name_in_line: String, value: float, role: Palette.Role, title: String = "") -> void:
	if title:
		if not _titles.has(name_in_line):
			_make_old(name_in_line)
		_titles[name_in_line] = title
	_put(name_in_line, [value], [0.0], role)


## An angle of [param degrees], in a line with `°` behind its name, in the color of [param role]. It
## is shown in the unit that is chosen, without `°` in radians; what is typed over it comes in
## degrees.
func put_angle(
	name_in_line: String, degrees: float, role: Palette.Role, title: String = ""
) -> void:
	put_number(name_in_line, Conventions.shown(degrees), role, title)
	# A field holds digits.
	_numbers[name_in_line].written = "" if title else Conventions.share_of_pi(degrees)
	if not name_in_line in _angles:
		_angles.append(name_in_line)


## A pair of numbers, such as (4, -3), in the color of [param role].
func put_vector(name_in_line: String, vector: Vec2, role: Palette.Role) -> void:
	_put(name_in_line, [vector.x, vector.y], [0.0, 0.0], role)


## A sum of terms whose sizes add up to [param size_of_terms], in the color of [param role]. What
## rounding alone leaves of it is shown as 0. For a sum whose terms the line does not show.
func put_sum(name_in_line: String, value: float, size_of_terms: float, role: Palette.Role) -> void:
	_put(name_in_line, [value], [size_of_terms], role)


## The same for a pair, such as a difference of vectors: each component has terms of its own.
func put_vector_sum(
	name_in_line: String, vector: Vec2, sizes_of_terms: Vec2, role: Palette.Role
) -> void:
	_put(name_in_line, [vector.x, vector.y], [sizes_of_terms.x, sizes_of_terms.y], role)


## A text, translated, in the color of [param role].
func put_text(name_in_line: String, text: String, role: Palette.Role) -> void:
	_set_role(name_in_line, role)
	_numbers.erase(name_in_line)
	_texts[name_in_line] = Conventions.in_unit(text)


## A text that is an answer: it is hidden as numbers are.
func put_answer(name_in_line: String, text: String, role: Palette.Role) -> void:
	put_text(name_in_line, text, role)
	if not name_in_line in _answers:
		_answers.append(name_in_line)


## Shows these lines from top to bottom, with what has been put in. Their angles are written in
## degrees, such as `cos 90°`, and shown in the unit that is chosen.
func show_lines(lines: PackedStringArray) -> void:
	var wanted := _in_unit(lines)
	if wanted != _shown or _is_strong != Palette.is_high_contrast:
		if _is_strong != Palette.is_high_contrast:
			_make_old()
		_shown = wanted
		_is_strong = Palette.is_high_contrast
		_lay_out(wanted)
	for line in _lines:
		for shown in line.statements:
			_fill(shown)
	_keep_height()


# While numbers run, lines come and go: what is below stays where it is.
func _keep_height() -> void:
	custom_minimum_size.y = maxf(size.y, custom_minimum_size.y) if NumberField.keeps_room else 0.0


static func _in_unit(lines: PackedStringArray) -> PackedStringArray:
	if not Conventions.uses_radians():
		return lines
	var found: PackedStringArray = []
	for line in lines:
		found.append(Conventions.in_unit(line.replace("}°", "}")))
	return found


func _put(
	name_in_line: String,
	components: PackedFloat64Array,
	sizes_of_terms: PackedFloat64Array,
	role: Palette.Role
) -> void:
	_set_role(name_in_line, role)
	if not _numbers.has(name_in_line):
		_numbers[name_in_line] = FormulaStatement.Number.new()
	var number := _numbers[name_in_line]
	number.components = components
	number.scales = sizes_of_terms
	number.is_typed = _titles.has(name_in_line)
	number.written = ""


# Lines that are shown already have to be laid out anew when a color in them changes.
func _set_role(name_in_line: String, role: Palette.Role) -> void:
	if _roles.get(name_in_line, role) != role:
		_make_old(name_in_line)
	_roles[name_in_line] = role


# The lines that hold this name, or all of them, are laid out anew when they are shown again.
func _make_old(name_in_line: String = "") -> void:
	_shown.clear()
	for line in _lines:
		if not name_in_line or "{%s}" % name_in_line in line.source:
			line.source = ""


# A line that stays is kept with its fields, in one of which the student may be typing.
func _lay_out(wanted: PackedStringArray) -> void:
	var before := _lines
	_lines = []
	for text in wanted:
		var kept := before.find_custom(func(line: FormulaLine) -> bool: return line.source == text)
		_lines.append(before.pop_at(kept) if kept >= 0 else _new_line(text))
	for line in before:
		remove_child(line)
		line.queue_free()
	for place in _lines.size():
		if not _lines[place].get_parent():
			add_child(_lines[place])
		move_child(_lines[place], place)


func _new_line(text: String) -> FormulaLine:
	var line := FormulaLine.new()
	line.source = text
	var at := 0
	for gap in _gap_finder.search_all(text):
		_add_statement(line, text.substr(at, gap.get_start() - at))
		line.begin_group()
		_add_plain(line, gap.get_string())
		at = gap.get_end()
	_add_statement(line, text.substr(at))
	return line


func _add_statement(line: FormulaLine, statement: String) -> void:
	line.begin_group()
	var shown := FormulaLine.Shown.new()
	shown.statement = FormulaStatement.new(statement)
	var at := 0
	for found in _name_finder.search_all(statement):
		_add_plain(line, statement.substr(at, found.get_start() - at))
		shown.names.append(found.get_string(1))
		shown.parts.append(_new_part(shown.names[-1]))
		line.add_child(shown.parts[-1])
		at = found.get_end()
	_add_plain(line, statement.substr(at))
	line.statements.append(shown)


func _add_plain(row: Control, text: String) -> void:
	# Between two pairs a line can break.
	var words := text.find(") ") + 2
	if words > 1 and text.find("(", words) > 0:
		_add_plain(row, text.left(words))
		_add_plain(row, text.substr(words))
		return
	if text.length() <= _LONG_TEXT:
		if text:
			row.add_child(_new_label(text))
		return
	# So that the line can break between its words.
	var parts := text.split(" ")
	for i in parts.size():
		var word := parts[i] + (" " if i < parts.size() - 1 else "")
		if word:
			row.add_child(_new_label(word))


func _new_part(name_in_line: String) -> Control:
	var part: Control
	if _titles.has(name_in_line):
		part = _new_field(name_in_line)
	else:
		var symbol: String = _symbols.get(name_in_line, "")
		part = _new_label(symbol)
		part.add_theme_color_override(&"font_color", Palette.color(_roles[name_in_line]))
		part.mouse_filter = Control.MOUSE_FILTER_PASS
	part.mouse_entered.connect(role_pointed.emit.bind(_roles[name_in_line]))
	part.mouse_exited.connect(role_pointed.emit.bind(Palette.Role.INK))
	return part


func _new_label(text: String) -> Label:
	var label := Label.new()
	label.theme_type_variation = &"LabelMath"
	label.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	label.text_direction = Control.TEXT_DIRECTION_LTR
	label.text = text
	return label


func _new_field(name_in_line: String) -> NumberField:
	var field := NumberField.new()
	field.accessibility_name = _titles[name_in_line]
	field.tooltip_text = _titles[name_in_line]
	field.add_theme_color_override(&"font_color", Palette.color(_roles[name_in_line]))
	field.number_entered.connect(_tell_entered.bind(name_in_line))
	field.refused.connect(refused.emit)
	return field


func _tell_entered(value: float, name_in_line: String) -> void:
	var is_angle := name_in_line in _angles
	number_entered.emit(name_in_line, Conventions.typed(value) if is_angle else value)


# Writes what was put in into the labels and fields of a statement.
func _fill(shown: FormulaLine.Shown) -> void:
	var texts := shown.statement.texts(_numbers)
	for i in texts.size():
		var name_in_line := shown.names[i]
		var part := shown.parts[i]
		if part is NumberField:
			(part as NumberField).show_number(_numbers[name_in_line].components[0], texts[i])
		elif _numbers.has(name_in_line):
			(part as Label).text = "?" if hides_numbers else texts[i]
		elif _texts.has(name_in_line):
			var is_hidden := hides_numbers and name_in_line in _answers
			(part as Label).text = "?" if is_hidden else _texts[name_in_line]
