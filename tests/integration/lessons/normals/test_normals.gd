extends LessonTest
## Drives the lesson on normals as a student does.


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"normals"))
	await go_to_step()


func test_it_starts_with_the_first_example_of_the_lecture() -> void:
	assert_eq(numbers("line"), PackedFloat64Array([0, 0, 3, 1]))
	assert_has(formula_lines(), "n = (−y, x) = (−1, 3)")
	assert_has(formula_lines(), "2 · n̂ = (−0.6325, 1.897)")
	assert_reads("+90° turns clockwise")


func test_the_examples_of_the_lecture_are_there_to_pick() -> void:
	await click_button("(3, −2)")
	assert_has(formula_lines(), "n = (−y, x) = (2, 3)")
	await click_button("(3, −4)")
	assert_has(formula_lines(), "|n| = √(4² + 3²) = 5")
	assert_has(formula_lines(), "n̂ = n / |n| = (4, 3) / 5 = (0.8, 0.6)")


func test_dragging_the_end_turns_the_line_and_says_so() -> void:
	await drag(Vec2.new(3, 1), Vec2.new(-1, 3))
	assert_eq(numbers("line"), PackedFloat64Array([0, 0, -1, 3]))
	assert_reads("turned by 90°, and so is n")


func test_dragging_the_end_along_the_line_leaves_the_unit_normal() -> void:
	await click_button("(3, −2)")
	await click_button("(3, 1)")
	await drag(Vec2.new(3, 1), Vec2.new(-3, -1))
	assert_reads("turned by 180°")
	await drag(Vec2.new(-3, -1), Vec2.new(-6, -2))
	assert_reads("same slope: n̂ stays")


func test_dragging_the_whole_line_leaves_its_normal_and_says_so() -> void:
	await drag(Vec2.new(2.4, 0.8), Vec2.new(3.4, -1.2))
	assert_eq(numbers("line"), PackedFloat64Array([1, -2, 4, -1]))
	assert_reads("moved: v and its normals stay")
	assert_has(formula_lines(), "n = (−y, x) = (−1, 3)")
	assert_eq(seen(["%OldV", "%OldNormal"]), [true, true] as Array[bool])


func test_the_arrow_keys_nudge_the_end_by_a_unit() -> void:
	(Screen.named(screen(), "End of line v")).grab_focus()
	await student.press(&"ui_up")
	assert_eq(numbers("line"), PackedFloat64Array([0, 0, 3, 0]))


func test_with_y_up_the_picture_turns_over_and_no_number_changes() -> void:
	var lines := formula_lines()
	var head := place(3, 1)
	var origin := place(0, 0)
	await click_button("y points up")
	assert_eq(formula_lines(), lines)
	assert_almost_eq(place(3, 1).y - origin.y, origin.y - head.y, 0.01)
	assert_almost_eq(place(3, 1).x, head.x, 0.01)
	assert_reads("+90° turns counter-clockwise")


func test_with_y_up_dragging_and_keys_follow_the_picture() -> void:
	await click_button("y points up")
	await drag(Vec2.new(3, 1), Vec2.new(2, 3))
	assert_eq(numbers("line"), PackedFloat64Array([0, 0, 2, 3]))
	(Screen.named(screen(), "End of line v")).grab_focus()
	await student.press(&"ui_up")
	assert_eq(numbers("line"), PackedFloat64Array([0, 0, 2, 4]))


func test_every_number_can_be_typed() -> void:
	await student.enter(field("x of the start"), "-2")
	await student.enter(field("y of the start"), "1")
	await student.enter(field("x of v"), "3")
	await student.enter(field("y of v"), "-4")
	await student.enter(field("How many times n̂ is drawn"), "-5")
	assert_eq(numbers("line"), PackedFloat64Array([-2, 1, 1, -3]))
	assert_has(formula_lines(), "-5 · n̂ = (−4, −3)")


func test_huge_and_tiny_vectors_have_a_unit_normal() -> void:
	await student.enter(field("x of v"), "3e99")
	await student.enter(field("y of v"), "-4e99")
	assert_eq(readout_text(1, 1), "(0.8, 0.6)")
	await student.enter(field("x of v"), "3e-99")
	await student.enter(field("y of v"), "-4e-99")
	assert_eq(readout_text(1, 1), "(0.8, 0.6)")


func test_the_steps_build_the_drawing_up() -> void:
	var parts: Array[String] = ["%Normal", "%Opposite", "%Unit", "%Scaled"]
	for shown: int in [3, 2, 1, 0]:
		await student.press(&"lab_previous_step")
		for i: int in parts.size():
			assert_eq(seen([parts[i]]), [i < shown] as Array[bool], parts[i])
	await go_to_step(NormalsTexts.Step.NORMAL)
	assert_eq(seen(["%Normal", "%RightAngle", "%Turn"]), [true, true, true] as Array[bool])
	assert_eq(seen(["%Triangle", "%Turned"]), [true, true] as Array[bool])


