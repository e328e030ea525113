extends LessonTest
## Drives the lesson on the distance from a line as a student does.


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"line_distance"))
	await go_to_step(LineDistanceTexts.Step.SEGMENT)


func test_it_starts_with_a_free_ball_and_its_distance() -> void:
	assert_reads("Free: gap 70 px")
	assert_has(formula_lines(), "d · n̂ = 200·0.6 + 25·(−0.8) = 100")
	assert_eq(readout_text(1, 1), "100")
	assert_eq(readout_text(2, 1), "100")


func test_sliding_p_along_the_line_leaves_the_distance_as_it_is() -> void:
	await drag(Vec2.new(-80, -60), Vec2.new(150, 100))
	assert_almost_eq(_share(), 0.14, 0.01)
	assert_eq(readout_text(1, 1), "100")
	assert_eq(_ball(), PackedFloat64Array([120, -35, 30]))


func test_p_slides_beyond_the_ends_of_the_line() -> void:
	await drag(Vec2.new(-80, -60), Vec2.new(-220, -180))
	assert_gt(_share(), 1.0)
	assert_eq(readout_text(1, 1), "100")


func test_arrow_keys_slide_p() -> void:
	Screen.named(screen(), "Point p of the line").grab_focus()
	await student.press(&"ui_right")
	assert_lt(_share(), 0.7)
	assert_almost_eq(_share(), 0.7 - 5.0 * 0.8 / 500.0, 1e-12)


func test_the_ball_is_dragged_by_any_point_inside_its_rim() -> void:
	await drag(Vec2.new(135, -50), Vec2.new(90, 10))
	assert_eq(_ball(), PackedFloat64Array([75, 25, 30]))
	assert_reads("Too close: gap −5 px")


func test_a_ball_behind_the_line_says_so() -> void:
	await drag(Vec2.new(120, -35), Vec2.new(25, 95))
	assert_reads("Behind the line")
	assert_reads("d · n̂ is negative on this side")


func test_a_left_click_puts_the_ball_and_a_right_click_p() -> void:
	await student.click_at(place(-60, 120))
	assert_eq(_ball(), PackedFloat64Array([-60, 120, 30]))
	await student.click_at(place(130, 20), MOUSE_BUTTON_RIGHT)
	assert_almost_eq(_share(), 0.268, 0.01)


func test_the_line_can_be_turned_and_moved() -> void:
	await drag(Vec2.new(200, 150), Vec2.new(200, 50))
	assert_eq(_line(), PackedFloat64Array([200, 50, -200, -150]))
	await drag(Vec2.new(40, -30), Vec2.new(40, 20))
	assert_eq(_line(), PackedFloat64Array([200, 100, -200, -100]))


func test_keys_nudge_the_ball_by_5_pixels() -> void:
	Screen.named(screen(), "Ball").grab_focus()
	await student.press(&"ui_down")
	assert_eq(_ball(), PackedFloat64Array([120, -30, 30]))


func test_every_number_can_be_typed() -> void:
	var titles: Dictionary[String, String] = {
		"x of the line's start": "210",
		"y of the line's start": "160",
		"x of the line's end": "-210",
		"y of the line's end": "-170",
		"x of the ball's centre": "12.5",
		"y of the ball's centre": "-80",
		"radius of the ball": "25",
		"place of p: 0 at the start, 1 at the end": "-0.5",
	}
	for title in titles:
		await student.enter(field(title), titles[title])
	assert_eq(_line(), PackedFloat64Array([210, 160, -210, -170]))
	assert_eq(_ball(), PackedFloat64Array([12.5, -80, 25]))
	assert_eq(_share(), -0.5)


# Any error in the log fails the test.
func test_the_largest_numbers_are_taken_and_drawn_without_an_error() -> void:
	for title: String in [
		"radius of the ball",
		"x of the ball's centre",
		"place of p: 0 at the start, 1 at the end",
		"y of the line's end"
	]:
		await student.enter(field(title), "1e100")
	assert_eq(_ball(), PackedFloat64Array([1e100, -35, 1e100]))
	assert_eq(_share(), 1e100)


func test_a_radius_below_0_is_refused_with_a_sentence() -> void:
	await student.enter(field("radius of the ball"), "-4")
	assert_reads("radius must be above 0")
	assert_eq(_ball(), PackedFloat64Array([120, -35, 30]))


func test_a_line_of_length_0_is_refused_with_a_sentence() -> void:
	await drag(Vec2.new(-200, -150), Vec2.new(200, 150))
	assert_reads("longer than 0")
	assert_ne(_line().slice(0, 2), _line().slice(2, 4))


func test_undo_redo_and_reset() -> void:
	await drag(Vec2.new(120, -35), Vec2.new(75, 25))
	await student.press(&"lab_undo")
	assert_eq(_ball(), PackedFloat64Array([120, -35, 30]))
	await student.press(&"lab_redo")
	assert_eq(_ball(), PackedFloat64Array([75, 25, 30]))
	await student.press(&"lab_reset")
	assert_eq(_ball(), PackedFloat64Array([120, -35, 30]))
	assert_reads("Free: gap 70 px")


