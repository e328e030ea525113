extends DotProductTest
## Undo, redo and reset of everything that a student can change, in the lesson on the dot product.


func test_each_kind_of_change_can_be_undone_and_redone() -> void:
	# The graph comes with the last steps.
	await go_to_step()
	var changes: Dictionary[String, Callable] = {
		"click": func() -> void: await student.click_at(place(-3, -4)),
		"drag": func() -> void: await drag(Vec2.new(7, 1), Vec2.new(3, -4)),
		"nudge": _nudge,
		"typing": func() -> void: await student.enter(field("y of b"), "2"),
		"preset": func() -> void: await click_button("Obtuse"),
		"switch": func() -> void: await click_button("Normalize"),
		"swap": func() -> void: await click_button("b on a"),
		"graph": _point_at_graph,
	}
	for change: String in changes:
		var before := frame().lesson.state()
		await changes[change].call()
		var after := frame().lesson.state()
		assert_ne(after, before, change)
		await student.press(&"lab_undo")
		assert_eq(frame().lesson.state(), before, "undo " + change)
		await student.press(&"lab_redo")
		assert_eq(frame().lesson.state(), after, "redo " + change)
		await student.press(&"lab_undo")


func test_a_drag_is_one_change() -> void:
	await drag(Vec2.new(7, 1), Vec2.new(3, -4))
	await click_button("Undo")
	assert_a([0, 0, 7, 1])
	assert_true(Screen.button(screen(), "Undo").disabled)


func test_a_press_without_a_movement_is_no_change() -> void:
	await student.click_at(place(7, 1))
	assert_true(Screen.button(screen(), "Undo").disabled)


func test_changes_are_undone_in_reverse_order() -> void:
	await student.enter(field("x of a"), "3")
	await student.enter(field("x of a"), "4")
	await student.press(&"lab_undo")
	assert_a([0, 0, 3, 1])
	await student.press(&"lab_undo")
	assert_a([0, 0, 7, 1])


func test_the_buttons_undo_and_redo_and_are_off_where_there_is_nothing() -> void:
	assert_true(Screen.button(screen(), "Undo").disabled)
	assert_true(Screen.button(screen(), "Redo").disabled)
	await student.click_at(place(-3, -4))
	await click_button("Undo")
	assert_a([0, 0, 7, 1])
	await click_button("Redo")
	assert_a([0, 0, -3, -4])


func test_a_new_change_forgets_what_was_undone() -> void:
	await student.enter(field("x of a"), "3")
	await student.press(&"lab_undo")
	await student.enter(field("x of a"), "5")
	assert_true(Screen.button(screen(), "Redo").disabled)
	await student.press(&"lab_redo")
	assert_a([0, 0, 5, 1])


func test_the_second_key_for_redo_works_too() -> void:
	await student.click_at(place(-3, -4))
	await student.press(&"lab_undo")
	await student.press_key(KEY_Y, false, true)
	assert_a([0, 0, -3, -4])


func test_the_gamepad_undoes_and_redoes() -> void:
	await student.click_at(place(-3, -4))
	await student.press_pad(JOY_BUTTON_LEFT_STICK)
	assert_a([0, 0, 7, 1])
	await student.press_pad(JOY_BUTTON_RIGHT_STICK)
	assert_a([0, 0, -3, -4])


func test_reset_by_key_button_and_gamepad_brings_the_start_back() -> void:
	var start := frame().lesson.state()
	for reset: Callable in [
		student.press.bind(&"lab_reset"),
		click_button.bind("Put the board back to its start"),
		student.press_pad.bind(JOY_BUTTON_Y),
	]:
		await click_button("Huge")
		await click_button("Normalize")
		await reset.call()
		assert_eq(frame().lesson.state(), start)


func test_a_reset_can_be_undone() -> void:
	await student.click_at(place(-3, -4))
	await student.press(&"lab_reset")
	await student.press(&"lab_undo")
	assert_a([0, 0, -3, -4])


func _nudge() -> void:
	Screen.named(screen(), "Head of b").grab_focus()
	await student.press(&"ui_right")


func _point_at_graph() -> void:
	var plot := Screen.named(screen(), "a · b, right: cos φ")
	await student.click_at(plot.get_global_rect().get_center())
