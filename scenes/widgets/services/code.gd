class_name LessonCode
extends FoldableContainer
## The few lines of GDScript that compute what the formula shows. They are run with the values on
## the board, and each says what came out of it.

const _VARIABLE := "^var (\\w+) := (.+)$"
const _CALL := "^(\\w+)\\.\\w+\\(.*\\)$"

# The student's choice holds for every lesson.
static var _is_folded := true

## The lines that are shown, without what came out of them.
var lines: PackedStringArray = []
## The values of the names that [member lines] use.
var inputs: Dictionary[String, Variant] = {}

## Shows `?` in place of each result.
var hides_numbers := false:
	set(value):
		hides_numbers = value
		_show_again()

# A parsed line with the names in it, in their order.
var _parsed: Dictionary[String, Expression] = {}

@onready var _text: Label = %Text
@onready var _variable_finder := RegEx.create_from_string(_VARIABLE)
@onready var _call_finder := RegEx.create_from_string(_CALL)


func _ready() -> void:
	folded = _is_folded
	folding_changed.connect(_fold)


## Shows [param new_lines]. `var p := a.dot(b)` is run and says what p is; `v.reflect(n)` is run and
## says what v is then; any other line, such as `if t < 1.0:`, is only shown. [param new_inputs] are
## the values of the names that the lines use, and classes other than [Vec2] by their names. A
## [Vec2] is copied first. Without lines nothing is shown. An error if a line cannot be run.
func show_code(new_lines: PackedStringArray, new_inputs: Dictionary[String, Variant]) -> void:
	lines = new_lines
	inputs = new_inputs
	visible = not lines.is_empty()
	_show_again()


# Nothing is run while nobody sees it.
func _show_again() -> void:
	if folded:
		return
	var values := _values()
	var texts: PackedStringArray = []
	for line in lines:
		var result := _run(line, values)
		texts.append(line + ("   # " + ("?" if hides_numbers else result) if result else ""))
	_text.text = "\n".join(texts)


func _values() -> Dictionary[String, Variant]:
	var values: Dictionary[String, Variant] = {"Vec2": Vec2}
	for key in inputs:
		values[key] = inputs[key]
		if values[key] is Vec2:
			var vector: Vec2 = values[key]
			values[key] = vector.copy()
	return values


# Returns what came out, "" for a line that is only shown.
func _run(line: String, values: Dictionary[String, Variant]) -> String:
	var variable := _variable_finder.search(line)
	if variable:
		values[variable.get_string(1)] = _value_of(variable.get_string(2), values)
		return _text_of(values[variable.get_string(1)])
	var call_of := _call_finder.search(line)
	if call_of:
		_value_of(line, values)
		return _text_of(values[call_of.get_string(1)])
	return ""


func _value_of(code: String, values: Dictionary[String, Variant]) -> Variant:
	var names := PackedStringArray(values.keys())
	var key := "%s in %s" % [code, ",".join(names)]
	if not _parsed.has(key):
		_parsed[key] = Expression.new()
		if _parsed[key].parse(code, names) != OK:
			push_error("“%s” cannot be run: %s" % [code, _parsed[key].get_error_text()])
	var value: Variant = _parsed[key].execute(values.values(), null, false)
	if _parsed[key].has_execute_failed():
		push_error("“%s” cannot be run: %s" % [code, _parsed[key].get_error_text()])
	return value


static func _text_of(value: Variant) -> String:
	if value is Vec2:
		var vector: Vec2 = value
		return NumberText.pair(vector.x, vector.y)
	if value is float:
		var number: float = value
		return NumberText.short(number)
	return str(value)


func _fold(on: bool) -> void:
	_is_folded = on
	_show_again()
