extends DotProductTest
## The focus in the lesson on the dot product: how keys and gamepad reach handles and nudge them.


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
	Screen.button(screen(), "View").grab_focus()
	var reached := await _names_with_focus(student.press_key.bind(KEY_TAB))
	var handles: Array[String] = [
		"Whole vector a", "Tail of a", "Head of a", "Whole vector b", "Tail of b", "Head of b"
	]
	assert_eq(reached, handles + ["Step forward"] as Array[String], "past the button that is off")


func test_tab_with_shift_goes_back_through_all_handles() -> void:
	Screen.button(screen(), "Step back").grab_focus()
	var reached := await _names_with_focus(student.press_key.bind(KEY_TAB, true))
	var handles: Array[String] = [
		"Head of b", "Tail of b", "Whole vector b", "Head of a", "Tail of a", "Whole vector a"
	]
	assert_eq(reached, handles + ["View"] as Array[String])


func test_a_click_on_the_board_takes_the_focus_from_a_field() -> void:
	await student.click(field("x of a"))
	await student.click_at(place(-3, -4))
	assert_false(field("x of a").has_focus())


# What has the focus, by the names that a screen reader says, after each of seven steps.
func _names_with_focus(go_on: Callable) -> Array[String]:
	var reached: Array[String] = []
	for step: int in 7:
		await go_on.call()
		reached.append(student.window.gui_get_focus_owner().accessibility_name)
	return reached
