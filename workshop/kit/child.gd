class_name WorkshopChild
extends RefCounted
## A child process that judges, seen from the lab: what it says is read without waiting.

# In two parts: an export can start no child, and needs none of what runs in it.
const _WORKER := "res:/" + "/workshop/kit/worker.gd"
const _CHUNK := 65536

## False where a test looks at the lab as it is in an export.
static var is_allowed := true

var _pid := -1
var _key := ""
var _input: FileAccess
var _errors: FileAccess
var _unread := PackedByteArray()


## Whether this program can start children: not in a browser, nor in an exported demo.
static func can_run() -> bool:
	var can_start := OS.has_feature("editor") and not OS.has_feature("web")
	return is_allowed and can_start and ResourceLoader.exists(_WORKER)


## Starts a child that judges what is in [param folder]. [param task] is `judge` or `tests`;
## [param told] is what was found out before: no exercise is judged twice.
func _init(task: String, folder: String, told := WorkshopReport.new()) -> void:
	_key = "vec2lab_%08x" % randi()
	var arguments: PackedStringArray = [
		"--headless",
		"--path",
		ProjectSettings.globalize_path("res:/" + "/"),
		"--log-file",
		OS.get_user_data_dir().path_join("workshop_child.log"),
		"-s",
		_WORKER,
		"--",
		task,
		ProjectSettings.globalize_path(folder),
		_key,
		TranslationServer.get_locale(),
		",".join(told.verdicts.keys()),
		",".join(told.stopped_methods()),
	]
	var pipes := OS.execute_with_pipe(OS.get_executable_path(), arguments, false)
	if pipes:
		_pid = pipes["pid"]
		_input = pipes["stdio"]
		_errors = pipes["stderr"]


## The number of its process; -1 where none could be started.
func id() -> int:
	return _pid


## Whether it runs. One that has ended may have left something to read.
func is_running() -> bool:
	return _pid > 0 and OS.is_process_running(_pid)


## What it has said since the last time, in order.
func said() -> Array[Dictionary]:
	var messages: Array[Dictionary] = []
	if _pid < 0:
		return messages
	_errors.get_buffer(_CHUNK)
	_unread.append_array(_input.get_buffer(_CHUNK))
	var end := _unread.rfind(10)
	if end < 0:
		return messages
	for line in _unread.slice(0, end).get_string_from_utf8().split("\n"):
		if line.begins_with(_key + " "):
			var message: Variant = JSON.parse_string(line.trim_prefix(_key + " "))
			if message is Dictionary:
				messages.append(WorkshopAny.dictionary(message))
	_unread = _unread.slice(end + 1)
	return messages


## Tells it something.
func tell(message: Dictionary) -> void:
	if is_running():
		_input.store_string(JSON.stringify(message) + "\n")
		_input.flush()


## Ends it.
func stop() -> void:
	if is_running():
		OS.kill(_pid)
	_pid = -1
