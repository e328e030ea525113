extends ScreenTest
## With the numbers that it shows, each line of each formula gives what it says, in 200 states of
## the lesson and at each of its steps; in fewer with each of the [Conventions]. `./lab true` looks
## at more states, and at other lessons.

const _STATES := 200
const _SAMPLE := 15
const _SEED := 7


func test_every_line_gives_what_it_says(id: StringName = use_parameters(_ids())) -> void:
	await _look_at(id, _STATES)


func test_with_each_convention_every_line_gives_what_it_says(
	id: StringName = use_parameters(_ids())
) -> void:
	for choices: Array in _choices():
		for choice: Conventions.Choice in Conventions.Choice.values():
			Conventions.choose(choice, choice in choices)
		await _look_at(id, _SAMPLE)
		screen().free()


func _look_at(id: StringName, states: int) -> void:
	await open_lesson(LessonIndex.find(id))
	var truth := LessonTruth.new(frame())
	await truth.look_at(states, _SEED)
	for finding in truth.findings:
		fail_test(finding.text())
	assert_gt(truth.read_count, states - 1, "formulas were read")


# Each of them, and both that change angles.
func _choices() -> Array[Array]:
	return [
		[Conventions.Choice.RADIANS, Conventions.Choice.Y_UP],
		[Conventions.Choice.FULL_TURN],
		[Conventions.Choice.RADIANS, Conventions.Choice.FULL_TURN],
	]


func _ids() -> Array[StringName]:
	var ids: Array[StringName] = []
	for info in LessonIndex.lessons():
		ids.append(info.id)
	return ids
