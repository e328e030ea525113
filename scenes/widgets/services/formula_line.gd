class_name FormulaLine
extends Container
## A line of a formula: its parts beside each other. Where it is longer than the panel is wide, it
## breaks between two statements, inside a statement only where that one alone is longer, and inside
## parentheses only where they are longer.

## Every line is in this group: it keeps room while numbers run.
const LINES := &"formula_lines"

# A number that runs through it gets as long as this one.
const _RUNNING_NUMBER := "−0.000"
# The height of a row of text.
const _ROW := 30.0

## The text that it shows, with names in braces.
var source := ""
## Its statements from left to right.
var statements: Array[Shown] = []

# The places of the parts with which a statement or a gap begins.
var _starts: PackedInt32Array = []
var _height := 0.0
# The rows that are kept while numbers run.
var _kept_rows := 0


## A statement, its names, and the label or field of each.
class Shown:
	extends RefCounted
	var statement: FormulaStatement
	var names: PackedStringArray = []
	var parts: Array[Control] = []


func _enter_tree() -> void:
	add_to_group(LINES)


## What is added from now on is kept together.
func begin_group() -> void:
	_starts.append(get_child_count())


func _get_minimum_size() -> Vector2:
	var widest := 0.0
	for part: Control in get_children():
		var label := part as Label
		var least := part.get_combined_minimum_size().x
		widest = maxf(widest, WordWidth.of_longest(label) if label else least)
	return Vector2(widest, _height)


func _notification(what: int) -> void:
	if what == NOTIFICATION_SORT_CHILDREN:
		_lay_out()


func _lay_out() -> void:
	_wrap_long_pairs()
	var widths := _widths()
	var breaks := _breaks(widths)
	var y := 0.0
	for i in breaks.size():
		var end := breaks[i + 1] if i + 1 < breaks.size() else get_child_count()
		y += _lay_row(breaks[i], end, y)
	_kept_rows = maxi(_kept_rows, _breaks(_running_widths(widths)).size())
	if not NumberField.keeps_room:
		_kept_rows = 0
	y += maxi(_kept_rows - breaks.size(), 0) * _ROW
	if y != _height:
		_height = y
		update_minimum_size()


# A pair of very long numbers can be wider than a row: then it wraps between both.
func _wrap_long_pairs() -> void:
	for part: Node in get_children():
		var label := part as Label
		if not label:
			continue
		var is_long := WordWidth.of_text(label, label.text) > size.x and ", " in label.text
		var mode := TextServer.AUTOWRAP_WORD if is_long else TextServer.AUTOWRAP_OFF
		if label.autowrap_mode != mode:
			label.autowrap_mode = mode
		label.custom_minimum_size.x = size.x if is_long else 0.0


func _widths() -> PackedFloat64Array:
	var widths: PackedFloat64Array = []
	for part: Control in get_children():
		widths.append(part.get_combined_minimum_size().x)
	return widths


# The widths that the parts need while numbers run.
func _running_widths(widths: PackedFloat64Array) -> PackedFloat64Array:
	var running := widths.duplicate()
	for i in running.size():
		var label := get_child(i) as Label
		if label:
			running[i] = maxf(running[i], _running_width(label))
	return running


# The width of the longest number, or pair of numbers, that runs through a label; 0 for other texts.
static func _running_width(label: Label) -> float:
	var numbers := label.text.replace(NumberText.MINUS, "-").trim_prefix("(").trim_suffix(")")
	var longest := label.text
	for number in numbers.split(", "):
		if not number.is_valid_float():
			return 0.0
		longest = longest.replace(number.replace("-", NumberText.MINUS), _RUNNING_NUMBER)
	return WordWidth.of_text(label, longest)


# The places of the parts with which a row begins.
func _breaks(widths: PackedFloat64Array) -> PackedInt32Array:
	var breaks: PackedInt32Array = [0]
	var x := 0.0
	for i in widths.size():
		var needed := maxf(_width_to_closing(i, widths), _group_width(i, widths))
		if i > breaks[-1] and not _is_gap(get_child(i)) and x + needed > size.x + 0.5:
			breaks.append(i)
			x = 0.0
		x += widths[i]
	return breaks


# The width of the group that begins with a part; 0 where none begins, or where it is too long for a
# row.
func _group_width(start: int, widths: PackedFloat64Array) -> float:
	var at := _starts.find(start)
	if at < 0:
		return 0.0
	var end := _starts[at + 1] if at + 1 < _starts.size() else widths.size()
	var width := 0.0
	for i in range(start, end):
		width += widths[i]
	return width if width <= size.x else 0.0


# The width of the part and of what follows until the parentheses that open in it are closed; its
# own width where none open, or where that is too long for a row.
func _width_to_closing(start: int, widths: PackedFloat64Array) -> float:
	var width := 0.0
	var open := 0
	for i in range(start, widths.size()):
		width += widths[i]
		var label := get_child(i) as Label
		if label:
			open += label.text.count("(") - label.text.count(")")
		if open <= 0:
			return width if width <= size.x else widths[start]
	return widths[start]


# A gap may go beyond the end of a row: nobody sees it.
static func _is_gap(part: Node) -> bool:
	return part is Label and not (part as Label).text.strip_edges()


# Returns the height of the row.
func _lay_row(start: int, end: int, y: float) -> float:
	var height := 0.0
	for i in range(start, end):
		height = maxf(height, (get_child(i) as Control).get_combined_minimum_size().y)
	var x := 0.0
	for i in range(start, end):
		var part := get_child(i) as Control
		var extent := part.get_combined_minimum_size()
		fit_child_in_rect(part, Rect2(Vector2(x, y + floorf((height - extent.y) / 2.0)), extent))
		x += extent.x
	return height
