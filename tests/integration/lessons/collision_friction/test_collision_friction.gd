extends LessonTest
## Drives the lesson on friction at a bounce: dragging, typing, what is asked, the flight, the
## ledger, the bug gallery.


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"collision_friction"))


func after_each() -> void:
	Engine.time_scale = 1.0
	await super()


func test_it_starts_with_a_bounce_without_friction() -> void:
	assert_reads("Without friction a bounce changes neither the speed along the line nor the spin.")
	await play_to_end()
	var ball := _part("Ball") as TurnedBall
	assert_vec2(ball.at(), Vec2.new(90.0, -140.0), 1e-9)
	assert_eq(ball.turn, 0.0)


func test_the_steps_lead_to_the_numbers_of_the_table() -> void:
	await go_to_step(CollisionFrictionModel.Step.SLIP)
	assert_has(formula_lines(), "u = v · t − r ω = 300 − 20·0 = 300")
	await go_to_step(CollisionFrictionModel.Step.PUSH)
	assert_has(formula_lines(), "jn = −(1 + C) v · n = −(1 + 1)·(−400) = 800")
	await go_to_step(CollisionFrictionModel.Step.CONE)
	assert_has(formula_lines(), "|u| / 3 = 100 ≤ 200 = µ jn")
	assert_has(formula_lines(), "jt = −u / 3 = −100")
	assert_reads("the surfaces stick")
	assert_reads("one µ, for sticking and slipping")
	await go_to_step(CollisionFrictionModel.Step.AFTER)
	assert_has(formula_lines(), "v′ = v + J = (300, 400) + (−100, −800) = (200, −400)")
	assert_has(formula_lines(), "ω′ = ω − 2 jt / r = 0 − 2·(−100) / 20 = 10")
	await go_to_step(CollisionFrictionModel.Step.LEDGER)
	assert_has(formula_lines(), "L = r v · t + r² ω / 2 = 6000")
	assert_has(formula_lines(), "L′ = r v′ · t + r² ω′ / 2 = 6000")
	assert_reads("E: 15000 of 125000 is lost")
	await go_to_step(CollisionFrictionModel.Step.FLY)
	assert_has(formula_lines(), "P = c + T v′ = (0, −20) + 0.3·(200, −400) = (60, −140)")


func test_too_little_friction_slips() -> void:
	await click_button("Slips")
	await go_to_step(CollisionFrictionModel.Step.CONE)
	assert_has(formula_lines(), "|u| / 3 = 100 > 80 = µ jn")
	assert_has(formula_lines(), "jt = −µ jn = −80")
	assert_reads("the surfaces slip on")
	await go_to_step(CollisionFrictionModel.Step.AFTER)
	assert_reads("v′ = (220, −400), ω′ = 8")


func test_backspin_hops_straight_up() -> void:
	await click_button("Backspin")
	await go_to_step(CollisionFrictionModel.Step.AFTER)
	assert_reads("v′ = (0, −400), ω′ = 0")


func test_a_ball_throws_another_one() -> void:
	await click_button("Two balls")
	await go_to_step(CollisionFrictionModel.Step.AFTER)
	assert_has(formula_lines(), "v₂′ = −J / 2 = (175, 100)")
	assert_reads("v₂′ = (175, 100), ω₂′ = 2.5")
	await go_to_step(CollisionFrictionModel.Step.FLY)
	await play_to_end()
	assert_vec2((_part("Other") as TurnedBall).at(), Vec2.new(68.5, 42.0), 1e-9)
	assert_almost_eq((_part("Other") as TurnedBall).turn, 0.75, 1e-12)


func test_stick_or_slip_where_the_arrow_ends_and_what_is_kept_are_asked() -> void:
	for i: int in 3:
		await student.press(&"lab_next_step")
	assert_reads("Friction is at most µ jn. Can it end the slip?")
	assert_false((_part("Cone") as CanvasItem).is_visible_in_tree())
	await click_button("the surfaces slip on")
	assert_reads("No, the surfaces stick")
	await student.press(&"lab_next_step")
	assert_reads("Where does the arrow of v′ end, drawn from the ball?")
	await drag(Vec2.new(60, -100), Vec2.new(40, -100))
	await student.press(&"lab_next_step")
	assert_reads("Exactly.")
	await student.press(&"lab_next_step")
	assert_reads("What is the same before and after this bounce?")
	await click_button("the angular momentum about the contact")
	assert_eq(frame().lesson.step, CollisionFrictionModel.Step.LEDGER)


func test_nothing_is_asked_without_friction() -> void:
	await click_button("Friction")
	for i: int in 3:
		await student.press(&"lab_next_step")
	assert_eq(frame().lesson.step, CollisionFrictionModel.Step.CONE)
	assert_reads("Without friction the cone is a line")
	assert_has(formula_lines(), "jt = −µ jn = 0")


