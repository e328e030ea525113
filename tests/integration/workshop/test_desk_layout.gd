extends DeskTest
## With the section on the student's own code open, a lesson fits in windows of every size: at its
## last step, with a wrong answer that is told with its numbers, and with a right one.

const MeasureLayout := preload("res://tools/checks/measure_layout.gd")
const _SIZES: Array[Vector2i] = [Vector2i(390, 844), Vector2i(720, 1280), Vector2i(1280, 720)]
const _PHONE := Vector2i(390, 844)
# His tests find some of the mistakes.
const _TEST := "assert_eq(MyVec2.new(7.0, 1.0).dot(MyVec2.new(8.0, -6.0)), 50.0)"


func test_every_lesson_with_exercises_is_looked_at() -> void:
	for lesson in LessonIndex.lessons():
		var has_exercises := not WorkshopIndex.of_lesson(lesson.id).is_empty()
		assert_eq(MeasureLayout.WRONG.has(str(lesson.id)), has_exercises, lesson.id)


func test_it_fits_with_a_wrong_answer() -> void:
	for lesson in MeasureLayout.WRONG:
		await save_hand_in(MeasureLayout.WRONG[lesson])
		for size in _SIZES:
			await _look(lesson, size, "%Probe")


func test_it_fits_with_a_right_one_and_tests() -> void:
	await _save_right()
	for lesson in MeasureLayout.WRONG:
		for size in _SIZES:
			await _look(lesson, size, "%Costs")
			assert_true((section().get_node("%Tests") as Control).visible)


func test_it_fits_on_a_phone_with_large_text_in_dutch() -> void:
	LabText.speak("nl")
	await save_hand_in(MeasureLayout.WRONG["dot_product"])
	KeptChoices.keep("text_size", WindowFit.TEXT_SIZES[-1])
	await _look("dot_product", _PHONE, "%Probe")
	await _save_right()
	await _look("dot_product", _PHONE, "%Costs")
	KeptChoices.keep("text_size", WindowFit.TEXT_SIZES[0])
	WindowFit.fit(student.window)


func _save_right() -> void:
	for hand_in in MeasureLayout.RIGHT:
		await save_hand_in(hand_in)
	var empty := "func test_dot() -> void:\n\tpass"
	var tests := WorkshopFiles.starter("test_my_vec2.gd")
	save_file("test_my_vec2.gd", tests.replace(empty, empty.replace("pass", _TEST)))
	await wait_for(func() -> bool: return watcher.report.tests != null)


func _look(lesson: String, size: Vector2i, part: String) -> void:
	if screen():
		screen().free()
	await resize(size)
	await open_with_desk(lesson)
	await student.settle()
	assert_false(section().folded, lesson)
	assert_true((section().get_node(part) as Control).visible, "%s in %s" % [part, lesson])
	var survey := LayoutSurvey.new()
	await survey.look_at(frame(), "%s at %s" % [lesson, size], 0, false)
	assert_true(survey.problems.is_empty(), str(survey.problems))
