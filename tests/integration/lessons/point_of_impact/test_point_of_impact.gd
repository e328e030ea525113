extends LessonTest
## Drives the lesson on the point of impact as a student does.


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"point_of_impact"))
	await go_to_step()


func test_it_starts_with_the_numbers_of_the_course() -> void:
	assert_has(formula_lines(), "a = 50 − 10 = 40     b = 50 − (−30) = 80")
	assert_has(formula_lines(), "t = a / b = 40 / 80 = 0.5")
	assert_reads("t = 0.5, within 0..1")


func test_the_readout_says_how_far_both_are_from_the_exact_contact() -> void:
	assert_eq(readout_text(1, 1), "(6, −8)")
	assert_eq(readout_text(2, 1), "(30, 10)")
	assert_lt(_pixels_off(), 1e-12)
	assert_eq(readout_text(2, 2), "30 px")


func test_for_any_speed_the_impact_is_exact_and_the_reset_misses() -> void:
	var misses: Dictionary[String, String] = {
		"10 px": "4.8 px", "38 px": "5.7 px", "72 px": "32.4 px", "500 px": "120 px"
	}
	for speed in misses:
		await click_button(speed)
		assert_eq(readout_text(1, 1), "(6, −8)", speed)
		assert_lt(_pixels_off(), 1e-12, speed)
		assert_eq(readout_text(2, 2), misses[speed])


func test_each_preset_is_explained_in_words() -> void:
	var words: Dictionary[String, String] = {
		"Not yet": "t = 1.333, above 1",
		"Inside": "too close already: contact at once",
		"Away": "it moves away: no impact",
		"Leaving": "it is on its way out: no impact",
		"Along": "b = 0: no t",
		"Lecture": "it touches in this frame",
	}
	for title in words:
		await click_button(title)
		assert_reads(words[title])


func test_old_and_new_position_can_be_dragged() -> void:
	await drag(Vec2.new(6, -58), Vec2.new(-20, -55))
	assert_eq(numbers("old"), PackedFloat64Array([-20, -55]))
	await drag(Vec2.new(9, 45), Vec2.new(33, 35))
	assert_eq(numbers("new"), PackedFloat64Array([30, 32]))


func test_a_ball_dragged_away_from_the_line_has_no_impact() -> void:
	await drag(Vec2.new(6, 42), Vec2.new(70, -60))
	assert_reads("it moves away: no impact")
	assert_eq(seen(["%Impact", "%Reset", "%Off"]), [false, false, false])
	assert_eq(readout_text(1, 1), "none")


func test_clicks_set_old_and_new() -> void:
	await student.click_at(place(40, -50))
	assert_eq(numbers("old"), PackedFloat64Array([40, -50]))
	await student.click_at(place(-30, 50), MOUSE_BUTTON_RIGHT)
	assert_eq(numbers("new"), PackedFloat64Array([-30, 50]))


func test_keys_nudge_a_position_by_one_pixel() -> void:
	Screen.named(screen(), "New position").grab_focus()
	await student.press(&"ui_left")
	await student.press(&"ui_down")
	assert_eq(numbers("new"), PackedFloat64Array([5, 43]))


func test_the_line_can_be_turned_and_moved() -> void:
	await drag(Vec2.new(60, 45), Vec2.new(60, 0))
	assert_eq(numbers("line"), PackedFloat64Array([60, 0, -60, -45]))
	await drag(Vec2.new(24, -13.5), Vec2.new(24, -3.5))
	assert_eq(numbers("line"), PackedFloat64Array([60, 10, -60, -35]))


func test_every_number_can_be_typed() -> void:
	var titles: Dictionary[String, String] = {
		"x of the old position": "10",
		"y of the old position": "-60",
		"x of the new position": "-8",
		"y of the new position": "31.5",
		"x of the line's start": "70",
		"y of the line's start": "40",
		"x of the line's end": "-50",
		"y of the line's end": "-20",
		"radius of the ball": "8",
	}
	for title in titles:
		await student.enter(field(title), titles[title])
	assert_eq(numbers("old"), PackedFloat64Array([10, -60]))
	assert_eq(numbers("new"), PackedFloat64Array([-8, 31.5]))
	assert_eq(numbers("line"), PackedFloat64Array([70, 40, -50, -20]))
	var radius: float = frame().lesson.state()["radius"]
	assert_eq(radius, 8.0)


