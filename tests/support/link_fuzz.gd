class_name LinkFuzz
extends RefCounted
## Links that somebody could send: right ones, extreme ones and wrong ones, the same for the same
## seed.

const _NUMBERS: PackedStringArray = [
	"0",
	"-0",
	"1",
	"-1",
	"0.5",
	"2",
	"7",
	"30",
	"45",
	"90",
	"1e-100",
	"-1e-100",
	"1e-30",
	"1e-9",
	"1e-3",
	"100",
	"799",
	"801",
	"1e6",
	"1.1e6",
	"1e15",
	"-4e15",
	"1e38",
	"1e39",
	"1e50",
	"1e100",
	"-1e100",
	"0.1",
	"3.3333333333333335",
	"-123.456",
	"255",
	"1e7",
	"-1e9"
]
const _WORDS: PackedStringArray = [
	"ball_in_box", "digits_of_pi", "event_world", "whole_frame", "point_of_impact", "no_such"
]
const _WRONG: PackedStringArray = [
	"",
	"nan",
	"inf",
	"-inf",
	"1e101",
	"1e999",
	"1e-101",
	"--1",
	"abc",
	"0x10",
	"1,2,3",
	"true",
	"∞",
	"%00",
	"1;2",
	"=",
	"\n",
	"99999999999999999999",
	"٣",
	"null",
	"[]",
	"a,a,a,a,a,a,a,a,a,a,a,a,a,a,a"
]

var _rng := RandomNumberGenerator.new()
var _is_tame := false


func _init(seed_number: int) -> void:
	_rng.seed = seed_number


## The link with this number to a lesson with the link state [param state]: in turn one with
## everyday values, one with extreme values, and a wrong one.
func text(number: int, state: Dictionary) -> String:
	_is_tame = number % 3 == 0
	return _wrong_text(state) if number % 3 == 2 else _random_text(state)


# Values of the right kinds, which a lesson need not be able to show.
func _random_text(state: Dictionary) -> String:
	var parts: PackedStringArray = []
	for name: String in state:
		if _rng.randf() < (0.2 if _is_tame else 0.5):
			parts.append("%s=%s" % [name, _value(state[name])])
	return "&".join(parts)


# Wrong in one place, or at least unusual.
func _wrong_text(state: Dictionary) -> String:
	var names: Array = state.keys()
	var name: String = names[_rng.randi() % names.size()]
	var wrong := _WRONG[_rng.randi() % _WRONG.size()]
	match _rng.randi() % 5:
		0:
			return name
		1:
			return "%s=%s&%s" % [name, _value(state[name]), _random_text(state)]
		2:
			return "%s=%s" % [wrong, _value(state[name])]
		3:
			return "%s=%s,%s" % [name, _value(state[name]), wrong]
	return "%s=%s" % [name, wrong]


func _value(first: Variant) -> String:
	match typeof(first):
		TYPE_BOOL:
			return ["true", "false"][_rng.randi() % 2]
		TYPE_INT:
			return str(_rng.randi_range(0, 1) if _is_tame else _rng.randi_range(-3, 30))
		TYPE_FLOAT:
			return _number()
		TYPE_PACKED_FLOAT64_ARRAY:
			var list: PackedFloat64Array = first
			return _list(list.size())
		TYPE_ARRAY:
			var lists: Array = first
			return _lists(lists)
	return _WORDS[_rng.randi() % _WORDS.size()]


func _number() -> String:
	if _is_tame:
		return str(_rng.randi_range(-10, 100) / 10.0 ** _rng.randi_range(0, 2))
	if _rng.randf() < 0.3:
		return DecimalText.of(_rng.randf_range(-300.0, 300.0))
	return _NUMBERS[_rng.randi() % _NUMBERS.size()]


func _list(length: int) -> String:
	var numbers: PackedStringArray = []
	for i in length:
		numbers.append(_number())
	return ",".join(numbers)


func _lists(lists: Array) -> String:
	var list: PackedFloat64Array = lists[0]
	var texts: PackedStringArray = []
	for i in _rng.randi() % 4:
		texts.append(_list(list.size()))
	return ";".join(texts)
