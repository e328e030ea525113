class_name ErrorCatcher
extends Logger
## Notes the first error that is logged while it listens: what went wrong, and in which script and
## line.

## What went wrong; "" while nothing did.
var first := ""


func _log_error(
	function: String,
	file: String,
	line: int,
	code: String,
	rationale: String,
	_editor_notify: bool,
	error_type: int,
	_script_backtraces: Array[ScriptBacktrace]
) -> void:
	if first or error_type == ERROR_TYPE_WARNING:
		return
	var what := rationale if rationale else code
	first = "%s (%s:%d, %s)" % [what, file.get_file(), line, function]
