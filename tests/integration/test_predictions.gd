extends DotProductTest
## The student is asked before a step shows the answer: for a point on the board, or for a choice.

const _CHOICES: PackedStringArray = ["longer", "shorter"]


func before_each() -> void:
	await super()
	await student.press(&"lab_next_step")


func test_the_question_comes_before_the_step_that_shows_the_answer() -> void:
	await student.press(&"lab_next_step")
	assert_reads("Step 2 of 9")
	assert_reads("Where does the shadow of a end?")
	assert_true(_guess().visible)
	assert_does_not_read("Scalar projection")


func test_a_guess_is_judged_when_the_step_is_shown() -> void:
	await student.press(&"lab_next_step")
	await drag(Vec2.new(7.5, -2.5), Vec2.new(5, -2))
	await student.press(&"lab_next_step")
	assert_reads("Step 3 of 9")
	# From (5, -2) to (4, -3).
	assert_reads("Your guess was 1.4 off.")
	assert_true(_guess().visible)
	await student.press(&"lab_next_step")
	assert_reads("Step 4 of 9")
	assert_does_not_read("off.")
	assert_false(_guess().visible)


func test_a_guess_on_the_point_is_exact() -> void:
	await student.press(&"lab_next_step")
	await drag(Vec2.new(7.5, -2.5), Vec2.new(4.2, -2.8))
	await click_button("Step forward")
	assert_reads("Exactly.")


func test_the_keys_move_the_guess() -> void:
	await student.press(&"lab_next_step")
	assert_true(_guess().has_focus(), "where nothing else has the focus")
	await student.press(&"ui_left")
	await student.press(&"lab_next_step")
	# From (6.5, -2.5) to (4, -3).
	assert_reads("Your guess was 2.5 off.")


func test_without_a_guess_the_step_is_simply_shown() -> void:
	await student.press(&"lab_next_step")
	await student.press(&"lab_next_step")
	assert_reads("Step 3 of 9")
	assert_does_not_read("off.")
	assert_false(_guess().visible)


func test_it_is_asked_once_and_again_after_a_reset() -> void:
	for press: int in 2:
		await student.press(&"lab_next_step")
	await student.press(&"lab_previous_step")
	await student.press(&"lab_next_step")
	assert_reads("Step 3 of 9")
	await student.press(&"lab_previous_step")
	await student.press(&"lab_reset")
	await student.press(&"lab_next_step")
	assert_reads("Where does the shadow of a end?")


func test_a_question_can_be_taken_back() -> void:
	await student.press(&"lab_next_step")
	await student.press(&"lab_previous_step")
	assert_reads("Step 2 of 9")
	assert_reads("Divide b by its length")
	assert_false(_guess().visible)


func test_an_edit_an_undo_and_a_reset_take_the_answer_away() -> void:
	await drag(Vec2.new(8, -6), Vec2.new(8, -4))
	for deed: Callable in [
		func() -> void: await student.enter(field("x of a"), "6"),
		func() -> void: await student.press(&"lab_undo"),
		func() -> void: await student.press(&"lab_reset"),
		func() -> void: await click_button("One frame on"),
	]:
		frame().lesson.ask_again()
		await go_to_step(1)
		await student.press(&"lab_next_step")
		await student.drag(_guess().get_global_rect().get_center(), place(1, 1))
		await student.press(&"lab_next_step")
		assert_reads("off.")
		await deed.call()
		assert_does_not_read("off.")
		assert_false(_guess().visible)


func test_an_edit_keeps_a_question_and_asks_it_with_the_new_numbers() -> void:
	await student.press(&"lab_next_step")
	await click_button("b on a")
	assert_reads("Where does the shadow of b end?")
	await student.drag(_guess().get_global_rect().get_center(), place(7, 1))
	await student.press(&"lab_next_step")
	assert_reads("Exactly.")


func test_where_there_is_no_shadow_nothing_is_asked() -> void:
	await click_button("Zero")
	await student.press(&"lab_next_step")
	assert_reads("Step 3 of 9")


func test_a_guess_is_not_kept_for_undo_or_links() -> void:
	await student.press(&"lab_next_step")
	await drag(Vec2.new(7.5, -2.5), Vec2.new(5, -2))
	assert_true((frame().get_node("%Undo") as Button).disabled)
	assert_eq(frame().link.text(), "dot_product?step=2")


func test_what_lies_below_an_answered_guess_can_be_taken() -> void:
	await student.press(&"lab_next_step")
	await drag(Vec2.new(7.5, -2.5), Vec2.new(7, 1))
	await student.press(&"lab_next_step")
	await drag(Vec2.new(7, 1), Vec2.new(3, 4))
	assert_a([0, 0, 3, 4])


func test_a_shaft_below_an_answered_guess_can_be_taken() -> void:
	await student.press(&"lab_next_step")
	await drag(Vec2.new(7.5, -2.5), Vec2.new(4, 1))
	await student.press(&"lab_next_step")
	await drag(Vec2.new(4, 4.0 / 7.0), Vec2.new(4, 3.0 + 4.0 / 7.0))
	assert_a([0, 3, 7, 4])


func test_a_choice_is_judged_when_the_step_is_shown() -> void:
	for right: int in 2:
		await go_to_step(3)
		frame().lesson.ask_choice_before(4, "Is it longer?", _CHOICES, func() -> int: return right)
		frame().lesson.ask_again()
		await student.press(&"lab_next_step")
		assert_reads("Is it longer?")
		await click_button("longer")
		assert_reads("Step 5 of 9")
		assert_reads("Right: longer" if right == 0 else "No, shorter")
		assert_null(Screen.button(screen(), "longer"))


func test_without_a_choice_the_step_is_simply_shown() -> void:
	await go_to_step(3)
	frame().lesson.ask_choice_before(4, "Is it longer?", _CHOICES, func() -> int: return 0)
	await student.press(&"lab_next_step")
	await student.press(&"lab_next_step")
	assert_reads("Step 5 of 9")
	assert_does_not_read("Right: ")
	assert_null(Screen.button(screen(), "longer"))


func test_a_choice_with_nothing_right_is_not_asked() -> void:
	await go_to_step(3)
	frame().lesson.ask_choice_before(4, "Is it longer?", _CHOICES, func() -> int: return -1)
	await student.press(&"lab_next_step")
	assert_reads("Step 5 of 9")


func _guess() -> Guess:
	return frame().lesson.get_node("%Guess") as Guess
