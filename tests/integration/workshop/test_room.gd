extends WorkshopTest
## The workshop's scene and its cards on the start screen: they know how far the student is, and
## open what comes next.

const _WORKSHOP := "res://workshop/workshop.tscn"


func test_it_opens_the_lesson_of_the_first_exercise_while_nothing_is_written() -> void:
	await _run_workshop()
	assert_eq(frame().lesson_info.id, &"normals")


func test_what_is_to_be_written_is_in_view_there() -> void:
	await _run_workshop()
	await student.settle()
	assert_reads("Write normalized in my_vec2.gd.")
	var section := frame().find_children("*", "OwnCode", true, false)[0] as OwnCode
	var panel := frame().get_node("%Panel") as ScrollContainer
	for part: String in ["%Sentence", "%Verdict"]:
		var place := (section.get_node(part) as Control).get_global_rect()
		assert_true(panel.get_global_rect().encloses(place), part)


func test_it_opens_the_lesson_of_the_first_exercise_that_is_not_right() -> void:
	write_first_two()
	await _run_workshop()
	assert_eq(frame().lesson_info.id, &"dot_product")


func test_a_wrong_first_exercise_comes_before_a_right_second_one() -> void:
	write("normal", "return MyVec2.new(-y, x).scaled(0.0 if length() == 0.0 else 1.0 / length())")
	write("normalized", "return scaled(2.0)")
	await _run_workshop()
	assert_eq(frame().lesson_info.id, &"normals")


func test_it_says_what_it_waits_for_and_leads_back_meanwhile() -> void:
	await judged()
	watcher.set_process(false)
	watcher.report = null
	WorkshopWays.open_next(get_tree())
	await student.settle()
	assert_reads("Looking at your code")
	await student.press_key(KEY_ESCAPE)
	assert_false(_cards().is_empty(), "the start screen is open")


func test_where_only_the_tests_are_left_it_opens_the_rubric() -> void:
	await judged()
	for exercise: int in range(1, 12):
		watcher.report.verdict(exercise).kind = WorkshopVerdict.Kind.RIGHT
	WorkshopWays.open_next(get_tree())
	await until(func() -> bool: return screen() is RubricPage)
	assert_reads("Reached: sufficient")


func test_where_no_child_can_be_started_the_card_opens_the_page_to_write_on_and_leads_back(
) -> void:
	WorkshopChild.is_allowed = false
	# The next one that is asked for is that of a page.
	await student.settle()
	watcher.free()
	await open_start_screen()
	assert_true(Screen.reads(_cards()[0], "0 of 15 right"))
	assert_true(Screen.reads(_cards()[0], "Write the next method here"))
	await student.click(_cards()[0])
	assert_true(screen() is CodePage)
	assert_reads("Write normalized.")
	(screen().get_node("%Back") as Button).grab_focus()
	await student.press_key(KEY_ESCAPE)
	assert_false(_cards().is_empty(), "the start screen is open")
	WorkshopChild.is_allowed = true


func test_the_last_cards_say_how_far_the_student_is() -> void:
	await open_start_screen()
	await judged()
	assert_true(Screen.reads(_cards()[0], "0 of 15 right"))
	assert_true(Screen.reads(_cards()[1], "Reached: not yet sufficient"))
	write_first_two()
	look_again()
	await judged()
	assert_true(Screen.reads(_cards()[0], "✓ 2 of 15 right"))
	assert_string_contains(_cards()[0].accessibility_name, "Your own code. Write the next method")
	assert_string_ends_with(_cards()[0].accessibility_name, ". 2 of 15 right")


func test_the_cards_follow_each_save() -> void:
	write_first_two()
	await open_start_screen()
	await judged()
	assert_true(Screen.reads(_cards()[0], "2 of 15 right"))
	write("normal", "return null")
	look_again()
	await judged()
	assert_true(Screen.reads(_cards()[0], "1 of 15 right"))


func test_a_click_a_key_and_enter_open_the_first_card() -> void:
	await judged()
	for open: Callable in [
		func() -> void: await student.click(_cards()[0]),
		func() -> void: await student.press(&"lab_own_code"),
		_open_by_keys,
	]:
		await open_start_screen()
		await open.call()
		await until(func() -> bool: return frame() != null)
		assert_eq(frame().lesson_info.id, &"normals")
		screen().free()


func test_the_key_is_named_in_the_line_of_help() -> void:
	await open_start_screen()
	var help := (screen().get_node("%Help") as Label).text
	assert_string_contains(help.replace(Steps.NO_BREAK_SPACE, " "), "X own code")


func test_the_last_card_opens_the_rubric_and_escape_leads_back_to_the_cards() -> void:
	await judged()
	await open_start_screen()
	await student.press_key(KEY_END)
	await student.press_key(KEY_ENTER)
	assert_true(screen() is RubricPage)
	await student.press_key(KEY_ESCAPE)
	await student.settle()
	assert_same(student.window.gui_get_focus_owner(), _cards()[0])


func _open_by_keys() -> void:
	await student.press_key(KEY_END)
	await student.press_key(KEY_LEFT)
	await student.press_key(KEY_ENTER)


func _run_workshop() -> void:
	await judged()
	get_tree().change_scene_to_file(_WORKSHOP)
	await until(func() -> bool: return frame() != null)
	await student.settle()


func _cards() -> Array[WorkshopCard]:
	var found: Array[WorkshopCard] = []
	for control: Control in Screen.controls(screen()):
		if control is WorkshopCard:
			found.append(control as WorkshopCard)
	return found