func test_a_typed_speed_makes_the_motion_longer() -> void:
	await student.enter(field("speed in pixels per frame"), "1000")
	assert_eq(numbers("new"), PackedFloat64Array([6, 942]))
	assert_has(formula_lines(), "t = a / b = 40 / 800 = 0.05")


# Any error in the log fails the test.
func test_the_largest_numbers_are_taken_and_drawn_without_an_error() -> void:
	for title: String in [
		"radius of the ball",
		"speed in pixels per frame",
		"x of the old position",
		"y of the line's end"
	]:
		await student.enter(field(title), "1e100")
	assert_eq(numbers("old"), PackedFloat64Array([1e100, -58]))
	assert_eq(numbers("new"), PackedFloat64Array([6, 1e100]))


func test_old_and_new_at_the_same_place_divide_nothing() -> void:
	await student.enter(field("y of the new position"), "-58")
	assert_reads("v = 0: no t")
	assert_reads("it does not move")
	await go_to_step(0)
	assert_reads("Old and new are the same point")
	assert_eq(seen(["%Ghost"]), [false])
	await go_to_step()
	assert_has(formula_lines(), "t: none, b is 0")


func test_a_speed_of_0_is_refused_with_a_sentence() -> void:
	await student.enter(field("speed in pixels per frame"), "0")
	assert_reads("The speed must be above 0")
	assert_eq(numbers("new"), PackedFloat64Array([6, 42]))


func test_undo_redo_and_reset() -> void:
	await click_button("500 px")
	await student.press(&"lab_undo")
	assert_eq(numbers("old"), PackedFloat64Array([6, -58]))
	await student.press(&"lab_redo")
	assert_eq(numbers("old"), PackedFloat64Array([6, -308]))
	await student.press(&"lab_reset")
	assert_eq(numbers("old"), PackedFloat64Array([6, -58]))
	assert_reads("t = 0.5, within 0..1")


func test_steps_build_the_drawing_and_the_formula_up() -> void:
	var parts: Array[String] = ["%Motion", "%Reset", "%OldDistance", "%A", "%Impact"]
	assert_eq(seen(parts), [true, true, false, true, true])
	for i: int in 5:
		await student.press(&"lab_previous_step")
	assert_eq(seen(parts), [true, false, false, false, false])
	assert_eq(formula_lines().size(), 3)
	await student.press(&"lab_next_step")
	assert_eq(seen(parts), [true, true, false, false, false])
	assert_has(formula_lines(), "reset = new + (10 − (−30)) n̂ = (30, 10)")
	await student.press(&"lab_next_step")
	assert_eq(seen(parts), [true, false, true, false, false])
	assert_has(formula_lines(), "old distance = 50     new distance = −30")
	await student.press(&"lab_next_step")
	assert_eq(seen(parts), [true, false, false, true, false])
	await go_to_step()
	assert_eq(seen(parts), [true, true, false, true, true])
	assert_has(formula_lines(), "POI = old + t v = (6, −8)")


func test_the_three_lengths_are_measured_from_the_line() -> void:
	await go_to_step(PointOfImpactTexts.Step.DISTANCES)
	var wanted: Dictionary[String, String] = {
		"%OldDistance": "old 50", "%NewDistance": "new −30", "%Radius": "r 10"
	}
	for part in wanted:
		var length := frame().lesson.get_node(part) as DimensionLine
		assert_eq(length.label, wanted[part])
		var measured := length.from.distance_to(length.to)
		assert_almost_eq(measured, absf(NumberText.parse(wanted[part].get_slice(" ", 1))), 1e-4)


func test_both_ends_of_the_frame_count() -> void:
	await click_button("t = 0")
	assert_reads("it touches at the start of the frame, in old")
	assert_eq((frame().lesson.get_node("%ImpactName") as BallName).label, "old = POI")
	await click_button("t = 1")
	assert_reads("it touches at the end of the frame, in new")
	assert_eq((frame().lesson.get_node("%ImpactName") as BallName).label, "POI")


func test_a_fraction_is_an_answer() -> void:
	var question := frame().lesson.services[&"question"] as Question
	question.folded = false
	await student.settle()
	await student.enter(field("t ="), "0/5")
	assert_reads("0 is not it yet")


func test_each_mistake_shows_its_wrong_share_beside_the_right_one() -> void:
	var wrong: Dictionary[String, String] = {
		"Mistake 15": "40 / (−30) = −1.333",
		"Mistake 16": "(|50| − 10) / (|50| − |(−30)|) = 2",
		"Mistake 20": "((−30) − 10) / 80 = −0.5",
	}
	for heading in wrong:
		await pick_mistake(heading)
		assert_eq(formula_lines()[-1], "wrong: " + wrong[heading])
		assert_eq(seen(["%Impact", "%Wrong"]), [true, true])
		assert_reads("The test ")
	await pick_mistake("No mistake")
	assert_eq(seen(["%Impact", "%Wrong"]), [true, false])


