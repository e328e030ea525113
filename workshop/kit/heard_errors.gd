class_name WorkshopHeardErrors
extends Logger
## Hears what the engine says of a student's code: mistakes of form, and what stops a method.

const _MOST := 20
const _HIS := "res:/" + "/workshop/judged"
const _SCRIPT := Logger.ERROR_TYPE_SCRIPT


## One thing that the engine said.
class Heard:
	extends RefCounted
	## What it said.
	var message: String
	## The file that it means; "" where a guard says it of the student's own file.
	var file: String
	## The line in it, from 1.
	var line: int


## What was heard since [method begin], the first ones only.
var heard: Array[Heard] = []
## Whether a method called itself without end.
var has_overflowed := false


## Forgets what was heard.
func begin() -> void:
	heard.clear()
	has_overflowed = false


## Adds what a guard in the student's code has found in [param line] of his file.
func add(message: String, line: int) -> void:
	if heard.size() < _MOST:
		var added := Heard.new()
		added.message = message
		added.line = line
		heard.append(added)


func _log_error(
	_function: String,
	file: String,
	line: int,
	code: String,
	rationale: String,
	_editor_notify: bool,
	error_type: int,
	backtraces: Array[ScriptBacktrace]
) -> void:
	if code.begins_with("Stack underflow") or code.begins_with("Stack overflow"):
		has_overflowed = true
	if error_type != _SCRIPT or heard.size() >= _MOST:
		return
	var added := Heard.new()
	added.message = rationale if rationale else code
	added.file = file
	added.line = line
	for trace in backtraces:
		if trace.get_frame_count() > 0 and not file.begins_with(_HIS):
			added.line = _line_of_his(trace, line)
	heard.append(added)


# Where something of the engine or the kit was called wrongly, the student's line is further down.
func _line_of_his(trace: ScriptBacktrace, otherwise: int) -> int:
	for frame in trace.get_frame_count():
		if trace.get_frame_file(frame).begins_with(_HIS):
			return trace.get_frame_line(frame)
	return otherwise
