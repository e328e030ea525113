extends LessonTest
## Drives the lesson on sliding and rolling: dragging, typing, what is asked, the race, Godot's
## body, the bug gallery.


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"slide_and_roll"))


func after_each() -> void:
	Engine.time_scale = 1.0
	await super()


func test_it_starts_with_a_ball_that_slides_without_turning() -> void:
	assert_reads("Without friction the ball slides down and does not turn.")
	await play_to_end()
	assert_almost_eq(_model().time, 0.8165, 1e-4)
	var ball := frame().lesson.get_node("%Ball") as TurnedBall
	assert_vec2(ball.at(), Vec2.new(54, 28), 1e-9)
	assert_eq(ball.turn, 0.0)


func test_the_steps_lead_to_the_numbers_of_the_table() -> void:
	await go_to_step(SlideAndRollModel.Step.PULL)
	assert_has(formula_lines(), "G = g h / L = 600·72 / 120 = 360")
	assert_has(formula_lines(), "N = g w / L = 600·96 / 120 = 480")
	await go_to_step(SlideAndRollModel.Step.MARK)
	assert_has(formula_lines(), "tan = h / w = 72 / 96 = 0.75   tan / 3 = 0.25")
	assert_has(formula_lines(), "3 µ N = 576 ≥ 360 = G")
	await go_to_step(SlideAndRollModel.Step.ROLL)
	assert_has(formula_lines(), "a = G − f = 360 − 120 = 240")
	await go_to_step(SlideAndRollModel.Step.RACE)
	assert_has(formula_lines(), "t = √(2 L / a) = √(2·120 / 240) = 1")
	assert_has(formula_lines(), "without friction: t₀ = √(2 L / G) = 0.8165")


func test_the_mark_and_the_place_in_the_race_are_asked() -> void:
	for i: int in 3:
		await student.press(&"lab_next_step")
	assert_reads("From which µ on can the ball roll on this slope?")
	# In a small window it lies in the panel, without its name.
	var curve := frame().lesson.get_node("%Card").get_child(0) as FrictionCurve
	assert_false(curve.is_visible_in_tree(), "the mark, while it is asked for")
	await click_button("from µ = tan / 3 on")
	assert_eq(frame().lesson.step, SlideAndRollModel.Step.MARK)
	assert_true(curve.visible)
	await student.press(&"lab_next_step")
	await student.press(&"lab_next_step")
	assert_reads("Where is your ball when the one without friction is at the end?")
	# At two thirds of the line.
	await drag(Vec2.new(-42, -44), _model().center_at(80.0))
	await student.press(&"lab_next_step")
	assert_eq(frame().lesson.step, SlideAndRollModel.Step.RACE)
	assert_reads("Your guess was")


func test_nothing_is_asked_where_nothing_moves() -> void:
	await enter("y of the end", "-36")
	for i: int in 5:
		await student.press(&"lab_next_step")
	assert_eq(frame().lesson.step, SlideAndRollModel.Step.RACE)
	assert_reads("nothing moves")
	await play_to_end()


func test_line_and_speed_can_be_dragged() -> void:
	await drag(Vec2.new(48, 36), Vec2.new(60, 20))
	assert_numbers("end", [60, 20])
	await drag(Vec2.new(60, 20), Vec2.new(60, -80))
	assert_numbers("end", [60, -36])
	await drag(Vec2.new(-48, -36), Vec2.new(-80, -60))
	assert_numbers("start", [-80, -60])
	var knob := (frame().lesson.get_node("%SpeedHandle") as Handle).at()
	var along := _model().segment().along().normalized()
	await drag(knob, knob.plus(along.scaled(20.0)))
	assert_almost_eq(_model().speed, 100.0, 20.0)
	await click_button("Undo")
	assert_eq(_model().speed, 0.0)


func test_friction_can_be_dragged_across_the_mark() -> void:
	await go_to_step(SlideAndRollModel.Step.ROLL)
	assert_reads("It rolls. A third of G turns the ball")
	await _point_at_friction(0.1)
	assert_between(_model().friction, 0.085, 0.115)
	assert_reads("Friction is too weak")
	await click_button("Undo")
	assert_eq(_model().friction, 0.4)


func test_numbers_can_be_typed_and_wrong_ones_are_refused() -> void:
	await enter("gravity", "300")
	assert_eq(_model().gravity, 300.0)
	await enter("gravity", "0")
	assert_reads("g must be within 0.001..1000000, not 0.")
	await go_to_step(SlideAndRollModel.Step.SLIP)
	await enter("friction", "0,2")
	assert_eq(_model().friction, 0.2)


