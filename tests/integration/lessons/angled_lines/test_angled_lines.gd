extends LessonTest
## Drives the lesson on angled lines: keys of the course, drawing, moving and deleting lines,
## dragging the ball, steps back, presets, mistakes, undo and reset.


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"angled_lines"))


func test_it_starts_at_the_first_step_without_an_answer() -> void:
	assert_reads("Step 1 of 3")
	assert_reads("Drag on the board to draw a line")
	assert_eq(formula_lines().size(), 2)
	assert_eq(_shown_now(), [false, false] as Array[bool])
	assert_false(_readout().visible)
	assert_eq(_world().frames, 0)


func test_the_second_step_asks_for_the_touch_and_then_shows_it() -> void:
	await student.press(&"lab_next_step")
	assert_reads("at its next touch?")
	assert_eq(_shown_now(), [false, false] as Array[bool])
	var guess := frame().lesson.get_node("%Guess") as Guess
	await drag(guess.at(), Vec2.new(20, 150))
	await student.press(&"lab_next_step")
	var truth := _model().forecast(_world()).next_bounce.position
	assert_reads("Your guess was %s off." % NumberText.size(truth.distance_to(Vec2.new(20, 150))))
	assert_eq(_shown_now(), [true, true] as Array[bool])
	assert_string_contains(formula_lines()[2], "v₂ = v₁ − (1 + C) (v₁ · n̂) n̂")
	assert_string_contains(
		formula_lines()[3], "− 2 · (−402.5) (0.03829, −0.9993) = (190.8, −395.5)"
	)


func test_a_ball_that_touches_nothing_is_not_asked_for() -> void:
	await student.press(&"lab_gravity_none")
	assert_no_refusal(_model().set_lines([] as Array[LineSegment]))
	await student.press(&"lab_next_step")
	assert_eq(frame().lesson.step, 1)
	assert_reads("no bounce")


func test_the_second_step_speaks_only_of_what_is_shown() -> void:
	_steps().go_to(1)
	await student.settle()
	assert_reads("At the ring the ball touches a line")
	await student.press(&"lab_pause")
	await student.settle()
	assert_reads("It has not bounced yet.")
	while not _model().last_bounce:
		await get_tree().process_frame
	await student.settle()
	assert_reads("At its last bounce v₁ turned into v₂.")
	await student.press(&"lab_pause")
	await student.settle()
	assert_reads("At the ring the ball touches a line")


func test_the_third_step_asks_which_way_gains_energy_and_then_compares() -> void:
	_steps().go_to(1)
	await student.press(&"lab_next_step")
	assert_reads("higher and higher?")
	assert_false(_readout().visible)
	await click_button("rest dropped")
	assert_reads("No, position reset")
	assert_true(_readout().visible)
	assert_eq(formula_lines().size(), 2)


func test_it_opens_flying_until_somebody_acts_and_undo_leads_to_the_start() -> void:
	screen().free()
	OpeningMotion.is_allowed = true
	await open_lesson(LessonIndex.find(&"angled_lines"))
	OpeningMotion.is_allowed = false
	var first: PackedFloat64Array = frame().lesson.state()["first"]
	for i: int in 30:
		await get_tree().process_frame
	assert_gt(_world().frames, 10)
	assert_gt((frame().lesson.get_node("%Trails") as BallTrails).places_of(0).size(), 10)
	await student.press(&"lab_gravity_left")
	var frames := _world().frames
	var shown := formula_lines()[1]
	for i: int in 10:
		await get_tree().process_frame
	assert_eq(_world().frames, frames)
	assert_eq(formula_lines()[1], shown)
	var x := NumberText.short(_ball().position.x).replace(NumberText.MINUS, "-")
	assert_string_contains(shown, "P = ( %s" % x)
	await student.press(&"lab_undo")
	assert_vec2(_gravity(), Vec2.new(0, 300), 0.0)
	assert_eq(_world().frames, 0)
	assert_vec2(_ball().position, Vec2.new(first[0], first[1]), 0.0)


func test_the_scene_starts_with_the_assignment_of_the_course() -> void:
	assert_eq(WorldState.of(_world()), WorldState.of(AngledLinesPresets.world_of(0)))


