class_name Readout
extends FoldableContainer
## A table of results: what, value, error against the exact answer, run time of the call. Folded
## until the student wants it, and open where it is what the step is about.

## Under this key [KeptChoices] has whether the student wants it open, in every lesson.
const KEY := "numbers"

static var _short_number := RegEx.create_from_string(r"(?<![\w.])(?<!e−)[\d.]{1,4}(?![\d.e])")

## The step is about these numbers: they are open, whatever was chosen.
var is_the_point := false:
	set(value):
		if value != is_the_point:
			is_the_point = value
			show_chosen()

# The row of each key; row 0 has the headings.
var _rows: Dictionary[String, int] = {}

# For each column the widest text and the widest word in it so far.
var _widest: PackedFloat64Array = [0.0, 0.0, 0.0, 0.0]
var _widest_word: PackedFloat64Array = [0.0, 0.0, 0.0, 0.0]

@onready var _table: GridContainer = %Table
@onready var _room: ScrollContainer = %Room


func _ready() -> void:
	_add_row(&"LabelQuiet")
	show_headings(PackedStringArray(["", tr("value"), tr("error"), tr("run time")]))
	show_chosen()
	_room.resized.connect(_fit)
	folding_changed.connect(_keep)


## Open or folded, as the student has chosen and the step has it.
func show_chosen() -> void:
	var is_wanted: bool = KeptChoices.value(KEY, false)
	set_block_signals(true)
	folded = not is_wanted and not is_the_point
	set_block_signals(false)


## The label in a row, from 0 for the headings, and a column, from 0.
func cell(row: int, column: int) -> Label:
	return _table.get_child(row * _table.columns + column)


## Shows only the first rows, the headings included.
func show_rows(count: int) -> void:
	for i in _table.get_child_count():
		(_table.get_child(i) as Control).visible = i < count * _table.columns


## The number of rows, the headings included.
func row_count() -> int:
	return _rows.size() + 1


## Replaces the headings by translated texts, for a lesson that compares something else.
func show_headings(texts: PackedStringArray) -> void:
	for column in _table.columns:
		_write(0, column, texts[column])


## Shows one result; a new [param key] adds a row below. Error in the unit of the value; time per
## call in nanoseconds.
func show_result(
	key: String, row_title: String, value: float, error: float, nanoseconds: float
) -> void:
	show_texts(
		key, [row_title, NumberText.short(value), NumberText.size(error), time_text(nanoseconds)]
	)


## The same for a vector, shown with [param digits] digits.
func show_vector(
	key: String, row_title: String, vector: Vec2, error: float, nanoseconds: float, digits: int = 4
) -> void:
	var value := NumberText.pair(vector.x, vector.y, digits)
	show_texts(key, [row_title, value, NumberText.size(error), time_text(nanoseconds)])


## The run time of a call as the table writes it.
func time_text(nanoseconds: float) -> String:
	return tr("%s ns") % NumberText.short(nanoseconds, 2)


## Shows a row of up to four texts, translated; a new [param key] adds a row below.
func show_texts(key: String, texts: PackedStringArray) -> void:
	texts.resize(_table.columns)
	if not _rows.has(key):
		_rows[key] = _rows.size() + 1
		_add_row()
	for column in _table.columns:
		_write(_rows[key], column, texts[column])


func _write(row: int, column: int, text: String) -> void:
	var label := cell(row, column)
	label.text = text
	_widest[column] = maxf(_widest[column], _width(_with_room(text) if column else text, label))
	for word in text.split(" "):
		_widest_word[column] = maxf(_widest_word[column], _width(word, label))
	_fit()


# Numbers get longer while they run, and run times are never the same: a column has room for numbers
# of five signs from the start, or for two of four. One with a power of ten is long already.
static func _with_room(text: String) -> String:
	return _short_number.sub(text, "0000" if text.begins_with("(") else "00000", true)


# A column keeps the room that its longest text has taken: nothing moves while numbers run. Where
# there is too little room for that, titles wrap, and numbers too where even that is not enough.
func _fit() -> void:
	var room := _room.size.x - _table.get_theme_constant(&"h_separation") * (_table.columns - 1.0)
	for column in range(1, _table.columns):
		room -= _widest[column]
	var wraps := _widest[0] > room
	var numbers_wrap := _widest_word[0] > room
	for i in _table.get_child_count():
		var label := _table.get_child(i) as Label
		var column := i % _table.columns
		var is_whole := not (numbers_wrap if column else wraps)
		label.custom_minimum_size.x = _widest[column] if is_whole else _widest_word[column]
		label.autowrap_mode = (
			TextServer.AUTOWRAP_OFF if is_whole else TextServer.AUTOWRAP_WORD_SMART
		)
		# What is left is for what wraps.
		var takes_rest := not wraps or numbers_wrap or column == 0
		label.size_flags_horizontal = SIZE_EXPAND_FILL if takes_rest else SIZE_FILL


static func _width(text: String, label: Label) -> float:
	var font := label.get_theme_font(&"font")
	var font_size := label.get_theme_font_size(&"font_size")
	return ceilf(font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x)


func _keep(is_closed: bool) -> void:
	if not is_the_point:
		KeptChoices.keep(KEY, not is_closed)


func _add_row(variation: StringName = &"") -> void:
	for column in _table.columns:
		var label := Label.new()
		if column > 0 and not variation:
			label.add_to_group(&"answers")
		label.theme_type_variation = variation
		label.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
		label.text_direction = Control.TEXT_DIRECTION_LTR
		label.size_flags_horizontal = Control.SIZE_EXPAND_FILL
		_table.add_child(label)
