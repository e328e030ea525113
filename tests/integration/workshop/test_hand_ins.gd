extends LabTest
## What the judge says of hand-ins that are right, wrong, hostile and no code at all. All of them:
## `./lab check tests/data/hand_ins --into build/check`. Here a tenth, and one of each kind.

const Judging := preload("res://tools/grading/judging.gd")
const _ONE_IN := 12
const _ALWAYS: PackedStringArray = [
	"right_plain",
	"right_in_vectors",
	"right_untyped",
	"right_step",
	"right_segment",
	"right_aim",
	"hostile_loop",
	"hostile_recursion",
	"hostile_static_kill",
	"form_binary",
	"stopped_null",
	"copied_key",
]


func test_the_verdicts_are_those_of_the_table() -> void:
	var names := _names()
	assert_gt(names.size(), 100)
	for index in names.size():
		if index % _ONE_IN == 0 or names[index] in _ALWAYS:
			_judge(names[index])


func test_every_wrong_way_that_the_tests_have_to_find_has_a_hand_in() -> void:
	var numbers: Dictionary[int, Dictionary] = {}
	for row in HandIns.expected():
		var of_exercise: Dictionary = numbers.get_or_add(row.exercise, {})
		of_exercise[row.mistake] = true
	for exercise in WorkshopIndex.exercises():
		for task in exercise.tasks:
			for way in task.ways:
				if not way.is_extra and way.number != 0 and not way.spoils_inputs:
					var told := "%s, mistake %d" % [task.method, way.number]
					assert_has(numbers[exercise.number], way.number, told)


func test_a_verdict_that_differs_is_found() -> void:
	var row: HandIns.Expected = HandIns.expected()[0]
	var verdict := WorkshopVerdict.new()
	verdict.kind = WorkshopVerdict.Kind.MISTAKE
	assert_ne(HandIns.difference(row, verdict), "")
	assert_ne(HandIns.difference(row, null), "")


func _names() -> PackedStringArray:
	return DirAccess.get_directories_at(HandIns.FOLDER)


func _judge(hand_in_name: String) -> void:
	var judging := Judging.new(HandIns.FOLDER.path_join(hand_in_name))
	judging.judge()
	for row: HandIns.Expected in HandIns.expected():
		if row.hand_in == hand_in_name:
			var verdict := judging.report.verdict(row.exercise)
			assert_eq(HandIns.difference(row, verdict), "")