func test_a_mistake_that_divides_by_0_loses_the_ball_and_nothing_breaks() -> void:
	await pick_mistake("Mistake 17")
	await click_button("Along")
	assert_reads("the mistake divides by 0: the ball is lost")
	assert_eq(seen(["%Wrong"]), [false])


func test_a_mistake_that_changes_nothing_says_so() -> void:
	await pick_mistake("Mistake 17")
	await click_button("Lecture")
	assert_reads("the mistake changes nothing here")
	assert_eq(formula_lines()[-1], "wrong: 40 / 80 = 0.5")


func test_a_mistake_that_this_frame_would_not_show_brings_one_that_does() -> void:
	await pick_mistake("Mistake 17")
	assert_reads("the mistake takes t = 1.333 all the same")
	assert_eq(formula_lines()[-1], "wrong: 40 / 30 = 1.333")
	assert_eq(seen(["%Impact", "%Wrong"]), [false, true])
	await click_button("Inside")
	await pick_mistake("Mistake 17")
	assert_eq(formula_lines()[-1], "wrong: (−5) / 20 = −0.25")


func test_a_mistake_that_no_speed_of_the_course_shows_brings_a_frame_that_does() -> void:
	await click_button("10 px")
	await pick_mistake("Mistake 16")
	assert_eq(formula_lines()[-1], "wrong: (|50| − 10) / (|50| − |(−30)|) = 2")


func test_a_mistake_picked_at_the_first_step_leads_to_the_step_of_t() -> void:
	await go_to_step(0)
	await pick_mistake("Mistake 15")
	assert_eq(frame().lesson.step, PointOfImpactTexts.Step.FRACTION)
	assert_reads("Compare the t of the mistake")
	await go_to_step(PointOfImpactTexts.Step.WAYS)
	assert_eq(seen(["%Verdict", "%Wrong"]), [false, false])
	assert_eq(formula_lines()[-1], "a = 50 − 10 = 40     b = 50 − (−30) = 80")


func test_the_ghost_shows_a_moment_of_the_frame() -> void:
	await go_to_step(PointOfImpactTexts.Step.FRACTION)
	await drag(Vec2.new(6, -38), Vec2.new(30, 22))
	var moment: float = frame().lesson.state()["moment"]
	assert_almost_eq(moment, 0.8, 1e-12)
	assert_eq((frame().lesson.get_node("%GhostName") as BallName).label, "t = 0.8")
	await drag(Vec2.new(6, 22), Vec2.new(6, 90))
	moment = frame().lesson.state()["moment"]
	assert_eq(moment, 1.0)


func test_the_impact_is_asked_for_before_it_is_shown() -> void:
	await go_to_step(PointOfImpactTexts.Step.WAYS)
	await student.press(&"lab_next_step")
	await click_button("within the frame")
	assert_reads("Right")
	await student.press(&"lab_next_step")
	assert_eq(seen(["%Guess", "%Impact"]), [true, false])
	await drag(Vec2.new(6, -48), Vec2.new(6, -8))
	await student.press(&"lab_next_step")
	assert_reads("Exactly.")
	assert_eq(seen(["%Guess", "%Impact"]), [true, true])


func test_a_question_is_answered_and_shown_on_the_board() -> void:
	var question := frame().lesson.services[&"question"] as Question
	question.folded = false
	await student.settle()
	await student.enter(field("t ="), "123456")
	assert_reads("not it yet")
	await click_button("Show on board")
	var model := PointOfImpactModel.new()
	model.from_dictionary(frame().lesson.state())
	await student.enter(field("t ="), str(snappedf(model.fraction(), 0.01)))
	assert_reads("Right: ")


func test_at_every_size_the_card_stays_on_the_board() -> void:
	for size: Vector2i in [Vector2i(720, 1280), Vector2i(800, 600), Vector2i(1920, 1080)]:
		await resize(size)
		var board := frame().lesson.get_global_rect()
		var card := frame().lesson.get_node("%Verdict") as Control
		assert_true(board.encloses(card.get_global_rect()), str(size))


# What the readout says of the point of impact, in pixels.
func _pixels_off() -> float:
	return NumberText.parse(readout_text(1, 2).get_slice(" ", 0))
