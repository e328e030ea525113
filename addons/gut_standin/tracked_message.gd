extends RefCounted
## An error or a warning that the engine printed.

var code := ""
var rationale := ""
var file := ""
var line := -1
var function := ""
var backtrace: Array[ScriptBacktrace] = []
## True once a test has said that it expects it.
var handled := false


func is_push_error() -> bool:
	return function == "push_error"


func is_push_warning() -> bool:
	return function == "push_warning"


func is_engine_error() -> bool:
	return not is_push_error() and not is_push_warning()


func type_name() -> String:
	return "engine" if is_engine_error() else function


func contains_text(part: String) -> bool:
	return code.containsn(part) or rationale.containsn(part)
