class_name Readout
extends GridContainer
## A table of results: what, value, error against the exact answer, run time of the call.

# The row of each key; row 0 has the headings.
var _rows: Dictionary[String, int] = {}


func _ready() -> void:
	_add_row(PackedStringArray(["", tr("value"), tr("error"), tr("run time")]), &"LabelQuiet")


## Replaces the headings by translated texts, for a lesson that compares something else.
func show_headings(texts: PackedStringArray) -> void:
	for column in columns:
		(get_child(column) as Label).text = texts[column]


## Shows one result; a new [param key] adds a row below. Error in the unit of the value; time per
## call in nanoseconds.
func show_result(
	key: String, title: String, value: float, error: float, nanoseconds: float
) -> void:
	show_texts(
		key, [title, NumberText.short(value), NumberText.size(error), time_text(nanoseconds)]
	)


## The same for a vector, shown with [param digits] digits.
func show_vector(
	key: String, title: String, vector: Vec2, error: float, nanoseconds: float, digits: int = 4
) -> void:
	var value := NumberText.pair(vector.x, vector.y, digits)
	show_texts(key, [title, value, NumberText.size(error), time_text(nanoseconds)])


## The run time of a call as the table writes it.
func time_text(nanoseconds: float) -> String:
	return tr("%s ns") % NumberText.short(nanoseconds, 2)


## Shows a row of up to four texts, translated; a new [param key] adds a row below.
func show_texts(key: String, texts: PackedStringArray) -> void:
	texts.resize(columns)
	if not _rows.has(key):
		_rows[key] = _rows.size() + 1
		_add_row(texts)
	for column in columns:
		(get_child(_rows[key] * columns + column) as Label).text = texts[column]


func _add_row(texts: PackedStringArray, variation: StringName = &"") -> void:
	for column in texts.size():
		var label := Label.new()
		label.text = texts[column]
		if column > 0 and not variation:
			label.add_to_group(&"answers")
		label.theme_type_variation = variation
		label.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
		label.text_direction = Control.TEXT_DIRECTION_LTR
		label.size_flags_horizontal = Control.SIZE_EXPAND_FILL
		add_child(label)