func test_the_start_is_read_from_the_scene() -> void:
	var drawing := frame().lesson.get_node("%Drawing") as AngledLinesDrawing
	(frame().lesson.get_node("%Lines") as LineViews).ends = [Vector2(-50, 90), Vector2(50, 80)]
	var balls := frame().lesson.get_node("%Balls") as BallsView
	balls.centers = [Vector2(10, -20), Vector2(40, -20)]
	balls.velocities = [Vector2(3, 4), Vector2(0, 0.5)]
	balls.radius = 7.5
	(frame().lesson.get_node("%Gravity") as GravityArrow).gravity = Vector2(-20, 0)
	var world := drawing.world_at_start(0.25)
	assert_eq(world.surroundings.segments.size(), 1)
	assert_vec2(world.surroundings.segments[0].end, Vec2.new(50, 80), 0.0)
	assert_vec2(world.surroundings.gravity, Vec2.new(-20, 0), 0.0)
	assert_eq(world.surroundings.bounciness, 0.25)
	assert_eq(world.balls.size(), 2)
	assert_eq(world.balls[1].radius, 7.5)
	assert_vec2(world.balls[0].velocity, Vec2.new(3, 4), 0.0)


func test_a_start_that_cannot_be_is_an_error() -> void:
	var drawing := frame().lesson.get_node("%Drawing") as AngledLinesDrawing
	(frame().lesson.get_node("%Lines") as LineViews).ends = [Vector2(-50, 90)]
	(frame().lesson.get_node("%Balls") as BallsView).centers = [Vector2(900, 0), Vector2(0, 0)]
	drawing.world_at_start(1.5)
	assert_push_error("there cannot be 1 ends")
	assert_push_error("2 balls cannot have 1 velocities")
	assert_push_error("within -800..800 px")
	assert_push_error("within 0..1, not 1.5")


func test_a_drag_on_the_empty_board_draws_a_line_and_undo_takes_it_away() -> void:
	await drag(Vec2.new(-180, 30), Vec2.new(-120, 50))
	assert_eq(_lines().size(), 11)
	assert_vec2(_lines()[10].start, Vec2.new(-180, 30), 0.0)
	assert_vec2(_lines()[10].end, Vec2.new(-120, 50), 0.0)
	await student.press(&"lab_undo")
	assert_eq(_lines().size(), 10)


func test_a_mere_click_on_the_board_draws_nothing() -> void:
	await student.click_at(place(-180, 40))
	assert_eq(_lines().size(), 10)


func test_a_line_is_moved_by_its_body_and_by_an_end() -> void:
	await drag(Vec2.new(120, 20), Vec2.new(120, 40))
	assert_vec2(_lines()[5].start, Vec2.new(60, 70), 0.0)
	assert_vec2(_lines()[5].end, Vec2.new(180, 10), 0.0)
	await drag(Vec2.new(180, 10), Vec2.new(200, 30))
	assert_vec2(_lines()[5].end, Vec2.new(200, 30), 0.0)
	assert_vec2(_lines()[5].start, Vec2.new(60, 70), 0.0)


func test_a_line_drawn_to_length_zero_is_refused_and_stays() -> void:
	await drag(Vec2.new(180, -10), Vec2.new(60, 50))
	assert_reads("A segment must be longer than 0")
	assert_gt(_lines()[5].length(), 0.0)


func test_delete_takes_the_line_with_the_focus() -> void:
	await student.click_at(place(120, 20))
	await student.press(&"lab_delete_line")
	assert_eq(_lines().size(), 9)
	await student.press(&"lab_delete_line")
	assert_eq(_lines().size(), 9, "none has the focus now")


func test_the_button_beside_a_line_deletes_it() -> void:
	await student.click_at(place(120, 20))
	await click_button("Delete this line: Delete")
	assert_eq(_lines().size(), 9)
	assert_false((frame().lesson.get_node("%Lines/Delete") as Button).visible)


func test_the_ball_can_be_dragged_and_its_velocity_too() -> void:
	await drag(Vec2.new(-200, -120), Vec2.new(-150, -130))
	assert_vec2(_ball().position, Vec2.new(-150, -130), 0.0)
	assert_vec2(_ball().velocity, Vec2.new(160, 0), 0.0)
	await drag(Vec2.new(-110, -130), Vec2.new(-100, -110))
	assert_vec2(_ball().velocity, Vec2.new(200, 80), 1e-9)


func test_any_of_ten_balls_can_be_taken() -> void:
	await student.press(&"lab_preset_7")
	var at := _world().balls[6].position
	await drag(at, at.plus(Vec2.new(30, 0)))
	assert_eq(_model().selected, 6)
	assert_almost_eq(_world().balls[6].position.x, at.x + 30.0, 10.0)


func test_arrow_keys_turn_gravity_and_backspace_takes_it_away() -> void:
	await student.press(&"lab_gravity_left")
	assert_vec2(_gravity(), Vec2.new(-300, 0), 1e-9)
	await student.press(&"lab_gravity_up")
	assert_vec2(_gravity(), Vec2.new(0, -300), 1e-9)
	await student.press(&"lab_gravity_none")
	assert_vec2(_gravity(), Vec2.new(), 0.0)


