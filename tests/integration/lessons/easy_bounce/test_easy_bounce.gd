extends LessonTest
## Drives the lesson on the easy bounce as a student does.

const _PARTS_OF_STEPS: Array[String] = ["%Before", "%Shortest", "%RightBall", "%RightPath"]


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"easy_bounce"))
	await go_to_step(EasyBounceTexts.Step.BOUNCE)


func test_it_starts_with_a_level_floor_and_no_error() -> void:
	assert_reads("The easy way is right")
	assert_has(formula_lines(), "easy: floor − y = 40 − 4 = 36     36 < r = 60: hit")
	for row: int in [1, 2, 3, 4]:
		assert_eq(readout_text(row, 2), "0")


func test_the_steps_show_one_thing_at_a_time() -> void:
	var wanted: Array[Array] = [
		[false, false, true, true],
		[false, false, true, false],
		[false, false, true, false],
		[false, true, false, false],
		[true, false, false, false],
	]
	for row: Array in wanted:
		assert_eq(Array(seen(_PARTS_OF_STEPS)), row)
		await student.press(&"lab_previous_step")


func test_card_and_table_come_with_the_steps() -> void:
	await go_to_step(EasyBounceTexts.Step.MOVE)
	assert_eq(seen(["%Verdict"]), [false] as Array[bool])
	assert_eq(_rows(), [] as Array[String])
	await go_to_step(EasyBounceTexts.Step.DETECT)
	assert_reads("straight is the shortest way")
	assert_eq(_rows(), ["easy distance", "by the normal"] as Array[String])
	await go_to_step(EasyBounceTexts.Step.FLIP)
	assert_has(_rows(), "easy velocity")
	await go_to_step(EasyBounceTexts.Step.PUT_BACK)
	assert_eq(_rows(), ["easy distance", "by the normal", "easy place"] as Array[String])


func test_the_place_of_the_ball_is_guessed_before_it_is_shown() -> void:
	await go_to_step(EasyBounceTexts.Step.DETECT)
	await student.press(&"lab_next_step")
	assert_reads("Where must the centre go, so that the ball just touches?")
	assert_eq(seen(["%Guess", "%RightBall"]), [true, false] as Array[bool])
	await drag(Vec2.new(0, 4), Vec2.new(0, -16))
	await student.press(&"lab_next_step")
	assert_reads("Your guess was 4 off.")
	assert_eq(seen(["%RightBall"]), [true] as Array[bool])


func test_the_component_that_flips_is_guessed_on_a_level_line_only() -> void:
	var verdicts: Dictionary[String, String] = {"y of v": "Right: y of v", "x of v": "No, y of v"}
	for choice: String in verdicts:
		await student.press(&"lab_reset")
		await go_to_step(EasyBounceTexts.Step.PUT_BACK)
		await student.press(&"lab_next_step")
		await click_button(choice)
		assert_reads(verdicts[choice])
	await click_button("30°")
	await student.press(&"lab_reset")
	await click_button("30°")
	await go_to_step(EasyBounceTexts.Step.PUT_BACK)
	await student.press(&"lab_next_step")
	assert_does_not_read("Which component of v changes its sign?")


func test_where_nothing_hits_nothing_is_asked_and_nothing_is_drawn() -> void:
	await student.enter(field("y of the ball"), "-70")
	await go_to_step(EasyBounceTexts.Step.DETECT)
	await student.press(&"lab_next_step")
	assert_reads("Put back: only after a hit. Here the ball does not hit.")
	assert_reads("nothing to put back")
	assert_has(formula_lines(), "easy: no hit: P stays")
	assert_eq(seen(["%Guess", "%RightBall", "%EasyBall"]), [false, false, false] as Array[bool])


