extends ScreenTest
## What the page around the lab is told about the screen.


func test_a_lesson_says_title_verdict_step_formula_and_readout() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	await go_to_step(4)
	var lines := _lines()
	assert_eq(lines[0], "4  The dot product")
	for line: String in [
		"+ Scalar projection 5",
		"Step 5 of 9 What is left of a, the rest a − p, is perpendicular to b.",
		"a = (7, 1)",
		"a · b = 7·8 + 1·(−6) = 50",
	]:
		assert_has(lines, line)
	await go_to_step()
	var start := "a · b\u0302 by the dot product: 5, error 0, run time "
	assert_string_starts_with(_line_with("a · b\u0302 by the dot product: "), start)


func test_what_is_dragged_is_told() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	await student.enter(Screen.named(screen(), "x of a") as LineEdit, "3")
	assert_has(_lines(), "a = (3, 1)")


func test_a_notice_is_told_while_it_is_shown() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	await student.press(&"lab_copy_link")
	assert_ne(_line_with("✓ Copied: "), "")
	await student.press_key(KEY_F9)
	assert_eq(_line_with("✓ Copied: "), "")


func test_a_question_is_told_once_it_is_unfolded() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	var question := frame().lesson.services[&"question"] as Question
	var prompt := (question.get_node("%Prompt") as Label).text
	assert_does_not_have(_lines(), prompt)
	question.folded = false
	await student.settle()
	assert_has(_lines(), prompt)


func test_status_list_and_table_of_the_lesson_with_most_to_say() -> void:
	await open_lesson(LessonIndex.find(&"angled_lines"))
	assert_string_starts_with(_line_with("Frame 0"), "Frame 0, 0.00 s")
	assert_eq(_line_with("How a frame"), "How a frame is stepped: Rest used")
	assert_eq(_line_with("Known mistakes"), "Known mistakes: No mistake")
	assert_eq(_line_with("g = "), "g = (0, 300)  C = 1")


func test_every_lesson_says_its_title_and_its_step_or_progress() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		assert_string_contains(_lines()[0], lesson.title)
		if "steps" in lesson.needs:
			assert_ne(_line_with("Step "), "", lesson.id)
		if "progress" in lesson.needs:
			assert_ne(_line_with("Run "), "", lesson.id)
		screen().free()


func test_the_start_screen_says_its_lessons() -> void:
	await open_start_screen()
	assert_has(_lines(), "4  The dot product")


func test_a_change_is_told_once_and_at_most_four_times_a_second() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	var text := PageText.new([screen()])
	screen().add_child(text)
	watch_signals(text)
	await student.settle()
	assert_signal_emit_count(text, "changed", 1)
	var notice := frame().get_node("%Notice") as Label
	(frame().get_node("%NoticePlace") as Control).show()
	# One second at 60 frames a second, with a new text in every frame.
	for i: int in 60:
		notice.text = str(i)
		await get_tree().process_frame
	var count: int = get_signal_emit_count(text, "changed")
	# The count includes the one signal from before this second.
	assert_gte(count, 4)
	assert_lte(count, 5)


func _lines() -> PackedStringArray:
	return PageText.of([screen()]).split("\n")


func _line_with(beginning: String) -> String:
	for line: String in _lines():
		if line.begins_with(beginning):
			return line
	return ""
