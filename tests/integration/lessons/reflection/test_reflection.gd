extends LessonTest
## Drives the lesson on reflection: steps, dragging, typing, the bug gallery, the flight of the
## ball.


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"reflection"))
	await go_to_step(ReflectionModel.Step.BOUNCE)


func after_each() -> void:
	Engine.time_scale = 1.0
	await super()


func test_it_starts_with_the_reflection_of_the_lecture() -> void:
	_assert_numbers("velocity", [3, 4])
	assert_has(formula_lines(), "v − (1 + C)(v · n̂) n̂ = (3, 4) − 2 (0, 4) = (3, −4)")
	assert_reads("in 36.87°, out 36.87° from n̂")


func test_every_step_shows_its_line_with_the_numbers_put_in() -> void:
	var wanted: Array[String] = [
		"v − (1 + C)(v · n̂) n̂ = (3, 4) − 2 (0, 4) = (3, −4)",
		"v − 2 (v · n̂) n̂ = (3, 4) − 2 (0, 4) = (3, −4)",
		"v − (v · n̂) n̂ = (3, 4) − (0, 4) = (3, 0)",
		"(v · n̂) n̂ = (−4) (0, −1) = (0, 4)",
	]
	for line: String in wanted:
		assert_eq(formula_lines()[-1], line)
		await student.press(&"lab_previous_step")
	assert_eq(formula_lines().size(), 2, "the first step subtracts nothing")


func test_the_steps_let_the_ball_fly_through_slide_and_bounce() -> void:
	_fly_to(1.0)
	assert_eq(_ball(), Vector2(3, -4))
	await student.press(&"lab_previous_step")
	await student.press(&"lab_previous_step")
	assert_eq(_ball(), Vector2(3, 0))
	await student.press(&"lab_previous_step")
	assert_eq(_ball(), Vector2(3, 4))


func test_play_flies_the_ball_and_stops_at_the_end() -> void:
	await click_button("Play or pause")
	var transport := frame().lesson.services[&"transport"] as Transport
	Engine.time_scale = 20.0
	for wait: int in 3000:
		if not transport.is_playing:
			break
		await get_tree().process_frame
	assert_eq(_model().time, ReflectionModel.END)


func test_a_step_back_takes_the_ball_back_to_where_it_was() -> void:
	for step: int in 3:
		await click_button("One frame on")
	for step: int in 3:
		await click_button("One frame back")
	assert_almost_eq(_model().time, ReflectionModel.START, 1e-12)


func test_a_drag_pauses_the_flight() -> void:
	await click_button("Play or pause")
	await drag(Vec2.new(3, 4), Vec2.new(5, 4))
	assert_false((frame().lesson.services[&"transport"] as Transport).is_playing)


func test_the_velocity_can_be_dragged_at_either_end() -> void:
	await drag(Vec2.new(3, 4), Vec2.new(5.1, 2.2))
	_assert_numbers("velocity", [5, 2])
	await drag(Vec2.new(-5, -2), Vec2.new(0.2, -4.8))
	_assert_numbers("velocity", [0, 5])


func test_the_line_can_be_turned_by_its_ends_and_by_its_normal() -> void:
	await drag(Vec2.new(-7, 0), Vec2.new(-6, -8))
	_assert_numbers("along", [-6, -8])
	await drag(Vec2.new(0.8, -0.6), Vec2.new(0, -1))
	assert_vec2(_model().unit_normal(), Vec2.new(0, -1), 1e-12)


func test_dragging_the_head_of_v_out_sets_c() -> void:
	await drag(Vec2.new(3, -4), Vec2.new(3, -2))
	_assert_number("bounciness", 0.5)
	assert_reads("keeps 52 % of its energy")
	await drag(Vec2.new(3, -2), Vec2.new(3, 3))
	_assert_number("bounciness", 0.0)