func test_arrow_keys_nudge_a_handle_that_has_the_focus_instead() -> void:
	await student.click_at(place(120, 20))
	await student.press(&"ui_right")
	assert_vec2(_gravity(), Vec2.new(0, 300), 0.0)
	assert_vec2(_lines()[5].start, Vec2.new(70, 50), 0.0)


func test_the_arrow_of_gravity_can_be_dragged() -> void:
	var head := Screen.named(screen(), "Head of gravity g")
	var middle := head.get_global_rect().get_center()
	await student.drag(middle, middle + Vector2(20.0 * frame().lesson.board.pixels_per_unit, 0.0))
	assert_vec2(_gravity(), Vec2.new(200, 300), 1e-6)


func test_gravity_to_the_left_stays_on_the_board() -> void:
	await student.press(&"lab_gravity_left")
	var head := Screen.named(screen(), "Head of gravity g") as Handle
	var dot := Rect2(head.get_global_rect().get_center(), Vector2.ZERO).grow(head.dot_radius)
	assert_true(frame().lesson.get_global_rect().encloses(dot.grow(8.0)))


func test_b_goes_through_the_bouncinesses_and_c_can_be_typed() -> void:
	await student.press(&"lab_next_bounciness")
	assert_eq(_world().surroundings.bounciness, 0.8)
	await student.enter(field("bounciness C"), "0.25")
	assert_eq(_world().surroundings.bounciness, 0.25)
	await student.enter(field("bounciness C"), "2")
	assert_reads("The bounciness C must be within 0..1, not 2.")
	assert_eq(_world().surroundings.bounciness, 0.25)


func test_s_steps_and_shift_s_steps_back_to_the_same_bits() -> void:
	var first := _world().state()
	for i: int in 5:
		await student.press(&"lab_next_frame")
	assert_eq(_world().frames, 5)
	for i: int in 5:
		await student.press(&"lab_previous_frame")
	assert_eq(_world().state(), first)


func test_play_runs_and_the_step_buttons_pause() -> void:
	await student.press(&"lab_pause")
	for i: int in 20:
		await get_tree().process_frame
	assert_gt(_world().frames, 0)
	await click_button("One frame back")
	var frames := _world().frames
	await student.settle()
	assert_eq(_world().frames, frames)


func test_a_scene_is_picked_from_its_list() -> void:
	var list := Screen.named(screen(), "The scene to which R goes back") as OptionButton
	assert_eq(list.get_item_text(3), "3  Ramps")
	list.item_selected.emit(6)
	assert_eq(_model().preset, 6)
	await student.press(&"lab_preset_4")
	assert_eq(list.selected, 4)


func test_space_after_a_click_on_a_switch_is_slow_motion() -> void:
	await student.press(&"lab_preset_6")
	await click_button("Trails")
	await student.press(&"lab_slow")
	var slow := frame().lesson.services[&"transport"].get_node("%Slow") as Button
	assert_true(slow.button_pressed)
	assert_eq(_model().preset, 6)


func test_every_digit_picks_its_preset() -> void:
	for preset: int in 10:
		await student.press(StringName("lab_preset_%d" % preset))
		assert_eq(_model().preset, preset)


func test_reset_goes_back_to_the_start_of_the_preset_picked() -> void:
	await student.press(&"lab_preset_6")
	var first := _world().state()
	await student.press(&"lab_next_frame")
	await drag(Vec2.new(-180, 80), Vec2.new(-120, 100))
	await student.press(&"lab_reset")
	assert_eq(_world().state(), first)
	assert_eq(_lines().size(), 5)


func test_d_hides_trails_and_c_clears_them() -> void:
	var trails := frame().lesson.get_node("%Trails") as BallTrails
	for i: int in 3:
		await student.press(&"lab_next_frame")
	assert_eq(trails.places_of(0).size(), 4)
	await student.press(&"lab_previous_frame")
	assert_eq(trails.places_of(0).size(), 3)
	await student.press(&"lab_clear_trails")
	assert_eq(trails.places_of(0).size(), 1)
	await student.press(&"lab_toggle_trails")
	assert_false(trails.visible)


func test_trails_of_many_balls_end_at_the_balls_forward_and_back() -> void:
	var trails := frame().lesson.get_node("%Trails") as BallTrails
	await student.press(&"lab_preset_8")
	var past: Array[PackedVector2Array] = []
	for i: int in 12:
		past.append(_all_places(trails))
		await student.press(&"lab_next_frame")
		_assert_trails_end_at_the_balls(trails)
	# A stroke for two frames, and one more at a bounce.
	var strokes := _all_places(trails).size() - past[0].size()
	assert_between(strokes, 6 * 50, 6 * 50 + 2 * _world().bounces)
	for i: int in 12:
		await student.press(&"lab_previous_frame")
		assert_true(_all_places(trails) == past[11 - i], "trails %d steps back" % (i + 1))


