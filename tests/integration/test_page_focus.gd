extends ScreenTest
## The page around the lab is told where the Tab key leaves the lab, and where the wheel is for it.


func test_tab_leaves_behind_the_last_part_and_with_shift_before_the_first() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		var focus := _focus()
		assert_eq(_ends(focus), [true, false], "nothing has the focus")
		await student.press_key(KEY_TAB)
		var first := student.window.gui_get_focus_owner()
		assert_eq(_ends(focus), [true, false], lesson.id)
		var tabs := 0
		while not focus.state()["isLast"] and tabs < 100:
			await student.press_key(KEY_TAB)
			tabs += 1
			assert_ne(student.window.gui_get_focus_owner(), first, lesson.id)
		assert_gt(tabs, 5)
		await student.press_key(KEY_TAB)
		assert_eq(student.window.gui_get_focus_owner(), first, "it was the last part")
		screen().free()


func test_what_is_off_is_no_end() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	var focus := _focus()
	assert_true(Screen.button(screen(), "Undo").disabled)
	Screen.button(screen(), "Put the board back to its start").grab_focus()
	assert_eq(_ends(focus), [true, false])


func test_the_cards_of_the_start_screen_have_ends_too() -> void:
	await open_start_screen()
	var focus := _focus()
	assert_true(student.window.gui_get_focus_owner() is LessonCard)
	assert_eq(_ends(focus), [false, false])
	# The button for the language is before the cards.
	await student.press_key(KEY_TAB, true)
	assert_eq(_ends(focus), [true, false])
	await student.press_key(KEY_TAB, true)
	assert_eq(_ends(focus), [false, true])


func test_the_wheel_is_for_what_can_be_scrolled_below_the_pointer() -> void:
	await open_lesson(LessonIndex.find(&"class_or_value"))
	await go_to_step()
	(frame().lesson.services[&"question"] as Question).expand()
	await student.settle()
	var focus := _focus()
	var panel := frame().get_node("%Panel") as ScrollContainer
	await _point_at(frame().lesson)
	assert_eq(_scrolling(focus), [false, false])
	panel.scroll_vertical = 0
	await _point_at(panel)
	assert_eq(_scrolling(focus), [false, true])
	panel.scroll_vertical = 20
	assert_eq(_scrolling(focus), [true, true])
	panel.scroll_vertical = 100000
	assert_eq(_scrolling(focus), [true, false])


func test_it_is_told_when_something_changes_and_only_then() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	var focus := _focus()
	watch_signals(focus)
	await student.settle()
	assert_signal_emit_count(focus, "changed", 1)
	await student.press_key(KEY_TAB)
	await student.press_key(KEY_TAB)
	assert_signal_emit_count(focus, "changed", 2)


func _focus() -> PageFocus:
	var focus := PageFocus.new(screen())
	screen().add_child(focus)
	return focus


func _ends(focus: PageFocus) -> Array:
	var state := focus.state()
	return [state["isFirst"], state["isLast"]]


func _scrolling(focus: PageFocus) -> Array:
	var state := focus.state()
	return [state["scrollsUp"], state["scrollsDown"]]


func _point_at(control: Control) -> void:
	student.move_to(control.get_global_rect().get_center())
	await student.settle()