func test_steps_build_the_formula_up_and_back() -> void:
	assert_eq(formula_lines().size(), 7)
	for left: int in [6, 5, 4, 3]:
		await student.press(&"lab_previous_step")
		assert_eq(formula_lines().size(), left)
	assert_reads("d leads from p, a point on the line")
	await student.press(&"lab_next_step")
	assert_eq(formula_lines().size(), 4)


func test_steps_build_the_drawing_up() -> void:
	await go_to_step(0)
	assert_eq(seen(["%Difference", "%Normal", "%Shadow", "%Gap"]), [true, false, false, false])
	await student.press(&"lab_next_step")
	assert_eq(seen(["%Difference", "%Normal", "%Shadow", "%Gap"]), [true, true, false, false])
	await go_to_step(LineDistanceTexts.Step.DISTANCE)
	assert_eq(seen(["%Difference", "%Normal", "%Shadow", "%Gap"]), [true, true, true, false])
	await go_to_step(LineDistanceTexts.Step.GAP)
	assert_eq(seen(["%Difference", "%Normal", "%Shadow", "%Gap"]), [true, true, true, true])


func test_the_foot_and_the_gap_are_asked_for_before_they_are_shown() -> void:
	await go_to_step(LineDistanceTexts.Step.NORMAL)
	await student.press(&"lab_next_step")
	assert_eq(seen(["%Guess", "%Shadow"]), [true, false])
	await drag(Vec2.new(-80, -60), Vec2.new(60, 45))
	await student.press(&"lab_next_step")
	assert_reads("Exactly.")
	await student.press(&"lab_next_step")
	await click_button("free")
	assert_reads("Right")
	assert_reads("Free: gap 70 px")


func test_beside_the_end_both_distances_are_shown() -> void:
	await click_button("Past the end")
	assert_reads("Too close: gap −5 px")
	assert_reads("but the gap to the segment is 35 px")
	assert_has(formula_lines(), "to the segment: |c − (200, 150)| = 65")
	assert_eq(seen(["%ToSegment"]), [true])


func test_each_preset_can_be_set_up() -> void:
	var gaps: Dictionary[String, String] = {
		"Too close": "Too close: gap −5 px",
		"Behind": "Behind the line: gap −90 px",
		"p far away": "Free: gap 70 px",
		"Free": "Free: gap 70 px",
	}
	for title in gaps:
		await click_button(title)
		assert_reads(gaps[title])


func test_each_mistake_shows_its_wrong_distance_beside_the_right_one() -> void:
	var wrong: Dictionary[String, String] = {
		"Part 2": "= 125", "Mistake 9": "= −100", "Mistake 10": "= 50000"
	}
	for heading in wrong:
		await pick_mistake(heading)
		assert_true(formula_lines()[-1].ends_with(wrong[heading]), formula_lines()[-1])
		assert_has(formula_lines(), "d · n̂ = 200·0.6 + 25·(−0.8) = 100")
		assert_reads("The test ")
		assert_eq(seen(["%WrongBall", "%WrongWay", "%RightWay"]), [true, true, true])
	await pick_mistake("No mistake")
	assert_eq(seen(["%WrongBall", "%WrongWay", "%RightWay"]), [false, false, false])


func test_a_mistake_picked_at_the_first_step_leads_to_the_step_of_the_distance() -> void:
	await go_to_step(0)
	await pick_mistake("Mistake 9")
	assert_eq(frame().lesson.step, LineDistanceTexts.Step.DISTANCE)
	assert_reads("Compare the distance of the mistake")
	await go_to_step(LineDistanceTexts.Step.NORMAL)
	assert_eq(seen(["%WrongBall", "%WrongWay", "%RightWay"]), [false, false, false])
	assert_false(formula_lines()[-1].begins_with("wrong"), formula_lines()[-1])


func test_a_ball_that_just_touches_is_neither_free_nor_too_close() -> void:
	await student.enter(field("x of the ball's centre"), "78")
	await student.enter(field("y of the ball's centre"), "21")
	assert_reads("It just touches the line: gap 0 px")
	assert_eq((frame().lesson.get_node("%JudgedBall") as BallView).label, "touching")


func test_the_mistake_of_measuring_straight_up_survives_a_vertical_line() -> void:
	await pick_mistake("Part 2")
	await student.enter(field("x of the line's end"), "200")
	assert_eq(seen(["%WrongBall", "%WrongWay"]), [false, false])


func test_a_mistake_can_be_undone() -> void:
	await pick_mistake("Mistake 9")
	await student.press(&"lab_undo")
	var mistake: int = frame().lesson.state()["mistake"]
	assert_eq(mistake, 0)
	assert_does_not_read("The test ")