func test_velocity_spin_and_surface_can_be_dragged() -> void:
	await drag(Vec2.new(-60, -100), Vec2.new(-40, -80))
	assert_numbers("velocity", [200, 300])
	await drag(Vec2.new(0, -40), Vec2.new(40, -40))
	assert_almost_eq(_model().spin, 10.0, 1e-12)
	await drag(Vec2.new(100, 0), Vec2.new(80, 60))
	assert_numbers("along", [80, 60])
	await drag(Vec2.new(80, 60), Vec2.new(-80, 0))
	assert_reads("The ball must come to the surface with at least 1 px/s")
	await click_button("Undo")
	assert_numbers("along", [80, 60])


func test_the_edge_of_the_cone_is_dragged_until_it_slips() -> void:
	await go_to_step(CollisionFrictionModel.Step.CONE)
	var edge := (_part("ConeHandle") as Handle).at()
	await drag(edge, edge.minus(Vec2.new(30, 0)))
	assert_between(_model().friction, 0.05, 0.1)
	assert_reads("the surfaces slip on")
	await click_button("Undo")
	assert_eq(_model().friction, 0.25)


func test_numbers_can_be_typed_and_wrong_ones_are_refused() -> void:
	await enter("friction", "0,5")
	assert_eq(_model().friction, 0.5)
	await enter("spin of the ball", "-30")
	assert_eq(_model().spin, -30.0)
	await enter("bounciness", "2")
	assert_reads("C must be within 0..1, not 2.")
	await enter("y of v", "-5")
	assert_reads("The ball must come to the surface with at least 1 px/s, not −5.")


func test_while_it_is_asked_the_ball_flies_to_the_contact_only() -> void:
	await go_to_step(CollisionFrictionModel.Step.PUSH)
	await play_to_end()
	assert_vec2((_part("Ball") as TurnedBall).at(), Vec2.new(0.0, -20.0), 1e-9)


func test_it_hops_and_friction_acts_at_each_touch() -> void:
	await click_button("Hops")
	await go_to_step(CollisionFrictionModel.Step.FLY)
	assert_reads("touches: slips, sticks, sticks")
	await play_to_end()
	var way := (_part("Ball") as TurnedBall).at().x
	assert_gt(way, 150.0)
	for i: int in 30:
		await click_button("One frame back")
	assert_lt((_part("Ball") as TurnedBall).at().x, way)


func test_each_mistake_shows_its_number_and_can_be_undone() -> void:
	var wanted: PackedStringArray = [
		"v′ = (225, −400), ω′ = 0",
		"v′ = (100, −400), ω′ = 0",
		"v′ = (100, −400), ω′ = 20",
		"v′ = (0, −400), ω′ = 0",
		"v₂′ = (160, 120), ω₂′ = 0",
	]
	for i: int in wanted.size():
		await pick_mistake_at(i + 1)
		assert_eq(frame().lesson.step, CollisionFrictionModel.Step.AFTER)
		assert_reads("the mistake: " + wanted[i])
		assert_true((_part("Wrong") as CanvasItem).visible)
	await click_button("Undo")
	assert_eq(_model().mistake, CollisionFrictionMistakes.NO_TANGENT)
	assert_false(_model().two_balls)


func test_a_question_names_the_mistake_and_shows_its_numbers() -> void:
	var question := frame().lesson.services[&"question"] as FoldableContainer
	question.folded = false
	await student.settle()
	await student.enter(Screen.named(question, "u =") as LineEdit, "-300")
	assert_reads("The sign of r ω")
	await student.enter(Screen.named(question, "u =") as LineEdit, "900")
	assert_reads("Right: 900.")
	await click_button("Show on board")
	assert_eq(_model().spin, -30.0)


func test_the_readout_tells_the_error_and_the_miss() -> void:
	await enter("x of v", "123.456")
	await go_to_step(CollisionFrictionModel.Step.FLY)
	var readout := frame().lesson.services[&"readout"] as Readout
	assert_eq(readout.cell(1, 0).text, "v′")
	assert_lt(SeenLesson.first_number(readout.cell(1, 2).text), 1e-12)
	assert_eq(readout.cell(3, 0).text, "P, flown")
	assert_lt(SeenLesson.first_number(readout.cell(3, 2).text), 1e-12)
	assert_false(readout.folded)
	assert_reads("ε × condition")


func _model() -> CollisionFrictionModel:
	return frame().lesson.get(&"_model")


func _part(unique_name: String) -> Node:
	return frame().lesson.get_node("%" + unique_name)
