extends ScreenTest
## From lesson to lesson by button, key and a presenter's remote control; each comes back as it was
## left.


func after_each() -> void:
	LessonRequest.ask("")
	await super.after_each()


func test_two_buttons_beside_the_title_lead_to_the_lessons_before_and_behind() -> void:
	await _open_in_lab("dot_product")
	await click_button("On to lesson 6  Ball and line: distance")
	_assert_is_open("line_distance")
	await click_button("Back to lesson 4  The dot product")
	_assert_is_open("dot_product")
	await click_button("Back to lesson 3  Normals")
	_assert_is_open("normals")


func test_the_ways_go_through_all_lessons_in_the_order_of_the_start_screen() -> void:
	var wanted := LessonAgenda.lessons()
	for action: StringName in [&"lab_next_lesson", &"lab_previous_lesson"]:
		await _open_in_lab(wanted[0].id)
		for lesson: LessonInfo in wanted.slice(1):
			await student.press(action)
			_assert_is_open(lesson.id)
		screen().free()
		wanted.reverse()


func test_the_buttons_can_be_hit_by_a_finger() -> void:
	await _open_in_lab("dot_product")
	for button in _buttons():
		assert_gte(button.size.x, 44.0)
		assert_gte(button.size.y, 44.0)
		assert_true(button.visible)


func test_the_keys_do_the_same() -> void:
	await _open_in_lab("dot_product")
	await student.press(&"lab_next_lesson")
	_assert_is_open("line_distance")
	await student.press(&"lab_previous_lesson")
	_assert_is_open("dot_product")
	await student.press_key(KEY_PAGEDOWN, false, true)
	_assert_is_open("line_distance")
	await student.press_key(KEY_PAGEUP, false, true)
	_assert_is_open("dot_product")


func test_at_either_end_there_is_no_further_way() -> void:
	for row: Array in [
		["class_or_value", 0, &"lab_previous_lesson"], ["error_and_time", 1, &"lab_next_lesson"]
	]:
		var id: String = row[0]
		var place: int = row[1]
		var action: StringName = row[2]
		await _open_in_lab(id)
		assert_true(_buttons()[place].disabled, id)
		assert_false(_buttons()[1 - place].disabled, id)
		await go_to_step(place * 1000)
		await student.press(action)
		await student.press(&"lab_next_step" if place else &"lab_previous_step")
		_assert_is_open(id)
		screen().free()


func test_where_there_is_one_lesson_only_no_way_is_offered() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	for button in _buttons():
		assert_false(button.visible)
	await go_to_step()
	var steps := frame().lesson.services[&"steps"] as Steps
	assert_true((steps.get_node("%Forward") as Button).disabled)
	assert_false((frame().get_node("%Help") as Label).text.contains("lesson"))
	for action: StringName in [&"lab_next_lesson", &"lab_next_step"]:
		await student.press(action)
	_assert_is_open("dot_product")


func test_a_lesson_comes_back_with_board_and_step_and_reset_leads_to_its_start() -> void:
	await _open_in_lab("dot_product")
	var start := frame().lesson.state()
	await student.enter(Screen.named(screen(), "x of a") as LineEdit, "3")
	await go_to_step(3)
	var left := frame().lesson.state()
	await student.press(&"lab_next_lesson")
	await student.press(&"lab_previous_lesson")
	assert_eq(frame().lesson.state(), left)
	assert_eq(frame().lesson.step, 3)
	assert_true(Screen.button(screen(), "Undo").disabled, "coming back is no change")
	await student.press(&"lab_back")
	assert_null(frame())
	await student.press_key(KEY_ENTER)
	assert_eq(frame().lesson.state(), left, "through the start screen, too")
	await student.press(&"lab_reset")
	assert_eq(frame().lesson.state(), start)


func test_what_was_asked_before_a_lesson_was_left_is_not_asked_again() -> void:
	await _open_in_lab("easy_bounce")
	var question := "Where must the centre go, so that the ball just touches?"
	for press: int in 2:
		await student.press(&"lab_next_step")
	assert_reads(question)
	await student.press(&"lab_next_step")
	await student.press(&"lab_next_lesson")
	await student.press(&"lab_previous_lesson")
	await student.press(&"lab_previous_step")
	await student.press(&"lab_next_step")
	assert_does_not_read(question)
	await student.press(&"lab_next_step")
	assert_reads("Which component of v changes its sign?")


