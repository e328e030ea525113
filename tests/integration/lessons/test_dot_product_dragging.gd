extends DotProductTest
## Clicks, drags, touches and nudges on the board of the lesson on the dot product.


func test_the_lesson_starts_with_the_vectors_of_the_lecture() -> void:
	assert_a([0, 0, 7, 1])
	assert_b([0, 0, 8, -6])


func test_a_left_click_sets_the_head_of_a_on_the_grid() -> void:
	await student.click_at(place(-3.2, -3.9))
	assert_a([0, 0, -3, -4])
	assert_b([0, 0, 8, -6])


func test_a_right_click_sets_the_head_of_b_on_the_grid() -> void:
	await student.click_at(place(-3.2, -3.9), MOUSE_BUTTON_RIGHT)
	assert_a([0, 0, 7, 1])
	assert_b([0, 0, -3, -4])


func test_a_right_click_on_an_arrow_or_a_handle_sets_b_too() -> void:
	await student.click_at(place(4.2, 0.6), MOUSE_BUTTON_RIGHT)
	assert_b([0, 0, 4, 1])
	await student.click_at(place(7.1, 1.1), MOUSE_BUTTON_RIGHT)
	assert_b([0, 0, 7, 1])


func test_a_finger_sets_a() -> void:
	await student.touch(place(-4.1, -2.9))
	assert_a([0, 0, -4, -3])


func test_dragging_on_the_empty_board_lets_the_head_follow() -> void:
	await drag(Vec2.new(-2, 3), Vec2.new(-5.3, 4.2))
	assert_a([0, 0, -5, 4])


func test_dragging_a_head_snaps_to_the_grid() -> void:
	await drag(Vec2.new(7, 1), Vec2.new(3.3, -3.8))
	assert_a([0, 0, 3, -4])
	await drag(Vec2.new(8, -6), Vec2.new(-2.4, 5.4))
	assert_b([0, 0, -2, 5])


func test_shift_frees_a_dragged_head_from_the_grid() -> void:
	await drag(Vec2.new(7, 1), Vec2.new(3.3, -3.8), true)
	assert_almost_eq(ends("a")[2], 3.3, 0.02)
	assert_almost_eq(ends("a")[3], -3.8, 0.02)


func test_taking_hold_beside_the_middle_of_a_handle_moves_nothing() -> void:
	await student.drag(place(7, 1) + Vector2(9, 9), place(7, 1) + Vector2(10, 9))
	assert_a([0, 0, 7, 1])


func test_dragging_a_tail_leaves_the_head_where_it_is() -> void:
	await drag(Vec2.new(0, 0), Vec2.new(2.1, 2.9))
	assert_b([2, 3, 8, -6])
	await drag(Vec2.new(0, 0), Vec2.new(-2.1, 1.2))
	assert_a([-2, 1, 7, 1])


func test_dragging_the_body_moves_the_whole_vector() -> void:
	await drag(Vec2.new(3.5, 0.5), Vec2.new(1.5, 3.5))
	assert_a([-2, 3, 5, 4])


func test_arrow_keys_nudge_what_has_the_focus_by_one_unit() -> void:
	Screen.named(screen(), "Head of a").grab_focus()
	await student.press(&"ui_right")
	await student.press(&"ui_up")
	await student.press(&"ui_up")
	assert_a([0, 0, 8, -1])


func test_the_gamepads_cross_nudges_too() -> void:
	Screen.named(screen(), "Head of b").grab_focus()
	await student.press_pad(JOY_BUTTON_DPAD_LEFT)
	await student.press_pad(JOY_BUTTON_DPAD_DOWN)
	assert_b([0, 0, 7, -5])


func test_shift_and_an_arrow_key_nudge_by_a_tenth() -> void:
	Screen.named(screen(), "Head of a").grab_focus()
	await student.press_key(KEY_LEFT, true)
	assert_almost_eq(ends("a")[2], 6.9, 1e-12)
	assert_almost_eq(ends("a")[3], 1.0, 0.0)


func test_the_tab_key_goes_through_all_handles_and_on_to_the_panel() -> void:
	Screen.button(screen(), "Reset the lesson").grab_focus()
	var reached := await _names_with_focus(student.press_key.bind(KEY_TAB))
	var handles: Array[String] = [
		"Whole vector a", "Tail of a", "Head of a", "Whole vector b", "Tail of b", "Head of b"
	]
	assert_eq(reached, handles + ["Step back"] as Array[String])


func test_tab_with_shift_goes_back_through_all_handles() -> void:
	Screen.button(screen(), "Step back").grab_focus()
	var reached := await _names_with_focus(student.press_key.bind(KEY_TAB, true))
	var handles: Array[String] = [
		"Head of b", "Tail of b", "Whole vector b", "Head of a", "Tail of a", "Whole vector a"
	]
	assert_eq(reached, handles + ["Reset the lesson"] as Array[String])


func test_a_click_on_the_board_takes_the_focus_from_a_field() -> void:
	await student.click(field("x of a"))
	await student.click_at(place(-3, -4))
	assert_false(field("x of a").has_focus())


func test_a_head_that_lies_on_the_other_arrow_can_be_taken() -> void:
	await drag(Vec2.new(7, 1), Vec2.new(4, -3))
	assert_a([0, 0, 4, -3], "a lies along b now")
	await drag(Vec2.new(4, -3), Vec2.new(6, 2))
	assert_a([0, 0, 6, 2])
	assert_b([0, 0, 8, -6])


func test_a_head_behind_the_graph_can_be_taken() -> void:
	var plot := Screen.named(screen(), "a · b for each angle")
	var lesson := frame().lesson
	var middle := (
		lesson.get_global_transform().affine_inverse() * plot.get_global_rect().get_center()
	)
	var behind := lesson.snapped_to_step(lesson.to_plane(middle))
	await student.enter(field("x of a"), str(behind.x))
	await student.enter(field("y of a"), str(behind.y))
	await drag(Vec2.new(ends("a")[2], ends("a")[3]), Vec2.new(0, 4))
	assert_a([0, 0, 0, 4])


# What has the focus, by the names that a screen reader says, after each of seven steps.
func _names_with_focus(go_on: Callable) -> Array[String]:
	var reached: Array[String] = []
	for step: int in 7:
		await go_on.call()
		reached.append(student.window.gui_get_focus_owner().accessibility_name)
	return reached
