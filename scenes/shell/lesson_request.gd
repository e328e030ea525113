class_name LessonRequest
extends RefCounted
## Which lesson was asked for when the lab was started: `-- --lesson=<id>`, or `#<id>` in a
## browser's address.

const _ARGUMENT := "--lesson="

static var _is_taken := false


## The id asked for; "" where none was. Asks once: who comes back from the lesson finds the start
## screen.
static func take_id() -> String:
	if _is_taken:
		return ""
	_is_taken = true
	return _requested_id()


## One sentence for an id that is in no lesson.
static func refusal(id: String) -> String:
	var sentence := TranslationServer.translate("There is no lesson “%s”. There are: %s.")
	return sentence % [id, ", ".join(LessonIndex.ids())]


## The id in `--lesson=<id>`, the first of these command-line arguments that has that form; "" where
## none has.
static func id_in_arguments(arguments: PackedStringArray) -> String:
	for argument in arguments:
		if argument.begins_with(_ARGUMENT):
			return argument.trim_prefix(_ARGUMENT)
	return ""


## The id in the part of a browser's address from `#` on; "" where there is none.
static func id_in_fragment(fragment: String) -> String:
	return fragment.trim_prefix("#").uri_decode()


static func _requested_id() -> String:
	var id := id_in_arguments(OS.get_cmdline_user_args())
	if not id and OS.has_feature("web"):
		var fragment: Variant = JavaScriptBridge.eval("window.location.hash")
		return id_in_fragment(str(fragment))
	return id
