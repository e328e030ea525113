extends ScreenTest
## What a link says besides the board: a step, a language, hidden answers. And a link from the
## clipboard.

var _clipboard := ""


func before_all() -> void:
	super()
	LinkPaste.clipboard = func() -> String: return _clipboard


func after_all() -> void:
	LinkPaste.clipboard = DisplayServer.clipboard_get


func after_each() -> void:
	LessonRequest.ask("")
	LabText.speak(LabText.ENGLISH)
	await super.after_each()


func test_no_value_of_a_board_has_a_name_of_the_view() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		for key: String in frame().lesson.link_state():
			assert_does_not_have(LinkView.NAMES, key, lesson.id)
		screen().free()


func test_every_name_of_the_table_is_reserved() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	var view: LinkView = frame().link.get(&"_view")
	var parts: Dictionary = view.get(&"_parts")
	for key: String in parts:
		assert_has(LinkView.NAMES, key)


func test_a_link_opens_a_step_and_asks_nothing() -> void:
	await _open_link("dot_product?a=3,1&step=3")
	assert_reads("Step 3 of ")
	assert_eq(frame().link.text(), "dot_product?a=3,1&step=3")
	assert_does_not_read("Where does the shadow of a end?")


func test_every_step_of_every_lesson_is_copied_and_opened_again() -> void:
	for lesson in LessonIndex.lessons():
		await open_lesson(lesson)
		var count := frame().lesson.step_count
		assert_gt(count, 1, lesson.id)
		screen().free()
		for step: int in [1, 2, count]:
			var text := "%s?step=%d" % [lesson.id, step]
			await _open_link(text)
			assert_eq(frame().lesson.step, step - 1, text)
			assert_eq(frame().link.text(), str(lesson.id) if step == 1 else text)
			screen().free()


func test_a_step_that_is_not_there_is_refused_with_the_range() -> void:
	for step: String in ["0", "10", "-1", "1.5", "x", "1e300"]:
		await _open_link("dot_product?a=3,1&step=" + step)
		assert_reads(
			"This link cannot be opened: step must be a whole number within 1..9, not “%s”." % step
		)
		assert_eq(frame().link.text(), "dot_product", "and the board is at its start")
		screen().free()


func test_a_name_without_a_value_and_a_name_twice_are_refused() -> void:
	await _open_link("dot_product?step")
	assert_reads("“step” has no value")
	frame().follow_link("#dot_product?step=2&step=3")
	assert_reads("“step” is there twice.")


func test_a_link_that_names_no_step_leaves_the_one_that_is_shown() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	await go_to_step(4)
	frame().follow_link("#dot_product?a=3,1")
	assert_eq(frame().lesson.step, 4)
	frame().follow_link("#dot_product?a=3,1&step=2")
	assert_eq(frame().lesson.step, 1)


func test_who_steps_back_from_the_step_of_a_link_is_asked_once_what_was_skipped() -> void:
	await _open_link("easy_bounce?step=4")
	for press: int in 2:
		await student.press(&"lab_previous_step")
	var asked: PackedStringArray = [
		"Where must the centre go, so that the ball just touches?",
		"Which component of v changes its sign?"
	]
	for question in asked:
		await student.press(&"lab_next_step")
		assert_reads(question)
		await student.press(&"lab_next_step")
	assert_eq(frame().lesson.step, 3)
	await student.press(&"lab_previous_step")
	await student.press(&"lab_next_step")
	assert_does_not_read(asked[1])


func test_a_link_hides_the_answers_and_shows_them() -> void:
	await _open_link("dot_product?step=7&answers=off")
	var verdict := frame().lesson.get_node("%Verdict") as CanvasItem
	assert_eq(verdict.modulate.a, 0.0)
	assert_eq(frame().link.text(), "dot_product?step=7", "a copy does not hide them")
	frame().follow_link("#dot_product?answers=on")
	assert_eq(verdict.modulate.a, 1.0)
	frame().follow_link("#dot_product?answers=no")
	assert_reads("This link cannot be opened: answers must be on or off, not “no”.")


func test_a_link_speaks_a_language_as_long_as_the_lab_runs() -> void:
	await open_start_screen()
	await _follow("dot_product?lang=nl&step=2")
	assert_eq(LabText.language(), "nl")
	assert_eq(frame().lesson.step, 1)
	assert_reads(TranslationServer.translate("The dot product"))
	assert_ne(str(TranslationServer.translate("The dot product")), "The dot product")
	assert_eq(frame().link.text(), "dot_product?step=2&lang=nl")
	await student.press(&"lab_back")
	await student.press_key(KEY_ENTER)
	assert_eq(LabText.language(), "nl")
	assert_eq(str(KeptChoices.value("language", "")), "", "it is not kept as a choice")


func test_a_link_that_comes_while_its_lesson_is_open_shows_it_in_the_language_at_once() -> void:
	await open_start_screen()
	await _follow("dot_product")
	var first := frame()
	await _follow("dot_product?a=3,1&step=3&lang=nl")
	assert_ne(frame(), first)
	assert_eq(frame().link.text(), "dot_product?a=3,1&step=3&lang=nl")
	assert_does_not_read("Step 3 of")


func test_a_language_that_is_not_there_is_refused_with_those_there_are() -> void:
	await _open_link("dot_product?lang=xx")
	assert_reads("There is no language “xx” here. There are: en, nl.")
	assert_eq(LabText.language(), LabText.ENGLISH)


func test_a_link_with_a_language_alone_leaves_the_lesson_alive() -> void:
	OpeningMotion.is_allowed = true
	await _open_link("dot_product?lang=en")
	assert_true(frame().lesson.is_opening())
	screen().free()
	await _open_link("dot_product?step=2")
	assert_false(frame().lesson.is_opening())
	OpeningMotion.is_allowed = false


func test_a_link_is_pasted_on_the_board_and_on_the_start_screen() -> void:
	await open_start_screen()
	for text: String in ["#dot_product?a=3,1", "https://example.org/lab/#dot_product?a=3,1."]:
		_clipboard = text
		await student.press_key(KEY_V, false, true)
		assert_eq(frame().link.text(), "dot_product?a=3,1")
		_clipboard = "normals?mistake=9"
		await student.press_key(KEY_V, false, true)
		assert_eq(frame().link.text(), "normals?mistake=9")


func test_what_is_no_link_is_refused_when_it_is_pasted() -> void:
	await open_start_screen()
	for place: String in ["start screen", "lesson"]:
		_clipboard = ""
		await student.press_key(KEY_V, false, true)
		assert_reads("The clipboard holds no link.")
		_clipboard = "milk and bread"
		await student.press_key(KEY_V, false, true)
		assert_reads("There is no lesson “milk and bread”.")
		if not frame():
			await student.press_key(KEY_ENTER)
		assert_not_null(frame(), place)


func test_a_field_takes_what_is_pasted_into_it() -> void:
	await _open_link("dot_product")
	_clipboard = "normals"
	var field := Screen.named(screen(), "x of a") as LineEdit
	await student.click(field)
	field.accept_event()
	watch_signals(frame())
	await student.press_key(KEY_V, false, true)
	assert_signal_not_emitted(frame(), "other_lesson_wanted")
	assert_engine_error("Clipboard is not supported")


func _open_link(text: String) -> void:
	LessonRequest.ask(text)
	await open_lesson(LessonIndex.find(LessonRequest.take_id()))


func _follow(text: String) -> void:
	if frame():
		frame().follow_link("#" + text)
	else:
		screen().call(&"_follow_link", "#" + text)
	await student.settle()
