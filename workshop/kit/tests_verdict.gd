class_name WorkshopTestsVerdict
extends RefCounted
## What the student's own tests are worth: are they green on the right classes, and red on every
## wrong way?

const _LISTS: PackedStringArray = [
	"test_names", "red_on_right", "never_red", "found", "missed", "unreadable"
]

## The names of his tests.
var test_names: PackedStringArray = []
## A sentence for each test that is red on the right classes: its name, and why.
var red_on_right: PackedStringArray = []
## The names of tests that cannot fail: they stay green whatever the methods answer that they call.
var never_red: PackedStringArray = []
## The wrong ways for which a test went red, as `dot: ` and the sentence of the mistake.
var found: PackedStringArray = []
## The wrong ways for which all stayed green.
var missed: PackedStringArray = []
## A sentence for each file that could not be run.
var unreadable: PackedStringArray = []
## Whether GUT itself ran them; otherwise its stand-in did.
var is_by_gut := true
## Whether they came to their end.
var is_complete := false


## The part of the wrong ways that was found, 0 to 1. What is red on the right classes finds
## nothing.
func share() -> float:
	var count := found.size() + missed.size()
	return float(found.size()) / count if count > 0 else 0.0


## ONE sentence to the student.
func sentence() -> String:
	if unreadable:
		return unreadable[0]
	if red_on_right:
		return LabText.translate("Red on a right class: %s") % red_on_right[0]
	var told := LabText.translate("Your tests find %d of %d mistakes.")
	told = told % [found.size(), found.size() + missed.size()]
	if never_red:
		return told + " " + LabText.translate("%s cannot fail.") % never_red[0]
	return told


## All of it, for JSON.
func to_dictionary() -> Dictionary:
	var all := {"by_gut": is_by_gut, "complete": is_complete}
	for field in _LISTS:
		all[field] = get(field)
	return all


## The verdict on tests with which the engine itself ended.
static func of_crash() -> WorkshopTestsVerdict:
	var verdict := WorkshopTestsVerdict.new()
	verdict.unreadable.append(LabText.translate("Godot itself ended while it ran your tests."))
	return verdict


## A verdict from what [method to_dictionary] made.
static func from_dictionary(all: Dictionary) -> WorkshopTestsVerdict:
	var verdict := WorkshopTestsVerdict.new()
	verdict.is_by_gut = all["by_gut"]
	verdict.is_complete = all["complete"]
	for field in _LISTS:
		var list: Array = all[field]
		verdict.set(field, PackedStringArray(list))
	return verdict