func test_every_lesson_comes_back_as_it_was_left() -> void:
	for lesson in LessonIndex.lessons():
		await _open_in_lab(lesson.id)
		await student.press(&"lab_pause")
		await student.press(&"lab_preset_1")
		await student.press(&"lab_next_frame")
		await go_to_step(1)
		var left := frame().lesson.state()
		await student.press(&"lab_back")
		await student.press_key(KEY_ENTER)
		_assert_is_open(lesson.id)
		assert_eq(frame().lesson.state(), left, lesson.id)
		assert_eq(frame().lesson.step, 1, lesson.id)
		screen().free()


func test_hidden_answers_stay_hidden_in_the_next_lesson() -> void:
	await _open_in_lab("dot_product")
	await student.press(&"lab_hide_answers")
	await student.press(&"lab_next_lesson")
	assert_false(frame().view.shows_answers)
	await student.press(&"lab_hide_answers")
	await student.press(&"lab_next_lesson")
	assert_true(frame().view.shows_answers)


func test_a_lesson_that_only_moved_by_itself_opens_anew() -> void:
	OpeningMotion.is_allowed = true
	await _open_in_lab("dot_product")
	for second: int in 60:
		await get_tree().process_frame
	await student.press(&"lab_next_lesson")
	await student.press(&"lab_previous_lesson")
	assert_true(frame().lesson.is_opening())
	OpeningMotion.is_allowed = false


func test_a_link_to_a_lesson_asks_for_its_start_not_for_what_was_left() -> void:
	await _open_in_lab("dot_product")
	await student.enter(Screen.named(screen(), "x of a") as LineEdit, "3")
	await student.press(&"lab_next_lesson")
	frame().follow_link("#dot_product")
	await student.settle()
	assert_eq(frame().link.text(), "dot_product")
	await student.enter(Screen.named(screen(), "x of a") as LineEdit, "3")
	student.window.gui_release_focus()
	await student.press(&"lab_back")
	screen().call(&"_follow_link", "#dot_product")
	await student.settle()
	assert_eq(frame().link.text(), "dot_product")


func test_one_step_more_than_the_last_leads_to_the_first_of_the_next_lesson() -> void:
	await _open_in_lab("dot_product")
	await student.press(&"lab_next_lesson")
	await go_to_step(2)
	await student.press(&"lab_previous_lesson")
	await go_to_step()
	await student.press_key(KEY_PAGEDOWN)
	_assert_is_open("line_distance")
	assert_eq(frame().lesson.step, 0)
	await student.press_key(KEY_PAGEUP)
	_assert_is_open("dot_product")
	assert_eq(frame().lesson.step, frame().lesson.step_count - 1)


func test_one_step_before_the_first_leads_to_the_end_of_a_lesson_that_was_not_open_yet() -> void:
	await _open_in_lab("dot_product")
	await student.press(&"lab_previous_step")
	_assert_is_open("normals")
	assert_eq(frame().lesson.step, frame().lesson.step_count - 1)


func test_the_buttons_of_the_steps_say_where_they_lead() -> void:
	await _open_in_lab("dot_product")
	assert_not_null(Screen.button(screen(), "Step forward"))
	await go_to_step()
	assert_null(Screen.button(screen(), "Step forward"))
	var steps := frame().lesson.services[&"steps"] as Steps
	var forward := steps.get_node("%Forward") as Button
	assert_eq(forward.tooltip_text, "On to lesson 6  Ball and line: distance")
	await student.click(forward)
	_assert_is_open("line_distance")


func test_a_key_that_is_held_down_stops_at_the_last_step() -> void:
	await _open_in_lab("dot_product")
	await go_to_step()
	var held := InputEventKey.new()
	held.physical_keycode = KEY_N
	held.keycode = KEY_N
	held.pressed = true
	held.echo = true
	Input.parse_input_event(held)
	await student.settle()
	_assert_is_open("dot_product")


func _open_in_lab(id: String) -> void:
	LessonRequest.ask(id)
	await open_start_screen()
	await student.settle()


func _buttons() -> Array[Button]:
	var found: Array[Button] = []
	for path: String in ["%PreviousLesson", "%NextLesson"]:
		found.append(frame().get_node(path) as Button)
	return found


func _assert_is_open(id: String) -> void:
	assert_eq(str(frame().lesson_info.id), id)