func test_arrow_keys_nudge_the_bounciness() -> void:
	Screen.named(screen(), "Head of v out: bounciness").grab_focus()
	await student.press(&"ui_down")
	_assert_number("bounciness", 0.75)


func test_numbers_can_be_typed() -> void:
	await enter("bounciness C, 0 to 1", "0.25")
	_assert_number("bounciness", 0.25)
	await enter("y of v", "8")
	_assert_numbers("velocity", [3, 8])
	await enter("y of the line", "7")
	_assert_numbers("along", [-7, 7])


func test_a_bounciness_outside_0_to_1_is_refused_and_named() -> void:
	for typed: String in ["1.5", "-0.5"]:
		await enter("bounciness C, 0 to 1", typed)
		_assert_number("bounciness", 1.0)
		var value := typed.replace("-", NumberText.MINUS)
		assert_reads("C must be within 0..1, but is %s." % value)


func test_a_line_without_direction_is_refused() -> void:
	await enter("x of the line", "0")
	_assert_numbers("along", [-7, 0])
	assert_reads("The line (0, 0) has no direction")


func test_a_normal_that_is_not_unit_is_refused_with_its_length() -> void:
	await click_button("Normal of length 1")
	assert_reads("Vec2.reflect: the normal must have length 1, but has length 2.0.")
	assert_eq(formula_lines()[-1], "|n| is not 1: refused. v stays (3, 4)")
	await enter("length of n", "0.5")
	assert_reads("but has length 0.5.")
	await click_button("Undo")
	assert_reads("but has length 2.0.")
	await click_button("Undo")
	assert_does_not_read("Vec2.reflect")


func test_godots_methods_stand_beside_with_their_errors() -> void:
	var table := frame().lesson.get_node("%Table") as Control
	for text: String in ["bounce(n̂)", "slide(n̂)", "−reflect(n̂, 1)", "(−3, 4)", "(3, 0)"]:
		assert_true(Screen.reads(table, text), text)
	await click_button("Angled")
	assert_true(Screen.reads(table, "e−7"), "the 32 bits show in the errors")


func test_each_mistake_shows_its_wrong_velocity_beside_the_right_one() -> void:
	var wrongs: Array[Vector2] = [Vector2(3, -28), Vector2(-3, 4), Vector2(1.5, -4)]
	for i: int in wrongs.size():
		await pick_mistake_at(i + 1)
		_assert_number("mistake", 11 + i)
		assert_eq(_model().velocity_with_mistake().to_vector2(), wrongs[i])
		assert_true((frame().lesson.get_node("%Wrong") as CanvasItem).visible)
		var wrong := NumberText.pair(wrongs[i].x, wrongs[i].y)
		assert_eq(formula_lines()[-1], "mistake: " + wrong)
		assert_reads("the mistake says: " + wrong)


func test_mistake_14_keeps_the_ball_at_the_line() -> void:
	await pick_mistake_at(4)
	assert_false(_wrong_ball().visible, "up to the line both balls are one")
	_fly_to(1.0)
	await student.press(&"lab_next_step")
	await click_button("One frame on")
	assert_true(_wrong_ball().visible)
	assert_reads("it sticks, jittering")


func test_mistake_13_takes_a_bounciness_that_shows_it_and_undo_brings_both_back() -> void:
	await pick_mistake_at(3)
	_assert_number("bounciness", 0.5)
	await click_button("Undo")
	_assert_number("bounciness", 1.0)
	_assert_number("mistake", 0)
	assert_false((frame().lesson.get_node("%Wrong") as CanvasItem).visible)


func test_reset_brings_the_lecture_back() -> void:
	await click_button("C = 0.5")
	await drag(Vec2.new(3, 4), Vec2.new(5, 2))
	await student.press(&"lab_reset")
	_assert_numbers("velocity", [3, 4])
	_assert_number("bounciness", 1.0)