func test_the_race_is_won_without_friction() -> void:
	await go_to_step(SlideAndRollModel.Step.RACE)
	for i: int in 30:
		await click_button("One frame on")
	var ways: PackedFloat64Array = []
	for ball: String in ["SlideBall", "Ball", "RollBall"]:
		ways.append(_way(ball))
	assert_almost_eq(ways[0], 45.0, 1e-9)
	assert_almost_eq(ways[1], 30.0, 1e-9)
	assert_almost_eq(ways[2], 30.0, 1e-9)
	assert_eq((frame().lesson.get_node("%SlideBall") as TurnedBall).turn, 0.0)
	assert_almost_eq((frame().lesson.get_node("%Ball") as TurnedBall).turn, 3.0, 1e-12)
	for i: int in 30:
		await click_button("One frame back")
	assert_almost_eq(_model().time, 0.0, 1e-15)


func test_on_the_level_it_rolls_with_two_thirds_of_its_speed() -> void:
	await click_button("Level")
	await go_to_step(SlideAndRollModel.Step.ROLL)
	assert_has(formula_lines(), "t₁ = v₀ / (3 µ N − G) = 300 / (360 − 0) = 0.8333")
	assert_has(formula_lines(), "v₁ = v₀ + (G − µ N) t₁ = 200")
	assert_reads("it rolls after 0.8333 s")


func test_each_mistake_shows_its_number_and_can_be_undone() -> void:
	var wanted: PackedStringArray = ["36 px behind", "8.57 px ahead", "stops", "60 px ahead"]
	for i: int in wanted.size():
		await pick_mistake_at(i + 1)
		assert_eq(frame().lesson.step, SlideAndRollModel.Step.RACE)
		if i != 2:
			assert_reads("the mistake: " + wanted[i])
		assert_true((frame().lesson.get_node("%WrongBall") as CanvasItem).visible)
	await click_button("Undo")
	assert_eq(_model().mistake, SlideAndRollMistakes.STOPS)
	await click_button("Level")
	assert_reads("the mistake: it stops after 2.5 s")


func test_a_question_names_the_mistake_and_shows_its_numbers() -> void:
	var question := frame().lesson.services[&"question"] as FoldableContainer
	question.folded = false
	await student.settle()
	await student.enter(Screen.named(question, "µ =") as LineEdit, "0.75")
	assert_reads("That is tan")
	await student.enter(Screen.named(question, "µ =") as LineEdit, "1/4")
	assert_reads("Right: 0.25.")
	await click_button("Show on board")
	assert_numbers("end", [48, 36])


func test_the_readout_compares_the_formula_with_frames_and_with_godot() -> void:
	await click_button("Pushed")
	await go_to_step(SlideAndRollModel.Step.ERROR)
	var readout := frame().lesson.services[&"readout"] as Readout
	assert_eq(readout.cell(1, 0).text, "t, by the formula")
	assert_lt(SeenLesson.first_number(readout.cell(1, 2).text), 1e-14)
	assert_gt(SeenLesson.first_number(readout.cell(2, 2).text), 1e-5)
	assert_eq(readout.cell(3, 0).text, "slip at the end, in frames")
	assert_gt(SeenLesson.first_number(readout.cell(3, 2).text), 0.1)
	assert_false(readout.cell(4, 0).visible)
	await click_button("Godot")
	assert_true(_model().has_engine)
	for frame_number: int in 200:
		await get_tree().physics_frame
	assert_eq(readout.cell(4, 0).text, "t, Godot's RigidBody2D")
	assert_almost_eq(SeenLesson.first_number(readout.cell(4, 1).text), 0.767, 0.02)
	assert_gt(SeenLesson.first_number(readout.cell(4, 2).text), 1e-5)
	for i: int in 20:
		await click_button("One frame on")
	assert_lt((frame().lesson.get_node("%Engine") as EngineRunner).gap(), 5.0)
	assert_gt((frame().lesson.get_node("%Engine") as EngineRunner).gap(), 0.0)
	await click_button("Godot")
	assert_false(readout.cell(4, 0).visible)
	assert_null((frame().lesson.get_node("%Engine") as EngineRunner).roll)


func _model() -> SlideAndRollModel:
	return frame().lesson.get(&"_model")


# How far a ball has come from where it started.
func _way(ball: String) -> float:
	var lane := (frame().lesson.get_node("%" + ball) as TurnedBall).at()
	var along := _model().segment().along()
	return lane.minus(_model().center_at(0.0)).scalar_projection(along)


func _point_at_friction(friction: float) -> void:
	var card := frame().lesson.get_node("%Card") as FrictionCard
	var at := card.get_global_rect().position
	await student.click_at(at + Vector2(card.pixel_of(friction), card.size.y / 2.0))
