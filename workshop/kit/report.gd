class_name WorkshopReport
extends RefCounted
## What the judge says of all that the student has written.

## How far the student has come by the course's rubric.
enum Mark { NOT_YET, SUFFICIENT, GOOD, EXCELLENT }

## The exercises that each mark asks for, with those of the marks below it.
const SUFFICIENT: PackedInt32Array = [2, 3, 9]
## See [constant SUFFICIENT].
const GOOD: PackedInt32Array = [4, 5, 6, 7, 8, 10]
## See [constant SUFFICIENT].
const EXCELLENT: PackedInt32Array = [11, 13, 14, 15]
## The part of the mistakes that his tests must find for "good".
const GOOD_SHARE := 0.8
## After so many methods that ended their child nothing more is tried, because each takes its time.
const MOST_STOPPED := 2
# Kinds of verdicts on a method that ends its child.
const _STOPPING: Array[WorkshopVerdict.Kind] = [
	WorkshopVerdict.Kind.ENDLESS, WorkshopVerdict.Kind.MEMORY, WorkshopVerdict.Kind.CRASHED
]
# Kinds of verdicts with which a method can be asked: not where there is nothing to run, nor where
# it would only end the child once more.
const _ANSWERING: Array[WorkshopVerdict.Kind] = [
	WorkshopVerdict.Kind.RIGHT,
	WorkshopVerdict.Kind.MISTAKE,
	WorkshopVerdict.Kind.UNKNOWN,
	WorkshopVerdict.Kind.BROKEN,
]

## A verdict for each exercise that has been judged, by its number.
var verdicts: Dictionary[int, WorkshopVerdict] = {}
## What his own tests are worth; null before they were judged.
var tests: WorkshopTestsVerdict = null
## Whether every exercise has its verdict; what was endless is told before the others are judged.
var is_complete := false


## The verdict on an exercise; null before it was judged, and for the tests.
func verdict(exercise: int) -> WorkshopVerdict:
	return verdicts.get(exercise)


## Whether an exercise is solved.
func is_right(exercise: int) -> bool:
	if exercise == WorkshopIndex.TESTS:
		return tests != null and tests.red_on_right.is_empty() and tests.share() >= GOOD_SHARE
	return verdicts.has(exercise) and verdicts[exercise].is_right()


## The first exercise that is not solved yet, after 0, which is optional; 16 if all are.
func first_open() -> int:
	var exercise := 1
	while exercise <= WorkshopIndex.LAST and is_right(exercise):
		exercise += 1
	return exercise


## What he has reached by the rubric. The run time is told beside it and never lowers the mark.
func mark() -> Mark:
	if not _are_right(SUFFICIENT):
		return Mark.NOT_YET
	if not (_are_right(GOOD) and is_right(WorkshopIndex.TESTS)):
		return Mark.SUFFICIENT
	var finds_all := tests.missed.is_empty() and verdicts[9].is_excellent
	return Mark.EXCELLENT if _are_right(EXCELLENT) and finds_all else Mark.GOOD


## Whether [param method] can be asked for other numbers. The methods of an exercise before the one
## that its verdict is about are right.
func can_ask(method: String) -> bool:
	for exercise in WorkshopIndex.exercises():
		var place := exercise.tasks.find(exercise.task(method))
		var told := verdict(exercise.number)
		if place >= 0 and told:
			var stopped_at := exercise.tasks.find(exercise.task(told.method))
			return told.kind in _ANSWERING or place < stopped_at
	return false


## The name of a mark, translated.
static func name_of(of: Mark) -> String:
	match of:
		Mark.SUFFICIENT:
			return LabText.translate("sufficient")
		Mark.GOOD:
			return LabText.translate("good")
		Mark.EXCELLENT:
			return LabText.translate("excellent")
	return LabText.translate("not yet sufficient")


## Nothing is written yet: every exercise with methods is open. No child is needed to know that.
func leave_open() -> void:
	for exercise in WorkshopIndex.exercises():
		if exercise.tasks:
			verdicts[exercise.number] = WorkshopVerdict.of_open(exercise)
	is_complete = true


## The methods that ended the child in which they ran.
func stopped_methods() -> PackedStringArray:
	var found: PackedStringArray = []
	for number in _stopped_exercises():
		if verdicts[number].method:
			found.append(verdicts[number].method)
	return found


## A child has ended before all was judged; [param known] is how many verdicts there were when it
## began, -1 for the first one. What is open after this is for another child, unless it is complete.
func go_on_after_end(known: int) -> void:
	if verdicts.size() == known and _next_unjudged() >= 0:
		_tell(_next_unjudged(), WorkshopVerdict.Kind.CRASHED)
	if _stopped_exercises().size() >= MOST_STOPPED:
		while _next_unjudged() >= 0:
			_tell(_next_unjudged(), WorkshopVerdict.Kind.WAITING)
	is_complete = _next_unjudged() < 0


## All of it, for JSON.
func to_dictionary() -> Dictionary:
	var list := []
	for number in verdicts:
		list.append(verdicts[number].to_dictionary())
	var all := {"complete": is_complete, "verdicts": list}
	if tests:
		all["tests"] = tests.to_dictionary()
	return all


## Takes over what [method to_dictionary] made; what it says nothing about stays.
func take(all: Dictionary) -> void:
	is_complete = all["complete"]
	var list: Array = all["verdicts"]
	for each: Dictionary in list:
		var told := WorkshopVerdict.from_dictionary(each)
		verdicts[told.exercise] = told
	if all.has("tests"):
		var told: Dictionary = all["tests"]
		tests = WorkshopTestsVerdict.from_dictionary(told)


func _are_right(exercises: PackedInt32Array) -> bool:
	for exercise in exercises:
		if not is_right(exercise):
			return false
	return true


func _stopped_exercises() -> PackedInt32Array:
	var found: PackedInt32Array = []
	for number in verdicts:
		if verdicts[number].kind in _STOPPING:
			found.append(number)
	return found


func _next_unjudged() -> int:
	for exercise in WorkshopIndex.exercises():
		if exercise.tasks and not verdicts.has(exercise.number):
			return exercise.number
	return -1


func _tell(exercise: int, kind: WorkshopVerdict.Kind) -> void:
	var told := WorkshopVerdict.new()
	told.exercise = exercise
	told.kind = kind
	told.sentence = LabText.translate("Godot itself ended while it ran your code.")
	if kind == WorkshopVerdict.Kind.WAITING:
		told.sentence = LabText.translate("Two methods had to be stopped: mend them first.")
	verdicts[exercise] = told