func test_trails_of_a_mistake_begin_with_it() -> void:
	await student.press(&"lab_preset_9")
	await pick_mistake("Mistake 26")
	for i: int in 3:
		await student.press(&"lab_next_frame")
	var wrong := frame().lesson.get_node("%WrongTrails") as BallTrails
	assert_eq(wrong.places_of(0).size(), 4)


func test_a_lost_ball_is_counted_and_fetched() -> void:
	await student.press(&"lab_preset_5")
	_choose_method(SteppingMethods.Method.POSITION_RESET)
	for i: int in 20:
		await student.press(&"lab_next_frame")
	assert_reads("lost 1")
	assert_reads("E / E₀ = –")
	await click_button("F  Bring lost balls back")
	assert_eq(_world().lost_count(), 0)
	assert_reads("lost 1")
	assert_reads("E / E₀ = 1")
	assert_does_not_read("Bring lost balls back")


func test_each_way_of_stepping_can_be_chosen_and_undone() -> void:
	_choose_method(SteppingMethods.Method.POINT_OF_IMPACT)
	await student.settle()
	assert_true(_world().mover is PointOfImpactMover)
	await student.press(&"lab_undo")
	assert_true(_world().mover is WholeFrameMover)


func test_each_mistake_runs_beside_the_right_way() -> void:
	for number: int in [14, 21, 24, 26]:
		await pick_mistake("Mistake %d" % number)
		assert_eq(_model().mistake, number)
		assert_not_null(_model().wrong_world)
		assert_does_not_read("test_")
		assert_reads("mistake: ")
	await pick_mistake("No mistake")
	assert_null(_model().wrong_world)


func test_the_comparison_fills_in_while_paused() -> void:
	for i: int in 600:
		if readout_text(0, 0) == "after 60 s":
			break
		await get_tree().process_frame
	assert_eq(readout_text(0, 0), "after 60 s")
	assert_eq(readout_text(3, 1), "1")
	assert_string_contains(readout_text(1, 1), "1.")
	assert_string_contains(readout_text(1, 1), "> 1")


func test_nothing_is_told_of_a_comparison_that_has_not_begun() -> void:
	await student.press(&"lab_pause")
	await student.press(&"lab_next_bounciness")
	assert_eq(readout_text(0, 0), "pause first")
	for row: int in range(1, 5):
		for column: int in range(1, 4):
			assert_eq(readout_text(row, column), "–")


func test_a_question_can_be_answered_and_shown_on_the_board() -> void:
	var question := frame().lesson.services[&"question"] as FoldableContainer
	question.folded = false
	await student.settle()
	await student.enter(field("x ="), "1")
	await student.enter(field("y ="), "2000")
	assert_reads("(1, 2000) is not it yet.")
	await click_button("Show on board")
	assert_eq(_lines().size(), 2, "line A and line B")
	var names: Array[String] = []
	for arrow in frame().lesson.get_node("%Lines").find_children("*", "Arrow", true, false):
		names.append((arrow as Arrow).label)
	assert_eq(names, ["A", "B"] as Array[String])
	assert_eq(_world().balls.size(), 1)


func test_help_names_the_keys_of_the_course() -> void:
	for text: String in ["S next frame", "←↑→↓ gravity", "0…9 scene"]:
		assert_reads(text.replace(" ", "\u00a0"))


func _model() -> AngledLinesModel:
	return frame().lesson.get(&"_model")


func _world() -> SteppedWorld:
	return _model().world


func _ball() -> Ball:
	return _model().ball()


func _lines() -> Array[LineSegment]:
	return _world().surroundings.segments


func _all_places(trails: BallTrails) -> PackedVector2Array:
	var places: PackedVector2Array = []
	for i in _world().balls.size():
		places.append_array(trails.places_of(i))
	return places


func _assert_trails_end_at_the_balls(trails: BallTrails) -> void:
	for i in _world().balls.size():
		var gap := trails.places_of(i)[-1].distance_to(_world().balls[i].position.to_vector2())
		if gap > 0.0:
			fail_test("The trail of ball %d ends %s px from it." % [i, gap])


func _gravity() -> Vec2:
	return _world().surroundings.gravity


func _steps() -> Steps:
	return frame().lesson.services[&"steps"] as Steps


func _readout() -> Readout:
	return frame().lesson.services[&"readout"] as Readout


func _shown_now() -> Array[bool]:
	return seen(["%Impact", "%Normal"])


func _choose_method(method: SteppingMethods.Method) -> void:
	frame().lesson.services[&"options"].emit_signal(&"chosen", "method", method)
