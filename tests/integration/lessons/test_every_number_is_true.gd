extends ScreenTest
## With the numbers that it shows, each line of each formula gives what it says, in 200 states of
## the lesson and at each of its steps. `./lab true` looks at more states, and at other lessons.

const _STATES := 200
const _SEED := 7


func test_every_line_gives_what_it_says(id: StringName = use_parameters(_ids())) -> void:
	await open_lesson(LessonIndex.find(id))
	var truth := LessonTruth.new(frame())
	await truth.look_at(_STATES, _SEED)
	for finding in truth.findings:
		fail_test(finding.text())
	assert_gt(truth.read_count, _STATES - 1, "formulas were read")


func _ids() -> Array[StringName]:
	var ids: Array[StringName] = []
	for info in LessonIndex.lessons():
		ids.append(info.id)
	return ids