func test_card_and_table_come_with_their_steps() -> void:
	await go_to_step(NormalsTexts.Step.VECTOR)
	assert_eq(seen(["%Verdict", "%Triangle"]), [false, true] as Array[bool])
	await go_to_step(NormalsTexts.Step.NORMAL)
	assert_eq(seen(["%Verdict"]), [true] as Array[bool])
	assert_false(frame().lesson.services[&"readout"].visible)
	await go_to_step(NormalsTexts.Step.UNIT)
	assert_true(frame().lesson.services[&"readout"].visible)


func test_the_formula_of_rotation_says_why_the_normal_is_minus_y_and_x() -> void:
	await go_to_step(NormalsTexts.Step.NORMAL)
	assert_has(formula_lines(), "cos 90° = 0     sin 90° = 1")
	assert_has(formula_lines(), "n = (x cos 90° − y sin 90°, x sin 90° + y cos 90°)")
	assert_has(formula_lines(), "n = (3·0 − 1·1, 3·1 + 1·0) = (−1, 3)")
	assert_has(formula_lines(), "v · n = 3·(−1) + 1·3 = 0")


func test_the_triangle_turns_by_itself_when_its_step_is_reached() -> void:
	await go_to_step(NormalsTexts.Step.VECTOR)
	OpeningMotion.is_allowed = true
	await go_to_step(NormalsTexts.Step.NORMAL)
	OpeningMotion.is_allowed = false
	var turned := frame().lesson.get_node("%Turned") as ComponentTriangle
	assert_between(turned.degrees, 0.0, 45.0)
	assert_eq(seen(["%RightAngle"]), [false] as Array[bool], "only at the end")
	var before := turned.degrees
	for i: int in 20:
		await get_tree().process_frame
	assert_gt(turned.degrees, before)
	await go_to_step(NormalsTexts.Step.OPPOSITE)
	await go_to_step(NormalsTexts.Step.NORMAL)
	assert_eq(turned.degrees, 90.0)
	assert_eq(seen(["%RightAngle"]), [true] as Array[bool])


func test_the_head_of_the_normal_is_guessed_before_it_is_shown() -> void:
	await go_to_step(NormalsTexts.Step.VECTOR)
	await student.press(&"lab_next_step")
	assert_reads("Turn v by +90°, clockwise on screen.")
	assert_eq(seen(["%Guess", "%Normal"]), [true, false] as Array[bool])
	await drag(Vec2.new(3, 1), Vec2.new(-1, 2))
	await student.press(&"lab_next_step")
	assert_reads("Your guess was 1 off.")
	assert_eq(seen(["%Normal"]), [true] as Array[bool])


func test_the_opposite_normal_is_chosen_before_it_is_shown() -> void:
	await go_to_step(NormalsTexts.Step.NORMAL)
	await student.press(&"lab_next_step")
	await click_button("(−y, −x)")
	assert_reads("No, (y, −x)")
	assert_eq(seen(["%Opposite"]), [true] as Array[bool])


func test_a_zero_vector_is_not_asked_about() -> void:
	await click_button("Zero")
	await go_to_step(NormalsTexts.Step.VECTOR)
	await student.press(&"lab_next_step")
	assert_reads("v is zero: (−y, x) is (0, 0), which is no normal.")
	await student.press(&"lab_next_step")
	assert_reads("v is zero: (y, −x) is (0, 0), too.")


func test_v_swings_at_the_opening_and_keeps_its_length() -> void:
	screen().free()
	OpeningMotion.is_allowed = true
	await open_lesson(LessonIndex.find(&"normals"))
	OpeningMotion.is_allowed = false
	for i: int in 20:
		await get_tree().process_frame
	var line := numbers("line")
	assert_ne(line[3], 1.0)
	assert_almost_eq(Vec2.new(line[2], line[3]).length(), sqrt(10.0), 0.01)
	assert_eq(line.slice(0, 2), PackedFloat64Array([0, 0]))


func test_a_zero_line_has_no_normal_and_says_so() -> void:
	await click_button("Zero")
	assert_reads("has no direction and no normal")
	assert_eq(readout_text(1, 1), "(0, 0)")


func test_undo_and_reset_bring_the_line_back() -> void:
	await drag(Vec2.new(3, 1), Vec2.new(1, 3))
	await click_button("y points up")
	await student.press(&"lab_undo")
	assert_eq(numbers("line"), PackedFloat64Array([0, 0, 3, 1]))
	await click_button("(3, −4)")
	await student.press(&"lab_reset")
	assert_eq(numbers("line"), PackedFloat64Array([0, 0, 3, 1]))
	assert_reads("y points up")