func test_the_ball_swings_at_the_opening_and_begins_at_its_start() -> void:
	screen().free()
	OpeningMotion.is_allowed = true
	await open_lesson(LessonIndex.find(&"easy_bounce"))
	OpeningMotion.is_allowed = false
	var reached := 0.0
	for i: int in 40:
		await get_tree().process_frame
		reached = minf(reached, numbers("ball")[1] - 4.0)
		assert_true(_is_on_its_way(), "on the way of v, and over the line")
	assert_lt(reached, 0.0)


func test_on_a_tilted_line_the_easy_way_is_drawn_beside_the_right_one() -> void:
	await click_button("30°")
	assert_eq(seen(["%EasyPath", "%EasyBall"]), [true, true] as Array[bool])
	await student.press(&"lab_previous_step")
	assert_eq(seen(["%EasyArrow", "%RightArrow"]), [true, true] as Array[bool])
	assert_reads("52 px per frame off")
	await student.press(&"lab_previous_step")
	assert_reads("Put back 14.4 px off")
	assert_reads("and still 8.04 px deep")
	await student.press(&"lab_previous_step")
	assert_eq(seen(["%Straight", "%Shortest", "%FromL"]), [true, true, true] as Array[bool])
	assert_reads("4.82 px too far")


func test_in_a_frame_without_a_hit_the_card_names_no_mistake() -> void:
	await click_button("30°")
	await click_button("One frame on")
	assert_reads("Frame 1:\nthe easy ball is 61.2 px off")
	await student.press(&"lab_previous_step")
	assert_reads("No hit:\nv stays")
	assert_has(formula_lines(), "right: no hit: v stays")
	await go_to_step(EasyBounceTexts.Step.BOUNCE)
	for i: int in 2:
		await click_button("One frame back")
	assert_reads("Frame −1:\nboth balls are in one place")


# What is true of a ball does not depend on the frame in which it is shown.
func test_each_frame_says_of_its_ball_what_frame_0_says_of_the_same_ball() -> void:
	for tilt: String in ["0°", "30°", "−45°"]:
		await click_button(tilt)
		var first: Dictionary = frame().lesson.state()
		for step: int in [0, 1, 2, 3]:
			await go_to_step(step)
			for in_frame: int in 9:
				await click_button("One frame on")
				var ball := _ball_shown()
				var said := _said()
				var same := first.duplicate()
				same["ball"] = ball
				frame().lesson.show_state(same)
				assert_eq(_said(), said, "%s, step %d, %s" % [tilt, step + 1, ball])
				frame().lesson.show_state(first)
				for i: int in in_frame + 1:
					(frame().lesson.services[&"transport"] as Transport).advanced.emit(1.0 / 60.0)


func test_what_each_step_says_in_each_frame_is_true() -> void:
	var judge := LessonJudge.of(&"easy_bounce")
	await click_button("Wall instead of floor")
	for tilt: String in ["0°", "30°", "−45°"]:
		await click_button(tilt)
		for step: int in 5:
			await go_to_step(step)
			for i: int in 9:
				await click_button("One frame on")
				var what := SeenLesson.of(frame())
				assert_eq(judge.problem(what), "", "%s, step %d, %s" % [tilt, step + 1, what.lines])


# Rounding would be 1.4e-14 here.
func test_a_difference_that_is_rounding_alone_is_shown_as_0() -> void:
	await click_button("30°")
	await student.enter(field("y of the ball"), "120")
	await go_to_step(EasyBounceTexts.Step.DETECT)
	assert_has(
		formula_lines(),
		"right: (P − L) · n̂ = (−138.56)·0.5 + 0·(−0.86603) = −69.28     −69.28 < r = 60: hit"
	)


func test_hidden_answers_hide_the_hit() -> void:
	await student.press(&"lab_hide_answers")
	assert_has(formula_lines(), "easy: floor − y = ? − ? = ?     ?")
	await student.press(&"lab_hide_answers")
	assert_has(formula_lines(), "easy: floor − y = 40 − 4 = 36     36 < r = 60: hit")


