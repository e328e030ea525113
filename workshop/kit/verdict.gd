class_name WorkshopVerdict
extends RefCounted
## What the judge says of one exercise. It travels as JSON from the child to the lab; its numbers
## come through to the last bit.

## What became of the exercise. OPEN: nothing is written yet. MISTAKE: a known one. UNKNOWN: wrong
## in a way that nobody has seen. UNREADABLE: the file has a mistake of form. BROKEN: the engine
## stopped the method. ENDLESS: it does not come to an end. MEMORY: it takes too much of that.
## REFUSED: it is not run, look by hand. MISSING: a method, or the file, is not there. WAITING: for
## another file or exercise. CRASHED: the engine itself ended.
enum Kind {
	OPEN,
	RIGHT,
	MISTAKE,
	UNKNOWN,
	UNREADABLE,
	BROKEN,
	ENDLESS,
	MEMORY,
	REFUSED,
	MISSING,
	WAITING,
	CRASHED,
}

const _TEXTS: PackedStringArray = ["method", "sentence", "file", "probe"]
const _WHOLE: PackedStringArray = ["exercise", "kind", "mistake", "line"]
const _LISTS: PackedStringArray = ["asked", "got", "wanted", "costs"]

## The number of the exercise.
var exercise := 0
## What became of it.
var kind := Kind.OPEN
## The number of the mistake in the course's list; 0 where it has none there, below 0 for a part of
## the lecture.
var mistake := 0
## The method that is meant, "" for none.
var method := ""
## ONE sentence to the student, in the language of the lab.
var sentence := ""
## The file that is meant, such as `my_vec2.gd`.
var file := ""
## The line in it, from 1; 0 for none.
var line := 0
## The call that is meant, in words; "" for none.
var probe := ""
## The plain numbers that were handed over there.
var asked: PackedFloat64Array = []
## What the student's method answered there; empty for nothing.
var got: PackedFloat64Array = []
## What is right there.
var wanted: PackedFloat64Array = []
## For a right exercise: nanoseconds for one call of the student's method, the same for the lab's,
## the ratio of both, and the largest error on all probes. Empty otherwise; see the methods below.
var costs: PackedFloat64Array = []
## Whether it is right for the mark "excellent", too.
var is_excellent := false


## The verdict on [param its_exercise], of which nothing is written yet.
static func of_open(its_exercise: WorkshopExercise) -> WorkshopVerdict:
	var verdict := WorkshopVerdict.new()
	verdict.exercise = its_exercise.number
	verdict.method = its_exercise.tasks[0].method
	verdict.file = WorkshopFiles.file_of(its_exercise.home())
	verdict.sentence = sentence_of_open(verdict.method, verdict.file)
	return verdict


## What is said of a method that is as in the starter.
static func sentence_of_open(its_method: String, its_file: String) -> String:
	return LabText.translate("Write %s in %s.") % [its_method, its_file]


## What is said of a method that had to be ended while it ran for [param its_probe].
static func sentence_of_end(its_kind: Kind, its_method: String, its_probe: String) -> String:
	var form := LabText.translate("%s does not come to an end for %s.")
	if its_kind == Kind.MEMORY:
		form = LabText.translate("%s takes too much memory for %s.")
	return form % [its_method, its_probe]


## Numbers as a student reads them.
static func text_of(numbers: PackedFloat64Array) -> String:
	var texts: PackedStringArray = []
	for number in numbers:
		texts.append(NumberText.short(number))
	return texts[0] if texts.size() == 1 else "(%s)" % ", ".join(texts)


## Whether the exercise is solved.
func is_right() -> bool:
	return kind == Kind.RIGHT


## Nanoseconds for one call of the student's method; NaN where it was not measured.
func nanoseconds() -> float:
	return costs[0] if costs else NAN


## Nanoseconds for one call of the lab's own method; NaN where it was not measured.
func reference_nanoseconds() -> float:
	return costs[1] if costs else NAN


## How many times as long as the lab's own method the student's takes; NaN where it was not
## measured.
func ratio() -> float:
	return costs[2] if costs else NAN


## The largest difference from the right answers on all probes; NaN where it was not measured.
func error() -> float:
	return costs[3] if costs else NAN


## All of it, for JSON.
func to_dictionary() -> Dictionary:
	var all := {"excellent": is_excellent}
	for field in _TEXTS + _WHOLE:
		all[field] = get(field)
	for field in _LISTS:
		var numbers: PackedFloat64Array = get(field)
		all[field] = bits_of(numbers)
	return all


## A verdict from what [method to_dictionary] made.
static func from_dictionary(all: Dictionary) -> WorkshopVerdict:
	var verdict := WorkshopVerdict.new()
	verdict.is_excellent = all["excellent"]
	for field in _TEXTS:
		verdict.set(field, all[field])
	for field in _WHOLE:
		var whole: float = all[field]
		verdict.set(field, int(whole))
	for field in _LISTS:
		var bits: String = all[field]
		verdict.set(field, numbers_of(bits))
	return verdict


## Doubles as a text that keeps every bit.
static func bits_of(numbers: PackedFloat64Array) -> String:
	return numbers.to_byte_array().hex_encode()


## The doubles in a text that [method bits_of] made.
static func numbers_of(bits: String) -> PackedFloat64Array:
	return bits.hex_decode().to_float64_array()
