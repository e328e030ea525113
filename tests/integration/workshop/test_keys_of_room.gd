extends WorkshopTest
## On the workshop's own screens the keys of the whole lab do what they do in a lesson.


func test_t_says_every_screen_anew_in_the_next_language() -> void:
	await judged()
	var said: Dictionary[Callable, PackedStringArray] = {
		_open_rubric: ["Wat je hebt bereikt", "Vectoren: de eenheidsnormaal", "Bereikt: "],
		_open_rotation: ["Draaien", "Hoek in graden", "Het lab: (−5, 2)", "Schrijf rotate in"],
		_open_entrance: ["Je eigen code", "Je code wordt nagekeken"],
	}
	for open in said:
		await open.call()
		var before := screen()
		await student.press(&"lab_language")
		assert_same(screen(), before, "nothing is lost")
		await until(func() -> bool: return Screen.reads(screen(), said[open][-1]))
		for text in said[open]:
			assert_reads(text)
		assert_string_contains(_help(), "terug")
		await student.press(&"lab_language")
		assert_does_not_read(said[open][0])
		screen().free()


func test_the_rubric_in_another_language_has_each_line_once() -> void:
	await judged()
	await _open_rubric()
	await student.press(&"lab_language")
	var rows := screen().find_children("*", "RubricRow", true, false)
	assert_eq(rows.size(), Rubric.lines().size())
	await student.click(rows[0].get_node("%Open") as Button)
	assert_eq(frame().lesson_info.id, &"normals")


func test_the_board_keeps_its_vector_in_another_language() -> void:
	await judged()
	await _open_rotation()
	await student.enter(screen().get_node("%Angle") as LineEdit, "180")
	student.window.gui_release_focus()
	await student.press(&"lab_language")
	assert_reads("Het lab: (−2, −5)")


func test_contrast_size_and_full_screen() -> void:
	await judged()
	for open: Callable in [_open_rubric, _open_rotation, _open_entrance]:
		await open.call()
		await student.press(&"lab_high_contrast")
		assert_true(HighContrast.is_chosen())
		await student.press(&"lab_high_contrast")
		assert_false(HighContrast.is_chosen())
		await student.press(&"lab_larger_text")
		assert_eq(WindowFit.text_size(), WindowFit.TEXT_SIZES[1])
		await student.press(&"lab_smaller_text")
		assert_eq(WindowFit.text_size(), WindowFit.TEXT_SIZES[0])
		screen().free()


func test_j_checks_now() -> void:
	var begun := [0]
	write("dot", "return x")
	await judged()
	watcher.began.connect(func() -> void: begun[0] = WorkshopAny.number(begun[0]) + 1)
	for open: Callable in [_open_rubric, _open_rotation]:
		await open.call()
		assert_string_contains(_help(), "J check your code")
		begun[0] = 0
		await student.press(&"lab_check_code")
		await until(func() -> bool: return begun[0] == 1)
		await judged()
		screen().free()


func test_the_board_shows_the_conventions_that_are_chosen_there() -> void:
	await judged()
	await _open_rotation()
	assert_reads("Angle in degrees")
	await student.press(&"lab_radians")
	assert_reads("Angle in radians")
	await student.press(&"lab_y_up")
	var board := screen().get_node("%Board") as Board
	assert_true(board.is_y_up)
	assert_lt(board.to_screen(Vec2.new(2.0, 5.0)).y, board.to_screen(Vec2.new()).y)
	await student.press(&"lab_full_turn")
	assert_true(Conventions.has_full_turn())


func _open_rubric() -> void:
	WorkshopWays.open_rubric(get_tree())
	await student.settle()


func _open_rotation() -> void:
	WorkshopWays.open_rotation(get_tree())
	await student.settle()


# While the student's files are looked at.
func _open_entrance() -> void:
	watcher.set_process(false)
	watcher.report = null
	WorkshopWays.open_next(get_tree())
	await student.settle()


func _help() -> String:
	return (screen().get_node("%Help") as Label).text.replace(Steps.NO_BREAK_SPACE, " ")