func test_a_fast_ball_jumps_over_the_line_and_a_slow_one_is_seen() -> void:
	await click_button("Fast ball")
	assert_eq(frame().lesson.step, LineDistanceTexts.Step.DETECTION)
	assert_reads("is never seen")
	assert_reads("red in 0 of 2 frames")
	await click_button("Slow ball")
	assert_reads("red in 1 of 5 frames")
	assert_eq(formula_lines()[-1], "|(−40)| ≥ 30     not red")
	await student.press(&"lab_previous_frame")
	assert_eq(formula_lines()[-1], "|(−5)| < 30     red")
	await student.press(&"lab_previous_frame")
	assert_eq(formula_lines()[-2], "frame 2     100 − 2·35 = 30")
	assert_reads("red in 0 of 3 frames")


func test_the_flight_plays_to_its_end() -> void:
	await go_to_step(LineDistanceTexts.Step.DETECTION)
	await student.press(&"lab_pause")
	assert_reads("of 1 frames")
	var transport := frame().lesson.services[&"transport"] as Transport
	for wait: int in 3000:
		if not transport.is_playing:
			break
		await get_tree().process_frame
	assert_reads("red in 2 of 5 frames")


func test_the_test_of_detection_and_the_speed_can_be_chosen_and_undone() -> void:
	await go_to_step()
	assert_reads("red in 2 of 5 frames")
	(frame().lesson.services[&"options"] as LessonOptions).chosen.emit("rule", 1)
	assert_reads("red in 0 of 5 frames")
	await student.enter(field("speed of the ball in pixels per frame"), "38")
	assert_reads("red in 1 of 5 frames")
	await student.press(&"lab_undo")
	await student.press(&"lab_undo")
	assert_reads("red in 2 of 5 frames")
	await student.enter(field("speed of the ball in pixels per frame"), "0")
	assert_reads("The speed must be above 0")


func test_a_question_is_answered_and_shown_on_the_board() -> void:
	var question := frame().lesson.services[&"question"] as Question
	question.folded = false
	await student.settle()
	await student.enter(field("d · n̂ ="), "123456")
	assert_reads("not it yet")
	await click_button("Show on board")
	assert_ne(_line(), PackedFloat64Array([200, 150, -200, -150]))
	await student.enter(field("d · n̂ ="), _typed_distance())
	assert_reads("Right: ")


func test_the_card_gives_way_to_the_ball() -> void:
	var card := frame().lesson.get_node("%Verdict") as Control
	await drag(Vec2.new(120, -35), Vec2.new(-100, 140))
	assert_false(card.get_global_rect().has_point(place(-100, 140)))
	assert_true(frame().lesson.get_global_rect().encloses(card.get_global_rect()))


func test_the_card_gives_way_to_the_wrong_ball_too() -> void:
	var card := frame().lesson.get_node("%Verdict") as Control
	for size: Vector2i in [Vector2i(1280, 720), Vector2i(720, 1280)]:
		await resize(size)
		await pick_mistake("Mistake 9")
		var model := LineDistanceModel.new()
		model.from_dictionary(frame().lesson.state())
		var wrong := model.position_with_mistake()
		var radius := model.ball.radius * frame().lesson.board.pixels_per_unit
		var covered := card.get_global_rect().grow(radius)
		assert_false(covered.has_point(place(wrong.x, wrong.y)), str(size))


func test_at_every_size_nothing_is_logged_and_the_card_stays_on_the_board() -> void:
	for size: Vector2i in [Vector2i(720, 1280), Vector2i(800, 600), Vector2i(1920, 1080)]:
		await resize(size)
		var board := frame().lesson.get_global_rect()
		var card := frame().lesson.get_node("%Verdict") as Control
		assert_true(board.encloses(card.get_global_rect()), str(size))


func _line() -> PackedFloat64Array:
	return numbers("line")


func _ball() -> PackedFloat64Array:
	return numbers("ball")


func _share() -> float:
	var share: float = frame().lesson.state()["from_share"]
	return share


# The signed distance on the board, as one would type it.
func _typed_distance() -> String:
	var line := LineSegment.new(Vec2.new(_line()[0], _line()[1]), Vec2.new(_line()[2], _line()[3]))
	return str(snappedf(LineDistance.signed_distance(Vec2.new(_ball()[0], _ball()[1]), line), 0.01))


func test_in_a_narrow_panel_the_formula_breaks_between_pairs_and_not_inside() -> void:
	await resize(Vector2i(390, 844))
	var rows: Dictionary[String, float] = {}
	for title: String in ["line's start", "line's end", "ball's centre"]:
		var x := Screen.named(screen(), "x of the " + title)
		var y := Screen.named(screen(), "y of the " + title)
		assert_eq(x.global_position.y, y.global_position.y, title)
		rows[title] = x.global_position.y
	assert_gt(rows["line's end"], rows["line's start"], "both pairs have no room in one row")
