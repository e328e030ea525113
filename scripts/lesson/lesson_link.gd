class_name LessonLink
extends RefCounted
## The state of a lesson's board as a short text that people can read and a web address can hold,
## and back: `a=7,1&b=8,-6`.
##
## Only what differs from the state that the reader has anyway is named. Numbers come back to the
## last bit. A state holds, by name: true or false, whole numbers, numbers, words, lists of a fixed
## length (`PackedFloat64Array`, written `7,1`), and arrays of any number of such lists (written
## `0,0,4,3;5,5,9,8`).

## No text longer than this is read.
const LONGEST := 16000
## An array holds at most this many lists.
const MOST_LISTS := 100

# A refused text is quoted with at most this many letters.
const _LONGEST_QUOTE := 30
# Values that chats, mails, shops and searches add to links, to see who follows them: each known by
# its name. Another unknown name is a mistake of somebody who should be told.
const _TRACKERS: PackedStringArray = [
	"fbclid",
	"gclid",
	"dclid",
	"gbraid",
	"wbraid",
	"gad_source",
	"gad_campaignid",
	"srsltid",
	"msclkid",
	"twclid",
	"ttclid",
	"yclid",
	"li_fat_id",
	"igsh",
	"igshid",
	"mibextid",
	"mc_cid",
	"mc_eid",
	"mkt_tok",
	"vero_id",
	"ref",
	"ref_src",
	"trk",
	"si",
	"sa",
	"source",
	"ust",
	"usg",
	"ved",
	"_ga",
	"_gl",
	"_hsenc",
	"_hsmi",
	"__cft__[0]",
	"__tn__",
]
const _TRACKER_OF_MAILS := "utm_"

## The state that was read; meaningless if there is a [member problem].
var state: Dictionary
## "" if the text could be read; else one sentence with the value and what is allowed, translated.
var problem := ""

var _named: PackedStringArray = []


## What of [param state_now] differs from [param base], which has the same names and kinds. "" where
## nothing does.
static func text_of(state_now: Dictionary, base: Dictionary) -> String:
	var parts: PackedStringArray = []
	for name: String in state_now:
		var text := _value_text(state_now[name])
		# Texts are compared and not values: 0 and -0 are two numbers here.
		if text != _value_text(base[name]):
			parts.append("%s=%s" % [name, text])
	return "&".join(parts)


## Reads what [method text_of] has written, or what somebody has typed; what is not named is as in
## [param base].
static func read(text: String, base: Dictionary) -> LessonLink:
	var link := LessonLink.new()
	link.state = base.duplicate(true)
	if text.length() > LONGEST:
		var sentence := LabText.translate("The link has %d characters; there may be at most %d.")
		link.problem = sentence % [text.length(), LONGEST]
		return link
	for part in text.split("&", false):
		if not link.problem:
			link._take(part, base)
	return link


## [param text] as it is quoted in a sentence: its beginning, if it is long.
static func quoted(text: String) -> String:
	return text if text.length() <= _LONGEST_QUOTE else text.left(_LONGEST_QUOTE) + "…"


static func _value_text(value: Variant) -> String:
	match typeof(value):
		TYPE_FLOAT:
			var number: float = value
			return DecimalText.of(number)
		TYPE_PACKED_FLOAT64_ARRAY:
			var list: PackedFloat64Array = value
			return _list_text(list)
		TYPE_ARRAY:
			var lists: Array = value
			return ";".join(lists.map(_list_text))
	return str(value)


static func _list_text(list: PackedFloat64Array) -> String:
	return ",".join(Array(list).map(DecimalText.of))


func _take(part: String, base: Dictionary) -> void:
	var name := part.get_slice("=", 0)
	if not base.has(name):
		if name in _TRACKERS or name.begins_with(_TRACKER_OF_MAILS):
			return
		var sentence := LabText.translate("There is no value “%s” here. There are: %s.")
		problem = sentence % [quoted(name), ", ".join(base.keys())]
	elif not part.contains("="):
		problem = LabText.translate("“%s” has no value: write %s=… behind it.") % [name, name]
	elif name in _named:
		problem = LabText.translate("“%s” is there twice.") % [name]
	else:
		_named.append(name)
		_take_value(name, part.trim_prefix(name + "="), base[name])


# The value at the lesson's start says which kind of value it must be.
func _take_value(name: String, text: String, first: Variant) -> void:
	match typeof(first):
		TYPE_BOOL:
			_take_switch(name, text)
		TYPE_INT:
			_take_whole_number(name, text)
		TYPE_FLOAT:
			state[name] = _number(name, text)
		TYPE_PACKED_FLOAT64_ARRAY:
			var list: PackedFloat64Array = first
			state[name] = _numbers(name, text, list.size())
		TYPE_ARRAY:
			var lists: Array[PackedFloat64Array] = first
			_take_lists(name, text, lists[0].size())
		_:
			state[name] = text


func _take_switch(name: String, text: String) -> void:
	state[name] = text == "true"
	if text != "true" and text != "false":
		problem = LabText.translate("%s must be true or false, not “%s”.") % [name, quoted(text)]


func _take_whole_number(name: String, text: String) -> void:
	var number := DecimalText.value_of(text)
	if number == roundf(number) and absf(number) < 1e9:
		state[name] = int(number)
	else:
		problem = LabText.translate("%s must be a whole number, not “%s”.") % [name, quoted(text)]


func _take_lists(name: String, text: String, length: int) -> void:
	var lists: Array[PackedFloat64Array] = []
	var texts := text.split(";") if text else PackedStringArray()
	if texts.size() > MOST_LISTS:
		var sentence := LabText.translate("%s has %d parts; there may be at most %d.")
		problem = sentence % [name, texts.size(), MOST_LISTS]
		return
	for list_text in texts:
		if not problem:
			lists.append(_numbers(name, list_text, length))
	state[name] = lists


func _numbers(name: String, text: String, count: int) -> PackedFloat64Array:
	var texts := text.split(",")
	if texts.size() != count:
		var sentence := LabText.translate("%s must have %d numbers, not %d: “%s”.")
		problem = sentence % [name, count, texts.size(), quoted(text)]
		return []
	var numbers: PackedFloat64Array = []
	for number_text in texts:
		if not problem:
			numbers.append(_number(name, number_text))
	return numbers


func _number(name: String, text: String) -> float:
	var number := DecimalText.value_of(text)
	if is_nan(number):
		var sentence := LabText.translate(
			"“%s” in %s must be a number: 0, or from 1e-100 to 1e100 in size."
		)
		problem = sentence % [quoted(text), name]
	return number
