extends ScreenTest
## What the lesson on balls among lines says is true after a run, too; and its judge finds what is
## false. `test_every_number_is_true.gd` has the judge look at states before a run.

const _JUDGE := preload("res://tests/integration/lessons/angled_lines/angled_lines_judge.gd")
const _STATES := 24
const _FRAMES := 20

var _judge: _JUDGE


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"angled_lines"))
	_judge = _JUDGE.new()


func test_all_that_is_said_after_a_run_is_true() -> void:
	var lesson := frame().lesson
	var states := LessonStates.new(lesson, 11)
	var problems: PackedStringArray = []
	for i in _STATES:
		lesson.show_link(states.state(i))
		_judge.start = lesson.link_state()
		for frame_number in _FRAMES:
			(lesson.get_node("%Player") as AngledLinesPlayer).step(true)
		for step in 3:
			_steps().go_to(step)
			var problem := _judge.problem(SeenLesson.of(frame()))
			if problem and problems.size() < 8:
				problems.append("step %d: %s  #%s" % [step + 1, problem, frame().link.text()])
		await get_tree().process_frame
	assert_eq("\n".join(problems), "")


func test_the_judge_finds_what_is_false() -> void:
	_steps().go_to(1)
	assert_eq(_judge.problem(SeenLesson.of(frame())), "")
	for wrong: Callable in [
		func(seen: SeenLesson) -> void:
			seen.sentence = "The dots show its path in the next 1.5 s: no bounce.",
		func(seen: SeenLesson) -> void: seen.sentence = "The ball is lost: it has left the board.",
		func(seen: SeenLesson) -> void: seen.sentence = "Something new.",
		func(seen: SeenLesson) -> void: seen.lines[1] = "P = ( −201 , −120 )   v = ( 160 , 0 )",
		func(seen: SeenLesson) -> void: seen.labels = ["bounces 0    lost 0\nE / E₀ = 0.9    s"],
		func(seen: SeenLesson) -> void: seen.labels = ["bounces 0    lost 1\nE / E₀ = 1    s"],
		func(seen: SeenLesson) -> void:
			seen.rows = [PackedStringArray(["reset", "1", "0", "3 µs"])],
	]:
		var seen := SeenLesson.of(frame())
		wrong.call(seen)
		assert_ne(_judge.problem(seen), "")


func _steps() -> Steps:
	return frame().lesson.services[&"steps"] as Steps
