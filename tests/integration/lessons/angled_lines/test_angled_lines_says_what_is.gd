extends ScreenTest
## What the lesson on balls among lines says is true in many states, at each step, at the start and
## after a run.

const _JUDGE := preload("res://tests/integration/lessons/angled_lines/angled_lines_judge.gd")
const _STATES := 24
const _FRAMES := 20


func test_all_that_is_said_is_true() -> void:
	await open_lesson(LessonIndex.find(&"angled_lines"))
	var lesson := frame().lesson
	var states := LessonStates.new(lesson, 11)
	var problems: PackedStringArray = []
	for i in _STATES:
		lesson.show_link(states.state(i))
		var first := lesson.state()
		for step in 3:
			(lesson.services[&"steps"] as Steps).go_to(step)
			_judge(first, step, problems)
		for frame_number in _FRAMES:
			(lesson.get_node("%Player") as AngledLinesPlayer).step(true)
		for step in 3:
			(lesson.services[&"steps"] as Steps).go_to(step)
			_judge(first, step, problems)
		await get_tree().process_frame
	assert_eq("\n".join(problems), "")


func _judge(first: Dictionary, step: int, problems: PackedStringArray) -> void:
	var texts := Screen.texts(frame())
	texts.append_array(Screen.lines(frame().lesson.services[&"formula"] as Formula))
	var problem := _JUDGE.problem(frame().lesson.state(), first, step, texts)
	if problem and problems.size() < 8:
		problems.append("step %d: %s  #%s" % [step + 1, problem, frame().link.text()])
