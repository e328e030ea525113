extends Logger
## Notes each error and warning of the engine with the test that was running.

const TrackedMessage := preload("tracked_message.gd")
const NO_TEST := "no test"


class Messages:
	## Test -> its messages.
	var items := {}


var errors := Messages.new()

var _test := NO_TEST
var _mutex := Mutex.new()


func start_test(test: String) -> void:
	_test = test


func end_test() -> void:
	_test = NO_TEST


func get_errors_for_test() -> Array[TrackedMessage]:
	var found: Array[TrackedMessage] = []
	_mutex.lock()
	var noted: Array = errors.items.get(_test, [])
	found.assign(noted)
	_mutex.unlock()
	return found


func unexpected_errors() -> PackedStringArray:
	var found := PackedStringArray()
	for message: TrackedMessage in get_errors_for_test():
		if not message.handled and not message.is_push_warning():
			found.append("[%d] <%s>%s" % [found.size() + 1, message.type_name(), message.code])
	return found


func _log_error(
	function: String,
	file: String,
	line: int,
	code: String,
	rationale: String,
	_editor_notify: bool,
	_error_type: int,
	backtraces: Array[ScriptBacktrace]
) -> void:
	var message := TrackedMessage.new()
	message.function = function
	message.file = file
	message.line = line
	message.code = code
	message.rationale = rationale
	message.backtrace = backtraces
	_mutex.lock()
	var noted: Array = errors.items.get_or_add(_test, [])
	noted.append(message)
	_mutex.unlock()