func test_the_question_names_a_mistake_and_shows_its_numbers_on_the_board() -> void:
	var question := frame().lesson.services[&"question"] as FoldableContainer
	question.folded = false
	await student.settle()
	var prompt := (question.get_node("%Prompt") as Label).text.replace(NumberText.MINUS, "-")
	var pairs := RegEx.create_from_string("\\((-?\\d+), (-?\\d+)\\)").search_all(prompt)
	var velocity := Vec2.new(pairs[0].get_string(1).to_float(), pairs[0].get_string(2).to_float())
	await _answer(question, velocity.negated())
	assert_reads("All of v was turned")
	await student.click(question.get_node("%Show") as Control)
	assert_vec2(_model().velocity, velocity, 0.0)
	await _answer(question, _model().reflected())
	assert_reads("Right:")


func test_a_wrong_choice_is_answered_in_a_whole_sentence() -> void:
	await go_to_step(ReflectionModel.Step.SPLIT)
	await student.press(&"lab_next_step")
	await click_button("it flies through")
	assert_reads("No, it slides along the line")


func test_the_reflection_is_asked_for_before_it_is_shown() -> void:
	await go_to_step(ReflectionModel.Step.SPLIT)
	await student.press(&"lab_next_step")
	await click_button("it slides along the line")
	assert_reads("Right")
	await student.press(&"lab_next_step")
	assert_true(_is_drawn("%Guess"))
	assert_false(_is_drawn("%Leaving"))
	await drag(Vec2.new(3, 0), Vec2.new(3, -4))
	await student.press(&"lab_next_step")
	assert_reads("Exactly.")
	assert_true(_is_drawn("%Leaving"))


func test_the_shot_is_played_once_on_opening_and_then_the_first_step_waits() -> void:
	screen().free()
	OpeningMotion.is_allowed = true
	await open_lesson(LessonIndex.find(&"reflection"))
	OpeningMotion.is_allowed = false
	var play := Callable(frame().lesson, &"_play_shot")
	for seconds: float in [0.0, 0.6, 1.2, 1.8, 2.7, 2.9, 10.0]:
		play.call(seconds)
		var time := _model().time
		var is_over := seconds > ReflectionModel.END - ReflectionModel.START
		assert_almost_eq(time, ReflectionModel.START + (0.0 if is_over else seconds), 1e-12)
		var wanted := Vector2(3, 4 if time < 0.0 else -4) * time
		assert_almost_eq(_ball(), wanted, Vector2(1e-6, 1e-6), "after %s s" % seconds)
	await get_tree().process_frame
	var started := _model().time
	await get_tree().process_frame
	assert_gt(_model().time, started, "it moves by itself")
	await student.press(&"lab_hide_answers")
	var stopped := _model().time
	await get_tree().process_frame
	assert_eq(_model().time, stopped, "until something is pressed")
	assert_eq(_step(), ReflectionModel.Step.MEET)


func test_a_ball_head_on_is_said_to_stop_and_nothing_is_asked() -> void:
	await click_button("Head-on")
	await go_to_step(ReflectionModel.Step.SPLIT)
	await student.press(&"lab_next_step")
	assert_reads("nothing is left of v. The ball stops.")
	assert_reads("and it stops")
	assert_false(_is_drawn("%Slide"))


func test_a_mistake_that_changes_nothing_here_is_not_said_to_be_wrong() -> void:
	await pick_mistake_at(3)
	await enter("bounciness C, 0 to 1", "1")
	assert_reads("the mistake changes nothing here")
	assert_false(_is_drawn("%Wrong"))
	await enter("bounciness C, 0 to 1", "0.25")
	assert_reads("the mistake says: (0.75, −4)")
	assert_true(_is_drawn("%Wrong"))


func test_a_ball_at_rest_makes_no_angle() -> void:
	await enter("x of v", "0")
	await enter("y of v", "0")
	assert_reads("v = 0: the ball does not move")
	assert_false(_is_drawn("%AngleIn"))


