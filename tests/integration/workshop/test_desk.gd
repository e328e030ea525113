extends DeskTest
## A student has a lesson open and saves his file: the lesson says what came of it, and draws what
## his method answers.

const _RIGHT := "return x * other.x + y * other.y"
const _WRONG := "return x * other.x - y * other.y"
const _OPEN := "return 0.0"
const _LOOP := "while true:\n\t\tpass\n\treturn 0.0"
const _SAVES := 10


func after_each() -> void:
	WorkshopChild.is_allowed = true
	OwnCode.stays_folded = false
	await super()


func test_it_is_folded_while_nothing_is_written_and_unfolds_once() -> void:
	await open_with_desk(&"dot_product")
	assert_true(section().folded)
	assert_reads("Your own code")
	await _save(_WRONG)
	assert_false(section().folded)
	section().folded = true
	await _save(_RIGHT)
	assert_true(section().folded, "the student has folded it")


func test_it_stands_between_the_formula_and_the_question() -> void:
	await open_with_desk(&"dot_product")
	var services := frame().lesson.services
	assert_gt(section().get_index(), services[&"formula"].get_index())
	assert_eq(section().get_index() + 1, services[&"question"].get_index())


func test_a_wrong_method_gets_its_sentence_and_a_right_one_its_run_time() -> void:
	await open_with_desk(&"dot_product")
	await _save(_WRONG)
	assert_reads("Exercise 3: The dot product")
	assert_reads("my_vec2.gd, line 67")
	assert_reads("The two products are subtracted: add them.")
	assert_reads("dot: (7, 1) · (8, -6)")
	assert_reads("Mark: not yet sufficient. For sufficient: exercise 2, exercise 3, exercise 9.")
	await _save(_RIGHT)
	assert_does_not_read("The two products are subtracted: add them.")
	assert_reads("Exercise 4: Projections")
	assert_reads("For sufficient: exercise 2, exercise 9.")


func test_what_is_right_has_error_and_run_time() -> void:
	await save_hand_in("right_plain")
	await open_with_desk(&"reflection")
	assert_reads("reflect is right.")
	assert_reads("of the lab's")
	assert_does_not_read("yours")


func test_the_verdict_on_a_save_comes_into_view_and_that_at_the_start_does_not() -> void:
	save_dot(_WRONG)
	await resize(Vector2i(390, 844))
	Navigation.open_lesson(get_tree(), LessonIndex.find(&"dot_product"))
	await student.settle()
	watcher.check_now()
	await wait_for(is_judged)
	await student.settle()
	var panel := frame().get_node("%Panel") as ScrollContainer
	assert_false(section().folded)
	assert_eq(panel.scroll_vertical, 0)
	await _save("return x * other.y")
	await student.settle()
	var sentence := section().get_node("%Sentence") as Label
	assert_true(panel.get_global_rect().encloses(sentence.get_global_rect()))


func test_the_worth_of_his_tests_is_told() -> void:
	var text := (
		WorkshopFiles
		. starter("test_my_vec2.gd")
		. replace(
			"func test_dot() -> void:\n\tpass",
			"func test_dot() -> void:\n\tassert_eq(MyVec2.new(7.0, 1.0).dot(MyVec2.new(8.0, -6.0)), 50.0)"
		)
	)
	save_file("test_my_vec2.gd", text)
	await open_with_desk(&"dot_product")
	await wait_for(func() -> bool: return watcher.report.tests != null)
	section().folded = false
	await student.settle()
	var found := watcher.report.tests.found.size()
	assert_gt(found, 0)
	assert_reads("Your tests find %d of " % found)
	assert_reads("Still green: rotate, rotate_around, normalized, ….")


func test_each_of_many_saves_is_followed() -> void:
	await open_with_desk(&"dot_product")
	for save in _SAVES:
		var is_right := save % 2 == 1
		await _save(_RIGHT if is_right else _WRONG)
		var drawn := await wait_for_answer("dot")
		assert_eq(drawn.words(), "yours: a·b = 50" if is_right else "yours: a·b = 62")
		assert_eq(drawn.is_right(), is_right)


func test_what_is_drawn_follows_the_board() -> void:
	await open_with_desk(&"dot_product")
	await _save(_WRONG)
	await click_button("Right angle")
	assert_eq((await wait_for_answer("dot")).words(), "yours: a·b = 48")
	await student.press(&"lab_undo")
	assert_eq((await wait_for_answer("dot")).words(), "yours: a·b = 62")


func test_what_cannot_be_read_is_not_drawn() -> void:
	await open_with_desk(&"dot_product")
	await _save(_WRONG)
	await wait_for_answer("dot")
	await _save("return x *")
	assert_null(answers().shown("dot"))
	await _save(_OPEN)
	assert_null(answers().shown("dot"))


func test_the_old_answer_is_faint_while_a_save_is_judged() -> void:
	await open_with_desk(&"dot_product")
	await _save(_WRONG)
	await wait_for_answer("dot")
	save_dot(_RIGHT)
	await watcher.began
	assert_not_null(answers().shown("dot"))
	assert_false(answers().is_current("dot"))
	await wait_for_answer("dot")
	assert_true(answers().shown("dot").is_right())