func test_behind_a_tilted_line_the_easy_distance_is_too_far_by_a_size() -> void:
	await click_button("30°")
	await student.enter(field("y of the ball"), "120")
	await go_to_step(EasyBounceTexts.Step.DETECT)
	assert_reads("Straight is not shortest:\n10.7 px too far")
	await go_to_step(EasyBounceTexts.Step.MOVE)
	assert_reads("Now the ball is behind the line.")


func test_a_ball_that_the_easy_way_misses_is_told_so() -> void:
	await click_button("30°")
	await student.enter(field("y of the ball"), "-25")
	await go_to_step(EasyBounceTexts.Step.DETECT)
	assert_reads("The easy way misses the hit:")
	await go_to_step(EasyBounceTexts.Step.PUT_BACK)
	assert_reads("the ball stays 3.71 px deep")


func test_on_a_tilted_line_the_readout_holds_the_size_of_each_error() -> void:
	await click_button("30°")
	assert_eq(readout_text(1, 2), "4.82")
	assert_eq(readout_text(3, 2), "14.4")
	assert_eq(readout_text(4, 2), "52")
	await click_button("0°")
	assert_eq(readout_text(4, 2), "0")


func test_dragging_an_end_tilts_the_line() -> void:
	await drag(Vec2.new(160, 40), Vec2.new(156, 92))
	assert_eq(_tilt(), 18.0)
	await drag(Vec2.new(-152.2, -9.4), Vec2.new(-152, 40))
	assert_eq(_tilt(), 0.0)


func test_dragging_the_line_moves_it_without_tilting() -> void:
	await drag(Vec2.new(-100, 40), Vec2.new(-80, 60))
	assert_eq(numbers("pivot"), PackedFloat64Array([20, 60]))
	assert_eq(_tilt(), 0.0)


func test_the_keys_at_an_end_tilt_by_a_degree() -> void:
	Screen.named(screen(), "End of line").grab_focus()
	await student.press(&"ui_down")
	assert_eq(_tilt(), -1.0)
	for i: int in 3:
		await student.press(&"ui_up")
	assert_eq(_tilt(), 2.0)


func test_dragging_the_ball_or_its_velocity_sets_them() -> void:
	await drag(Vec2.new(-30, 4), Vec2.new(-50, -16))
	assert_eq(numbers("ball"), PackedFloat64Array([-20, -16, 20, 48, 60]))
	await drag(Vec2.new(0, 32), Vec2.new(20, 8))
	assert_eq(numbers("ball"), PackedFloat64Array([-20, -16, 40, 24, 60]))


func test_every_number_can_be_typed() -> void:
	await student.enter(field("x of the ball"), "8")
	await student.enter(field("y of the ball"), "-6")
	await student.enter(field("x of v"), "-3")
	await student.enter(field("y of v"), "44.5")
	await student.enter(field("Radius of the ball"), "50")
	await student.enter(field("Tilt of the line in degrees"), "-12.5")
	assert_eq(numbers("ball"), PackedFloat64Array([8, -6, -3, 44.5, 50]))
	assert_eq(_tilt(), -12.5)


func test_huge_and_tiny_numbers_leave_finite_results() -> void:
	await click_button("30°")
	await student.enter(field("x of the ball"), "1e99")
	await student.enter(field("y of v"), "-1e99")
	await student.enter(field("x of v"), "1e-99")
	for row: int in [1, 2, 3, 4]:
		var text := readout_text(row, 1) + readout_text(row, 2)
		assert_false(text.contains("NaN") or text.contains("∞"), text)


func test_a_tilt_that_is_too_steep_is_refused_and_the_old_one_stays() -> void:
	await student.enter(field("Tilt of the line in degrees"), "80")
	assert_reads("The tilt must be within −45° and 45°, not 80°.")
	assert_eq(_tilt(), 0.0)
	assert_eq(field("Tilt of the line in degrees").text, "0")


