extends LabTest
## What becomes of the exercises behind one that has ended its child.

const _FIRST := 3
const _SECOND := 5

var _report: WorkshopReport


func before_each() -> void:
	_report = WorkshopReport.new()


func test_after_one_the_others_are_judged() -> void:
	_stop_at(_FIRST, "dot")
	_report.go_on_after_end(-1)
	assert_false(_report.is_complete)
	assert_eq(_report.verdicts.size(), 1)
	assert_eq(_report.stopped_methods(), PackedStringArray(["dot"]))


func test_after_two_the_others_wait() -> void:
	_stop_at(_FIRST, "dot")
	_stop_at(_SECOND, "distance_to_line")
	_report.go_on_after_end(1)
	assert_true(_report.is_complete)
	for exercise in WorkshopIndex.exercises():
		if exercise.tasks and not exercise.number in [_FIRST, _SECOND]:
			var verdict := _report.verdict(exercise.number)
			assert_eq(verdict.kind, WorkshopVerdict.Kind.WAITING)


func test_a_child_that_says_nothing_has_crashed_but_not_the_first_time() -> void:
	_report.go_on_after_end(-1)
	assert_eq(_report.verdicts.size(), 0)
	_report.go_on_after_end(0)
	assert_eq(_report.verdicts.size(), 1)
	assert_eq(_report.verdict(0).kind, WorkshopVerdict.Kind.CRASHED)
	assert_false(_report.is_complete)


func _stop_at(exercise: int, method: String) -> void:
	var verdict := WorkshopVerdict.new()
	verdict.exercise = exercise
	verdict.method = method
	verdict.kind = WorkshopVerdict.Kind.ENDLESS
	_report.verdicts[exercise] = verdict