func test_mistake_9_shows_both_wrong_normals_beside_the_right_one() -> void:
	await pick_mistake("Mistake 9")
	assert_eq(seen(["%Normal", "%Swapped", "%WrongSign"]), [true, true, true] as Array[bool])
	assert_reads("(y, x): 53.1° from v, not +90°")
	assert_reads("The test wants the normal of (3, 1) to point along (−1, 3).")
	assert_has(formula_lines(), "✗ (y, x) = (1, 3)     v · ✗ (y, x) = 3·1 + 1·3 = 6")


func test_mistake_6_shows_nan_for_the_zero_vector() -> void:
	await pick_mistake("Mistake 6")
	assert_reads("wrong: (NaN, NaN)")
	assert_reads("right: (0, 0)")


func test_mistake_7_shows_a_short_vector_taken_for_zero() -> void:
	await pick_mistake("Mistake 7")
	assert_reads("wrong: (0, 0)")
	assert_reads("right: (−0.8, 0.6)")


func test_the_name_of_n_is_beside_it_where_the_unit_normal_is_longer() -> void:
	var normal := frame().lesson.get_node("%Normal") as Arrow
	assert_eq(normal.label_place, Arrow.LabelPlace.HEAD)
	await pick_mistake("Mistake 7")
	assert_eq(normal.label_place, Arrow.LabelPlace.MIDDLE)


func test_a_mistake_that_does_not_show_is_told_so() -> void:
	await click_button("(3, −4)")
	for number: int in [6, 7]:
		await pick_mistake("Mistake %d" % number)
		await student.enter(field("x of v"), "3")
		await student.enter(field("y of v"), "-4")
		assert_reads("Here the mistake\ndoes not show")
		assert_reads("Mistake %d is on. It shows only if" % number)
		assert_does_not_read("wrong:")
		assert_eq(seen(["%WrongUnit"]), [false] as Array[bool])


func test_swapped_components_are_right_by_luck_along_an_axis_only() -> void:
	await pick_mistake("Mistake 9")
	await student.enter(field("y of v"), "0")
	assert_reads("(y, x): +90° by luck, as y is 0")
	await student.enter(field("y of v"), "0.0001")
	assert_reads("(y, x): 89.996° from v, not +90°")


func test_no_line_divides_by_the_length_of_a_zero_vector() -> void:
	await pick_mistake("Mistake 6")
	assert_has(formula_lines(), "|n| = 0     n̂ = (0, 0)")
	assert_has(formula_lines(), "✗ divides 0 by 0")
	assert_false("".join(formula_lines()).contains("NaN"))


func test_a_length_just_below_1_is_shown_below_1() -> void:
	await pick_mistake("Mistake 7")
	await student.enter(field("x of v"), "0.99999")
	await student.enter(field("y of v"), "0")
	assert_has(formula_lines(), "✗ int(0.99999) = 0")


func test_with_a_mistake_on_each_step_speaks_of_what_is_shown() -> void:
	await pick_mistake("Mistake 9")
	for step: int in NormalsTexts.Step.values():
		await go_to_step(step)
		assert_reads("Mistake 9 is on:")
		assert_eq(seen(["%Normal", "%Swapped", "%Opposite"]), [true, true, false] as Array[bool])


func test_a_new_factor_shows_no_line_from_before() -> void:
	await student.enter(field("x of v"), "4")
	assert_eq(seen(["%OldV"]), [true] as Array[bool])
	await student.enter(field("How many times n̂ is drawn"), "3")
	assert_eq(seen(["%OldV"]), [false] as Array[bool])


func test_a_line_that_was_a_point_has_not_turned() -> void:
	await click_button("Zero")
	await student.enter(field("x of v"), "3")
	assert_does_not_read("turned by")


func test_switching_a_mistake_off_shows_all_again() -> void:
	await pick_mistake("Mistake 9")
	await student.press(&"lab_undo")
	assert_eq(seen(["%Opposite", "%Swapped"]), [true, false] as Array[bool])
	assert_does_not_read("The test wants")


func test_a_wrong_answer_is_named_and_the_right_one_taken() -> void:
	await student.click(frame().lesson.services[&"question"])
	var prompt := frame().lesson.services[&"question"].get_node("%Prompt") as Label
	var v := RegEx.create_from_string("\\((.+), (.+)\\)").search(prompt.text)
	var x := NumberText.parse(v.get_string(1))
	var y := NumberText.parse(v.get_string(2))
	await _answer(y, -x)
	assert_reads("That is the opposite normal (y, −x): −90°.")
	await _answer(-y, x)
	assert_reads("Right:")
	await click_button("Show on board")
	assert_eq(numbers("line"), PackedFloat64Array([0, 0, x, y]))


func _answer(x: float, y: float) -> void:
	await student.enter(field("nx ="), str(x))
	await student.enter(field("ny ="), str(y))