func test_one_frame_on_and_one_back_lead_to_the_very_same_numbers() -> void:
	await click_button("30°")
	var before := formula_lines()
	await click_button("One frame on")
	assert_has(formula_lines(), "r = 60     tilt = 30°     frame 1")
	assert_ne(formula_lines()[0], before[0])
	await click_button("One frame back")
	assert_eq(formula_lines(), before)


func test_playing_moves_the_ball_and_a_drag_pauses_it() -> void:
	var transport := frame().lesson.services[&"transport"] as Transport
	await student.press(&"lab_pause")
	transport.advanced.emit(0.25)
	assert_has(formula_lines(), "P = ( 40 , -116 )     v = ( 20 , -48 )")
	await drag(Vec2.new(30, -116), Vec2.new(30, -96))
	assert_false(transport.is_playing)
	assert_eq(numbers("ball"), PackedFloat64Array([40, -96, 20, -48, 60]))


func test_a_wall_is_the_floor_with_x_and_y_swapped() -> void:
	await click_button("Wall instead of floor")
	assert_eq(numbers("ball"), PackedFloat64Array([4, 0, 48, 20, 60]))
	assert_reads("wall − x = ")
	for row: int in [1, 2, 3]:
		assert_eq(readout_text(row, 2), "0")
	await click_button("Wall instead of floor")
	assert_eq(numbers("ball"), PackedFloat64Array([0, 4, 20, 48, 60]))


func test_undo_and_reset_bring_all_back() -> void:
	await click_button("30°")
	await drag(Vec2.new(-30, 4), Vec2.new(-50, -16))
	await student.press(&"lab_undo")
	assert_eq(numbers("ball"), PackedFloat64Array([0, 4, 20, 48, 60]))
	assert_eq(_tilt(), 30.0)
	await click_button("One frame on")
	await student.press(&"lab_reset")
	assert_eq(_tilt(), 0.0)
	assert_has(formula_lines(), "r = 60     tilt = 0°     frame 0")


func test_a_wrong_answer_is_named_and_the_right_one_taken() -> void:
	await student.click(frame().lesson.services[&"question"])
	var prompt := frame().lesson.services[&"question"].get_node("%Prompt") as Label
	var found := RegEx.create_from_string("y = (\\d+), radius (\\d+)").search(prompt.text)
	var floor_y := found.get_string(1).to_float()
	var radius := found.get_string(2).to_float()
	await student.enter(field("y ="), str(floor_y + radius))
	assert_reads("y points down: above the floor is floor − r.")
	await student.enter(field("y ="), str(floor_y - radius))
	assert_reads("Right:")
	await click_button("Show on board")
	assert_eq(numbers("pivot"), PackedFloat64Array([0, floor_y]))


func _tilt() -> float:
	var degrees: float = frame().lesson.state()["tilt_degrees"]
	return degrees


# The titles of the rows that are seen below the headings.
func _rows() -> Array[String]:
	var titles: Array[String] = []
	var readout := frame().lesson.services[&"readout"] as Readout
	for row: int in range(1, readout.row_count()):
		var title := readout.cell(row, 0)
		if readout.is_visible_in_tree() and title.visible:
			titles.append(title.text)
	return titles


func _is_on_its_way() -> bool:
	var ball := numbers("ball")
	var share := (4.0 - ball[1]) / 48.0
	return share >= 0.0 and share < 0.5 and absf(ball[0] + 20.0 * share) < 0.02


func _ball_shown() -> PackedFloat64Array:
	var ball: PackedFloat64Array = []
	for title: String in ["x of the ball", "y of the ball", "x of v", "y of v"]:
		ball.append(field(title).text.to_float())
	ball.append(60.0)
	return ball


# The sentence, the card, and the formula below the line that names the frame.
func _said() -> PackedStringArray:
	var said := formula_lines().slice(2)
	said.append((frame().lesson.get_node("%Verdict/%Words") as Label).text)
	said.append((frame().lesson.services[&"steps"].get_node("%Sentence") as Label).text)
	return said
