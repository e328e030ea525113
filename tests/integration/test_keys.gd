extends ScreenTest
## One meaning for each key in all lessons, and none at all for what the focused control uses.

const _MOST_TABS := 200


func test_space_on_a_focused_button_presses_it_and_no_more() -> void:
	for lesson: LessonInfo in _with(&"transport"):
		await _open_where_time_runs(lesson)
		var slow := Screen.button(screen(), "Slow motion")
		for title: String in ["Play or pause", "One frame on", "Copy a link to this board"]:
			Screen.button(screen(), title).grab_focus()
			await student.press_key(KEY_SPACE)
			assert_false(slow.button_pressed, "%s in %s" % [title, lesson.id])
		slow.grab_focus()
		await student.press_key(KEY_SPACE)
		assert_true(slow.button_pressed, "pressed once")
		screen().free()


func test_after_a_click_on_a_button_space_is_slow_motion_again() -> void:
	for lesson: LessonInfo in _with(&"transport"):
		await _open_where_time_runs(lesson)
		await click_button("Play or pause")
		await student.press_key(KEY_SPACE)
		assert_true(Screen.button(screen(), "Slow motion").button_pressed, lesson.id)
		screen().free()


func test_after_a_choice_by_the_mouse_space_is_slow_motion_again() -> void:
	await open_lesson(LessonIndex.find(&"angled_lines"))
	var lists := frame().find_children("*", "OptionButton", true, false)
	assert_gt(lists.size(), 2)
	for list: OptionButton in lists:
		await student.click(list)
		await _click_in(list.get_popup())
		assert_gt(list.selected, 0, "something else was chosen")
		assert_false(list.has_focus())
		assert_false(list.get_popup().visible)
		var slow := Screen.button(screen(), "Slow motion")
		slow.button_pressed = false
		await student.press_key(KEY_SPACE)
		assert_true(slow.button_pressed)


func test_a_list_that_was_opened_by_a_key_keeps_the_focus() -> void:
	await open_lesson(LessonIndex.find(&"normals"))
	var list := frame().find_children("*", "OptionButton", true, false)[0] as OptionButton
	list.grab_focus()
	await student.press_key(KEY_SPACE)
	await student.press_key(KEY_DOWN)
	await student.press_key(KEY_ENTER)
	assert_gt(list.selected, 0)
	assert_true(list.has_focus())


func test_tab_stops_only_where_something_can_be_done() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		student.window.gui_release_focus()
		var round_of_tabs: Array[Control] = []
		while round_of_tabs.size() < _MOST_TABS:
			await student.press_key(KEY_TAB)
			var stop := student.window.gui_get_focus_owner()
			if stop in round_of_tabs:
				break
			round_of_tabs.append(stop)
			var button := stop as BaseButton
			if button:
				assert_false(button.disabled, "%s in %s" % [button.name, lesson.id])
		assert_lt(round_of_tabs.size(), _MOST_TABS)
		assert_has(round_of_tabs, Screen.button(screen(), "Step forward"))
		screen().free()


func test_a_button_that_its_own_press_switches_off_keeps_the_place_of_the_tab_key() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	await student.click_at(frame().lesson.get_global_rect().get_center() - Vector2(90, 70))
	var undo := Screen.button(screen(), "Undo")
	undo.grab_focus()
	await student.press_key(KEY_SPACE)
	assert_true(undo.disabled)
	await student.press_key(KEY_TAB)
	assert_true(Screen.button(screen(), "Redo").has_focus())
	await student.press_key(KEY_TAB, true)
	assert_false(undo.has_focus(), "it is off, and has been left")


func test_space_on_the_title_of_the_question_unfolds_it_and_no_more() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	var question := frame().lesson.services[&"question"] as FoldableContainer
	var was_folded := question.folded
	question.grab_focus()
	await student.press_key(KEY_SPACE)
	assert_ne(question.folded, was_folded)
	assert_false(Screen.button(screen(), "Slow motion").button_pressed)


func test_space_on_a_handle_which_does_not_use_it_is_slow_motion() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	Screen.named(screen(), "Head of a").grab_focus()
	await student.press_key(KEY_SPACE)
	assert_true(Screen.button(screen(), "Slow motion").button_pressed)


func test_s_is_one_frame_of_time_and_leaves_the_step_of_the_explanation() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		await _open_where_time_runs(lesson)
		var shown := frame().lesson.step
		var seconds := _count_seconds()
		await student.press_key(KEY_S)
		await student.press_key(KEY_S, true)
		await student.press_key(KEY_S, true)
		var wanted := [1.0, -1.0, -1.0] if lesson.needs.has("transport") else []
		assert_eq(seconds.map(signf), wanted, lesson.id)
		assert_eq(frame().lesson.step, shown, lesson.id)
		screen().free()


func test_what_a_lesson_does_not_show_yet_answers_to_no_key() -> void:
	await open_lesson(LessonIndex.find(&"line_distance"))
	var transport := frame().lesson.services[&"transport"] as Transport
	assert_false(transport.visible)
	var seconds := _count_seconds()
	for key: Key in [KEY_P, KEY_S, KEY_SPACE]:
		await student.press_key(key)
	assert_eq(seconds, [])
	assert_false(transport.is_playing)
	assert_false((transport.get_node("%Slow") as Button).button_pressed)


func test_n_and_the_page_keys_step_the_explanation_and_leave_time_alone() -> void:
	for lesson: LessonInfo in _with(&"steps"):
		await open_lesson(lesson)
		var seconds := _count_seconds()
		var steps := frame().lesson.services[&"steps"] as Steps
		steps.go_to(1)
		await student.press_key(KEY_N)
		# A question may come before the step.
		if frame().lesson.step == 1:
			await student.press_key(KEY_N)
		assert_eq(frame().lesson.step, 2, lesson.id)
		await student.press_key(KEY_N, true)
		assert_eq(frame().lesson.step, 1, lesson.id)
		await student.press_key(KEY_PAGEDOWN)
		assert_eq(frame().lesson.step, 2, lesson.id)
		await student.press_key(KEY_PAGEUP)
		assert_eq(frame().lesson.step, 1, lesson.id)
		assert_eq(seconds, [], lesson.id)
		screen().free()


func test_the_digits_of_the_keypad_choose_what_the_digits_choose() -> void:
	await open_lesson(LessonIndex.find(&"angled_lines"))
	for digit: int in 10:
		await student.press_key((KEY_KP_0 + digit) as Key)
		var preset: int = frame().lesson.state()["preset"]
		assert_eq(preset, digit)


# A lesson may have no use for time before its last step.
func _open_where_time_runs(lesson: LessonInfo) -> void:
	await open_lesson(lesson)
	var transport: Transport = frame().lesson.services.get(&"transport")
	if transport and not transport.visible:
		await go_to_step()


# Chooses another entry of an open list.
func _click_in(popup: PopupMenu) -> void:
	var at := Vector2(popup.position) + Vector2(30.0, popup.size.y * 0.7)
	await student.click_at(at)


# What passes in the lesson that is open, as it comes; empty where it has no transport.
func _count_seconds() -> Array:
	var seconds := []
	if frame().lesson.services.has(&"transport"):
		var transport := frame().lesson.services[&"transport"] as Transport
		transport.advanced.connect(func(passed: float) -> void: seconds.append(passed))
	return seconds


func _with(service: StringName) -> Array[LessonInfo]:
	return LessonIndex.lessons().filter(
		func(lesson: LessonInfo) -> bool: return lesson.needs.has(str(service))
	)