func test_in_the_next_frame_the_ball_moves_away_and_is_left_alone() -> void:
	await student.press(&"lab_next_step")
	assert_reads("Reflect only if v · n̂ < 0: now it is above 0, v stays")
	assert_eq(formula_lines()[-1], "(3, −4) · n̂ = 3·0 + (−4)·(−1) = 4")
	await enter("y of v", "-4")
	assert_reads("−n̂ being on its side")
	assert_eq(formula_lines()[-1], "(3, 4) · (−n̂) = 3·0 + 4·1 = 4")
	await enter("bounciness C, 0 to 1", "0")
	assert_reads("now it is 0, v stays")


func test_v_out_has_its_name_beside_it_where_its_head_is_crowded() -> void:
	var leaving := frame().lesson.get_node("%Leaving") as Arrow
	assert_eq(leaving.label_place, Arrow.LabelPlace.HEAD)
	for preset: String in ["Along", "Head-on"]:
		await click_button(preset)
		assert_eq(leaving.label_place, Arrow.LabelPlace.MIDDLE, preset)
	await click_button("Along")
	assert_false(_is_drawn("%Slide"), "it would lie on v out")


func test_table_and_card_give_way_to_a_ball_from_any_side() -> void:
	var handle := frame().lesson.get_node("%ComingTail") as Control
	for coming: Vector2i in [Vector2i(3, 4), Vector2i(3, -4), Vector2i(-3, -4), Vector2i(-3, 4)]:
		await enter("x of v", str(coming.x))
		await enter("y of v", str(coming.y))
		for card: String in ["%Table", "%Verdict"]:
			var area := (frame().lesson.get_node(card) as Control).get_global_rect()
			var middle := handle.get_global_rect().get_center()
			assert_false(area.grow(10.0).has_point(middle), "%s for %s" % [card, coming])
		var table := frame().lesson.get_node("%Table") as Control
		var verdict := frame().lesson.get_node("%Verdict") as Control
		assert_false(table.get_global_rect().intersects(verdict.get_global_rect()))


func test_mistake_13_gives_the_bounciness_back() -> void:
	await pick_mistake_at(3)
	await pick_mistake_at(0)
	_assert_number("bounciness", 1.0)


func _answer(question: FoldableContainer, answer: Vec2) -> void:
	await student.enter(Screen.named(question, "x =") as LineEdit, "%.3f" % answer.x)
	await student.enter(Screen.named(question, "y =") as LineEdit, "%.3f" % answer.y)


func _model() -> ReflectionModel:
	return frame().lesson.get("_model")


func _fly_to(time: float) -> void:
	_model().time = time


func test_an_arrow_that_says_nothing_is_not_drawn() -> void:
	await click_button("Head-on")
	assert_false(_is_drawn("%Mirror"), "C = 1 would lie on v out")
	await click_button("C = 0.5")
	assert_true(_is_drawn("%Mirror"))
	await click_button("Along")
	assert_false(_is_drawn("%First"), "nothing is subtracted")


func _is_drawn(part: String) -> bool:
	return (frame().lesson.get_node(part) as CanvasItem).visible


# Where the ball is, less its radius along the normal, rounded to what the eye sees.
func _ball() -> Vector2:
	return (
		_model()
		. ball_centre(0.0, _model().velocity_after(_model().times_subtracted(_step())))
		. to_vector2()
	)


func _step() -> ReflectionModel.Step:
	return (frame().lesson.services[&"steps"] as Steps).step as ReflectionModel.Step


func _wrong_ball() -> CanvasItem:
	return frame().lesson.get_node("%WrongBall") as CanvasItem


func _assert_numbers(key: String, wanted: PackedFloat64Array) -> void:
	var got: PackedFloat64Array = frame().lesson.state()[key]
	assert_eq(got, wanted, key)


func _assert_number(key: String, wanted: float) -> void:
	var got: float = frame().lesson.state()[key]
	assert_eq(got, wanted, key)
