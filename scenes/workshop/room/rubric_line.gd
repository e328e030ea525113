class_name RubricLine
extends RefCounted
## One line of the rubric: what is asked for, what shows it in the lab, and how far the student is.

## What the student has to show for a line.
enum Proof { EXERCISES, EXCELLENT, TESTS, ALL_TESTS, RUN_TIME, OWN_PROJECT }
## How far a line is.
enum State { REACHED, OPEN, NOT_JUDGED }

## The mark to which it belongs.
var mark: WorkshopReport.Mark
## What is asked for, translated.
var text: String
## The exercises that show it.
var exercises: PackedInt32Array
## The id of the lesson that shows it; "" for none.
var lesson: String
## How it is shown; see [enum Proof].
var proof := Proof.EXERCISES
## The tests of this project that show it, as paths below `res://`.
var tests: PackedStringArray = []


func _init(
	its_mark: WorkshopReport.Mark,
	its_text: String,
	its_lesson: String,
	its_exercises: PackedInt32Array,
	its_proof: Proof = Proof.EXERCISES
) -> void:
	mark = its_mark
	text = its_text
	lesson = its_lesson
	exercises = its_exercises
	proof = its_proof


## The same line, shown by these tests of the project.
func tested_by(paths: PackedStringArray) -> RubricLine:
	tests = paths
	return self


## How far the student is with it.
func state(report: WorkshopReport) -> State:
	match proof:
		Proof.RUN_TIME, Proof.OWN_PROJECT:
			return State.NOT_JUDGED
		Proof.TESTS:
			return _state_of(report.is_right(WorkshopIndex.TESTS))
		Proof.ALL_TESTS:
			var finds_all := report.is_right(WorkshopIndex.TESTS) and report.tests.missed.is_empty()
			return _state_of(finds_all)
		Proof.EXCELLENT:
			var verdict := report.verdict(exercises[0])
			return _state_of(verdict and verdict.is_right() and verdict.is_excellent)
	return _state_of(_first_open(report) < 0)


## ONE sentence: what has been reached, or what comes next.
func told(report: WorkshopReport) -> String:
	match proof:
		Proof.OWN_PROJECT:
			return LabText.translate("Show it in your own project: the lab does not judge it.")
		Proof.RUN_TIME:
			return _told_run_time(report)
		Proof.TESTS, Proof.ALL_TESTS:
			if not WorkshopChild.can_run():
				return LabText.translate("Godot on your computer tells it, not the browser.")
			var unwritten := LabText.translate("Write your tests in %s.") % "test_my_vec2.gd"
			return report.tests.sentence() if report.tests else unwritten
		Proof.EXCELLENT:
			return _told_exercise(report, exercises[0])
	var open := _first_open(report)
	return LabText.translate("Reached.") if open < 0 else _told_exercise(report, open)


static func _state_of(is_reached: bool) -> State:
	return State.REACHED if is_reached else State.OPEN


# -1 where all are solved.
func _first_open(report: WorkshopReport) -> int:
	for exercise in exercises:
		if not report.is_right(exercise):
			return exercise
	return -1


static func _told_exercise(report: WorkshopReport, number: int) -> String:
	var verdict := report.verdict(number)
	var title := WorkshopIndex.exercise(number).title
	var sentence := verdict.sentence if verdict else LabText.translate("Not judged yet.")
	return LabText.translate("Exercise %d, %s: %s") % [number, title, sentence]


static func _told_run_time(report: WorkshopReport) -> String:
	var ratios: PackedFloat64Array = []
	for verdict: WorkshopVerdict in report.verdicts.values():
		if is_finite(verdict.ratio()):
			ratios.append(verdict.ratio())
	if not WorkshopChild.can_run():
		return LabText.translate("Godot on your computer tells it, not the browser.")
	if ratios.is_empty():
		return LabText.translate("It is measured as soon as an exercise is right.")
	ratios.sort()
	var median := NumberText.short(ratios[floori(ratios.size() / 2.0)], 2)
	return LabText.translate("Yours takes %s times as long as the lab's, in the median.") % median