func test_the_key_and_the_button_check_now() -> void:
	await open_with_desk(&"dot_product")
	await _save(_WRONG)
	var begun := [0]
	watcher.began.connect(func() -> void: begun[0] = WorkshopAny.number(begun[0]) + 1)
	await student.press(&"lab_check_code")
	await wait_for(func() -> bool: return begun[0] == 1)
	await wait_for(is_judged)
	await click_button("Check now")
	await wait_for(func() -> bool: return begun[0] == 2)
	assert_reads("J check your code".replace(" ", "\u00a0"))


func test_hidden_answers_hide_it() -> void:
	await open_with_desk(&"dot_product")
	await _save(_WRONG)
	await wait_for_answer("dot")
	await student.press(&"lab_hide_answers")
	assert_eq(answers().modulate.a, 0.0)
	await student.press(&"lab_hide_answers")
	assert_eq(answers().modulate.a, 1.0)


func test_while_the_lesson_asks_nothing_of_his_gives_the_answer_away() -> void:
	await open_with_desk(&"dot_product")
	await save_hand_in("right_plain")
	await wait_for_answer("vector_projection")
	assert_true(answers().is_visible_in_tree())
	await _be_asked_where_the_shadow_ends()
	assert_false(answers().is_visible_in_tree(), "the question is there")
	await click_button("b on a")
	await wait_for_answer("vector_projection")
	assert_false(answers().is_visible_in_tree(), "it is still asked")
	await student.press(&"lab_next_step")
	assert_true(answers().is_visible_in_tree(), "the answer is there")


func test_while_the_lesson_asks_the_right_numbers_wait_and_other_sentences_do_not() -> void:
	var wanted := func() -> Label: return section().get_node("%Wanted") as Label
	var sentence := func() -> Label: return section().get_node("%Sentence") as Label
	await open_with_desk(&"dot_product")
	await _save(_WRONG)
	await _be_asked_where_the_shadow_ends()
	for label: Label in [wanted.call(), sentence.call()]:
		assert_eq(label.self_modulate.a, 0.0 if label.name == &"Wanted" else 1.0, label.name)
	await _save("return x * other.x + 3.0 * y * y")
	assert_eq(watcher.report.verdict(3).kind, WorkshopVerdict.Kind.UNKNOWN)
	await student.settle()
	for label: Label in [wanted.call(), sentence.call()]:
		assert_eq(label.self_modulate.a, 0.0, label.name)
	await student.press(&"lab_next_step")
	for label: Label in [wanted.call(), sentence.call()]:
		assert_eq(label.self_modulate.a, 1.0, label.name)


func test_undo_and_links_know_nothing_of_it() -> void:
	await open_with_desk(&"dot_product")
	var link := frame().lesson.link_state()
	await _save(_WRONG)
	await wait_for_answer("dot")
	assert_eq(frame().lesson.link_state(), link)
	assert_true(Screen.button(screen(), "Undo").disabled)


func test_without_children_what_is_written_in_the_lab_is_shown_and_written_on_from_here() -> void:
	WorkshopChild.is_allowed = false
	await student.settle()
	watcher.free()
	var exercise := WorkshopIndex.exercise(3)
	WorkshopKeptCode.keep(exercise, "func dot(other):\n\treturn x * other.x - y * other.y\n")
	Navigation.open_lesson(get_tree(), LessonIndex.find(&"dot_product"))
	await student.settle()
	assert_reads("The two products are subtracted: add them.")
	for frame_number in 10:
		await student.settle()
	assert_eq(answers().shown("dot").answer, PackedFloat64Array([62.0]))
	section().unfold()
	await student.click(section().get_node("%Write") as Button)
	assert_true(screen() is CodePage)
	assert_string_contains((screen().get_node("%Field") as CodeField).text, "- y * other.y")
	(screen().get_node("%Back") as Button).grab_focus()
	await student.press_key(KEY_ESCAPE)
	assert_eq(frame().lesson_info.id, &"dot_product")


func test_a_lesson_without_exercises_has_none() -> void:
	Navigation.open_lesson(get_tree(), LessonIndex.find(&"more_dimensions"))
	await student.settle()
	assert_null(section())


func test_a_loop_is_told_and_the_lesson_goes_on() -> void:
	await open_with_desk(&"dot_product")
	save_dot(_LOOP)
	await watcher.began
	var before := frame().lesson.state()
	await click_button("Right angle")
	assert_ne(frame().lesson.state(), before)
	await wait_for(is_judged)
	assert_reads("dot does not come to an end for (7, 1) · (8, -6).")
	assert_null(answers().shown("dot"))


func test_it_speaks_another_language_at_once() -> void:
	await open_with_desk(&"dot_product")
	await _save(_WRONG)
	LabText.speak_for_now("nl")
	frame().open_again()
	await student.settle()
	await wait_for(is_judged)
	assert_reads("Je eigen code")
	LabText.speak_for_now("en")


func _be_asked_where_the_shadow_ends() -> void:
	for press: int in 2:
		await student.press(&"lab_next_step")
	assert_reads("Where does the shadow of a end?")


# Saves a body of `dot`, and waits until it has been judged.
func _save(body: String) -> void:
	var before := watcher.report
	save_dot(body)
	await wait_for_verdict(before)
