extends LessonTest
## Drives the lesson on leading a target: dragging, typing, what is asked, the flight of the shot,
## the bug gallery.


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"lead_target"))


func after_each() -> void:
	Engine.time_scale = 1.0
	await super()


func test_it_starts_with_a_shot_that_misses_by_123() -> void:
	assert_eq(_labels("WrongMiss"), "123 px")
	assert_reads("A shot at where the target is now misses it.")
	assert_eq(formula_lines().size(), 3)


func test_the_steps_lead_to_the_direction_of_the_table() -> void:
	await go_to_step(LeadTargetModel.Step.TIME)
	assert_has(formula_lines(), "a = V · V − s² = 8100 − 22500 = −14400")
	assert_has(formula_lines(), "t = c / (√D − b) = 57600 / (28800 − 0) = 2")
	assert_has(formula_lines(), "t₂ = (√D − b) / a = (28800 − 0) / (−14400) = −2")
	assert_reads("it hits after t = 2 s")
	await go_to_step(LeadTargetModel.Step.AIM)
	assert_has(formula_lines(), "d = (P + V t) / |P + V t| = (0.8, 0.6)")


func test_whether_it_can_hit_is_asked_and_where() -> void:
	await student.press(&"lab_next_step")
	await student.press(&"lab_next_step")
	assert_reads("Can a bullet of this speed hit the target at all?")
	await click_button("there is one moment")
	assert_eq(frame().lesson.step, LeadTargetModel.Step.REACH)
	await student.press(&"lab_next_step")
	assert_reads("Where is the target when it is hit?")
	await drag(Vec2.new(120, -90), Vec2.new(120, 90))
	await student.press(&"lab_next_step")
	assert_reads("Exactly.")


func test_nothing_is_asked_where_nothing_hits() -> void:
	await click_button("Gets away")
	for i: int in 4:
		await student.press(&"lab_next_step")
	assert_eq(frame().lesson.step, LeadTargetModel.Step.TIME)
	assert_reads("the target is faster and gets away")
	assert_false((frame().lesson.get_node("%Reach") as CanvasItem).visible)


func test_target_velocities_speed_and_radius_can_be_dragged() -> void:
	await drag(Vec2.new(120, 0), Vec2.new(60, -30))
	_assert_numbers("velocity", [-60, 60])
	await drag(Vec2.new(120, -90), Vec2.new(150, -90))
	_assert_numbers("target", [150, -90])
	_assert_numbers("velocity", [-60, 60])
	# The head of u lies on the shooter, which stands still.
	await drag(Vec2.new(-120, -90), Vec2.new(-120, -50))
	_assert_numbers("own", [0, 40])
	await drag(Vec2.new(-120, -90), Vec2.new(-100, -90))
	_assert_numbers("shooter", [-100, -90])
	await go_to_step(LeadTargetModel.Step.REACH)
	var knob := (frame().lesson.get_node("%SpeedHandle") as Handle).at()
	await drag(knob, Vec2.new(-100, 0))
	assert_eq(_model().speed, 90.0)
	knob = (frame().lesson.get_node("%RadiusHandle") as Handle).at()
	await drag(knob, knob.plus(Vec2.new(30, 0)))
	assert_almost_eq(_model().radius, 30.0, 10.0)


func test_clicks_put_target_and_shooter() -> void:
	await student.click_at(place_of(Vec2.new(60, 70)))
	_assert_numbers("target", [60, 70])
	await student.click_at(place_of(Vec2.new(-60, 70)), MOUSE_BUTTON_RIGHT)
	_assert_numbers("shooter", [-60, 70])
	await click_button("Undo")
	_assert_numbers("shooter", [-120, -90])


func test_numbers_can_be_typed_and_wrong_ones_are_refused() -> void:
	await enter("speed of the bullet", "120")
	assert_eq(_model().speed, 120.0)
	await enter("speed of the bullet", "0")
	assert_reads("s must be within 0.001..1000000, not 0.")
	assert_eq(_model().speed, 120.0)
	await enter("x of the shooter's velocity", "-5")
	_assert_numbers("own", [-5, 0])


func test_the_right_shot_flies_and_stops_when_it_hits() -> void:
	await go_to_step(LeadTargetModel.Step.FIRE)
	await play_to_end()
	assert_eq(_model().time, 2.0)
	var bullet := (frame().lesson.get_node("%Bullet") as BallView).at()
	assert_vec2(bullet, Vec2.new(120, 90), 1e-12)
	assert_reads("miss 0 px; ε × condition 3.5e−13 px")
	await play_to_end()
	assert_eq(_model().time, 2.0, "Play begins anew")


func test_a_single_frame_goes_on_and_back() -> void:
	await go_to_step(LeadTargetModel.Step.REACH)
	await click_button("One frame on")
	await click_button("One frame on")
	assert_almost_eq((frame().lesson.get_node("%Reach") as ReachCircle).radius, 5.0, 1e-9)
	await click_button("One frame back")
	await click_button("One frame back")
	assert_eq(_model().time, 0.0)


func test_the_graph_leads_to_any_moment() -> void:
	await go_to_step(LeadTargetModel.Step.TIME)
	var graph := frame().lesson.get_node("%Graph") as LeadGraph
	var area := graph.get_global_rect().position
	await student.click_at(area + Vector2(graph.size.x * 0.75, 100.0))
	assert_between(_model().time, 0.8, 2.5)
	assert_eq(_model().to_dictionary().has("time"), false)


func test_each_mistake_shows_its_miss_and_can_be_undone() -> void:
	var wanted: PackedStringArray = ["123 px", "23.8 px", "200 px", "144 px", "144 px"]
	for i: int in wanted.size():
		await pick_mistake_at(i + 1)
		assert_eq(frame().lesson.step, LeadTargetModel.Step.FIRE)
		assert_reads("the mistake misses by " + wanted[i])
		assert_true((frame().lesson.get_node("%WrongWay") as CanvasItem).visible)
	await click_button("Undo")
	assert_eq(_model().mistake, LeadTargetMistakes.WITHOUT_OWN)


func test_a_question_names_the_mistake_and_shows_its_numbers() -> void:
	var question := frame().lesson.services[&"question"] as FoldableContainer
	question.folded = false
	await student.settle()
	await student.enter(Screen.named(question, "t =") as LineEdit, "1.6")
	assert_reads("That is |P| / s")
	await student.enter(Screen.named(question, "t =") as LineEdit, "2")
	assert_reads("Right: 2.")
	await click_button("Show on board")
	_assert_numbers("target", [120, 0])


func test_the_readout_compares_the_careful_formula_with_that_of_the_slide() -> void:
	await click_button("Nearly equal")
	await go_to_step(LeadTargetModel.Step.TIME)
	var readout := frame().lesson.services[&"readout"] as Readout
	assert_eq(readout.cell(1, 0).text, "t, careful")
	assert_lt(SeenLesson.first_number(readout.cell(1, 2).text), 1e-14)
	assert_gt(SeenLesson.first_number(readout.cell(2, 2).text), 1e-6)


func _model() -> LeadTargetModel:
	return frame().lesson.get(&"_model")


func _state() -> Dictionary:
	return frame().lesson.state()


func _labels(part: String) -> String:
	return frame().lesson.get_node("%" + part).get(&"label")


func _assert_numbers(key: String, wanted: Array[float]) -> void:
	var got: PackedFloat64Array = _state()[key]
	assert_eq(got, PackedFloat64Array(wanted), key)
