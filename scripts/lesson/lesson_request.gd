class_name LessonRequest
extends RefCounted
## Which lesson was asked for, and which state of its board: `-- --lesson=<id>?<state>` when the lab
## was started, or `#<id>?<state>` in a browser's address. The state may be left out.

const _ARGUMENT := "--lesson="
# What a chat or a mail puts behind a link, some of it to show the link in bold or as code.
const _BEHIND := ".,;:!?…)]}>»«\"'”’*_~`|/# "
# What a mail breaks lines with, what a chat hides in a link, and what Markdown puts before a sign.
const _INSIDE := (
	"[\\t\\r\\n\\\\\\x{ad}\\x{200b}-\\x{200f}" + "\\x{202a}-\\x{202e}\\x{2060}-\\x{2069}\\x{feff}]"
)
# A link that went through several hands has its signs escaped more than once.
const _MOST_ESCAPES := 3
# A letter as an address writes it, in 1 to 3 bytes. Others cannot belong to a request.
const _ESCAPE := "(?i)%(?:0[9ad]|[2-7][\\da-f]|(?:c[2-9a-f]|d[\\da-f]|e[1-9a-cef]%NEXT)%NEXT)"
const _NEXT_BYTE := "[89ab][\\da-f]"

static var _is_read := false
static var _id := ""
# The state asked for, as LessonLink reads it, and of which lesson.
static var _state := ""
static var _lesson_of_state := ""


## From now on [param text], such as `dot_product?a=7,1` or a whole address, is what was asked for.
## It may look as chats and mails leave it: `<#/Dot_Product/?a=7,1&amp;b=8,-6>.`
static func ask(text: String) -> void:
	_is_read = true
	var plain := _plain(text)
	_id = _id_of(plain)
	_lesson_of_state = _id
	_state = plain.trim_prefix(plain.get_slice("&", 0)).trim_prefix("&").replace(" ", "")


## The id of the lesson that [param text] asks for; "" where it asks for none.
static func id_in(text: String) -> String:
	return _id_of(_plain(text))


## The id asked for; "" if none was. Only the first call returns it: later the start screen stays
## open.
static func take_id() -> String:
	if not _is_read:
		ask(_text_at_start())
	var id := _id
	_id = ""
	return id


## The state asked for of the lesson [param id]; "" if none was. Only the first call returns it,
## whichever lesson it asks for.
static func take_state(id: String) -> String:
	var state := state_for(id)
	_state = ""
	return state


## The same, and a later call returns it, too.
static func state_for(id: String) -> String:
	return _state if id == _lesson_of_state else ""


## The text in `--lesson=<...>`, the first of these command-line arguments that has that form; ""
## where none has.
static func text_in_arguments(arguments: PackedStringArray) -> String:
	for argument in arguments:
		if argument.begins_with(_ARGUMENT):
			return argument.trim_prefix(_ARGUMENT)
	return ""


static func _text_at_start() -> String:
	var text := text_in_arguments(OS.get_cmdline_user_args())
	return text if text else WebPage.fragment()


# As it was before chats and mails touched it, with & between all its parts.
static func _plain(text: String) -> String:
	var plain := text
	for i in _MOST_ESCAPES:
		plain = _without_escapes(plain).xml_unescape()
	plain = RegEx.create_from_string(_INSIDE).sub(plain, "", true)
	plain = plain.to_lower().replace("\u00a0", " ").rstrip(_BEHIND)
	return plain.substr(plain.find("#") + 1).lstrip("/! ").replace("?", "&")


static func _id_of(plain: String) -> String:
	return plain.get_slice("&", 0).rstrip("/ ")


# The engine decodes escapes in capitals only: %2C, not %2c.
static func _without_escapes(text: String) -> String:
	var plain := text
	for escape in RegEx.create_from_string(_ESCAPE.replace("NEXT", _NEXT_BYTE)).search_all(text):
		plain = plain.replace(escape.get_string(), escape.get_string().to_upper().uri_decode())
	return plain
