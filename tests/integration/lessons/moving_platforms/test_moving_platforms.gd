extends LessonTest
## Drives the lesson on surfaces that move: steps, kinds, dragging, typing, the frame of reference,
## the bug gallery, the flight.

const _STEPS := MovingPlatformsModel.Step


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"moving_platforms"))


func after_each() -> void:
	Engine.time_scale = 1.0
	await super()


func test_the_same_impact_in_both_frames_of_reference() -> void:
	await go_to_step(_STEPS.FRAME)
	assert_eq(formula_lines()[-1], "U = v − w = (−200, 100) − (100, 0) = (−300, 100)")
	await go_to_step(_STEPS.LAW)
	assert_has(formula_lines(), "C = 1   n = (1, 0)   U · n = −300")
	assert_eq(formula_lines()[-1], "U′ = U − (1 + C) (U · n) n = (300, 100)")
	await go_to_step(_STEPS.BACK)
	assert_eq(formula_lines()[-1], "v′ = U′ + w = (300, 100) + (100, 0) = (400, 100)")
	assert_reads("v′ = (400, 100)")
	assert_vec2(_part_at("BallThen"), Vec2.new(0, 0), 1e-9)
	await click_button("Ride along")
	# Seen from the wall, the ball comes to where the wall is at the start.
	assert_vec2(_part_at("BallThen"), Vec2.new(-100, 0), 1e-9)


func test_both_velocities_are_dragged() -> void:
	await go_to_step(_STEPS.BACK)
	await drag(Vec2.new(100, -50), Vec2.new(120, -50))
	assert_numbers("velocity", [-160, 100])
	await drag(Vec2.new(-70, 0), Vec2.new(-20, 0))
	assert_numbers("surface_velocity", [200, 0])
	assert_reads("v′ = (560, 100)")
	await student.press(&"lab_undo")
	assert_numbers("surface_velocity", [100, 0])
	await drag(Vec2.new(200, -100), Vec2.new(-110, -60))
	assert_reads("the ball's centre must be more than 20 px from the surface")


func test_numbers_can_be_typed_and_wrong_ones_are_refused() -> void:
	await enter("x of v", "-300")
	assert_numbers("velocity", [-300, 100])
	await enter("bounciness C", "2")
	assert_reads("C must be within 0..1, not 2.")
	await enter("bounciness C", "0.5")
	await go_to_step(_STEPS.BACK)
	assert_reads("v′ = (300, 100)")


func test_each_kind_has_its_own_start_and_answer() -> void:
	await go_to_step(_STEPS.BACK)
	var wanted: Dictionary[String, String] = {
		"a belt": "then it rolls with 30 px/s",
		"a platform": "carried for 2 s",
		"a paddle that turns": "v′ = (600, 100)",
		"a press": "after 3 bounces off it: 900 px/s",
		"a wall": "v′ = (400, 100)",
	}
	for kind in wanted:
		await pick("What moves", kind)
		assert_reads(wanted[kind])


func test_the_belt_is_dragged_and_its_slope() -> void:
	await pick("What moves", "a belt")
	await go_to_step(_STEPS.BACK)
	assert_eq(formula_lines()[-1], "v′ = v − u / 3 = 0 − (−30) = 30")
	await drag(Vec2.new(90, 74), Vec2.new(150, 74))
	assert_eq(_model().surface_speed, 150.0)
	assert_reads("then it rolls with 50 px/s")
	await drag(Vec2.new(-120, -16), Vec2.new(-60, -16))
	assert_eq(_model().speed, 60.0)
	await click_button("Uphill")
	assert_reads("then it rolls with 60 px/s")
	assert_reads("no belt holds a disc")


func test_the_paddle_turns_faster_when_its_tip_is_dragged() -> void:
	await pick("What moves", "a paddle that turns")
	await go_to_step(_STEPS.FRAME)
	assert_has(formula_lines(), "r = (0, −100)   w = ω (−r.y, r.x) = (200, 0)")
	var head := (frame().lesson.get_node("%SurfaceVelocityHead") as Handle).at()
	var tip := Vec2.new(-120, 190)
	await drag(head, tip.plus(head.minus(tip).scaled(0.5)))
	assert_almost_eq(_model().turning, 1.0, 0.1)


func test_the_press_closes_and_tells_the_crushed_ball() -> void:
	await pick("What moves", "a press")
	await go_to_step(_STEPS.BACK)
	assert_has(formula_lines(), "u₃ = u₀ + 3·2 V = 300 + 600 = 900")
	assert_eq(formula_lines()[-1], "h₃ = h₀ (u₀ − V) / (u₃ − V) = 200·200 / 800 = 50")
	await go_to_step(_STEPS.FLY)
	assert_reads("crushed after 2 s")
	await play_to_end()
	assert_eq((frame().lesson.get_node("%ShownBall") as BallView).role, Palette.Role.WRONG)
	await drag(Vec2.new(120, 0), Vec2.new(170, 0))
	assert_eq(_model().way, 300.0)
	assert_reads("crushed after 3 s")


func test_each_mistake_is_shown_with_its_number() -> void:
	await click_button("C = 0.5")
	await pick("Known mistakes", "The wall taken to rest")
	assert_eq(frame().lesson.step, _STEPS.BACK)
	assert_reads("the mistake: v′ = (100, 0)")
	await pick("Known mistakes", "Wall added once")
	assert_reads("the mistake: v′ = (200, 0)")
	await pick("Known mistakes", "Wall added twice")
	assert_reads("the mistake: v′ = (300, 0)")
	assert_eq(formula_lines()[-1], "mistake: (300, 0)")
	await pick("Known mistakes", "The tip's velocity")
	assert_reads("the mistake: v′ = (800, 100)")
	await pick("Known mistakes", "The belt's speed")
	assert_reads("the mistake: 90 px/s")
	await pick("Known mistakes", "One frame late")
	assert_reads("the mistake: 1.5 px behind")


func test_what_never_meets_says_so() -> void:
	await go_to_step(_STEPS.BACK)
	await drag(Vec2.new(100, -50), Vec2.new(300, -50))
	assert_reads("Within 20 s they do not meet.")
	assert_reads("no impact within 20 s")
	assert_eq(formula_lines()[-1], "no impact")


func test_it_flies_in_the_event_world_and_misses_by_rounding_alone() -> void:
	await go_to_step(_STEPS.FLY)
	assert_reads("; ε × condition ")
	await play_to_end()
	assert_vec2(_part_at("ShownBall"), Vec2.new(240, 60), 1e-6)


func test_before_the_answer_it_plays_until_they_meet() -> void:
	await play_to_end()
	assert_vec2(_part_at("ShownBall"), Vec2.new(0, 0), 1e-6)


func test_it_asks_for_the_arrow_after_the_impact() -> void:
	await go_to_step(_STEPS.LAW)
	await student.press(&"lab_next_step")
	var guess := frame().lesson.get_node("%Guess") as Control
	assert_true(guess.is_visible_in_tree())
	await drag(Vec2.new(-100, 50), Vec2.new(180, 50))
	await student.press(&"lab_next_step")
	assert_reads("Your guess was 20 off.")


func test_it_asks_what_becomes_of_the_disc() -> void:
	await pick("What moves", "a belt")
	await go_to_step(_STEPS.FRAME)
	await student.press(&"lab_next_step")
	await click_button("as fast as the belt")
	assert_reads("No, a third as fast")


func test_the_readout_has_the_velocity_with_its_error() -> void:
	await go_to_step(_STEPS.FLY)
	var readout := frame().lesson.services[&"readout"] as Readout
	assert_eq(readout.cell(1, 1).text, "(400, 100)")
	assert_eq(readout.cell(1, 2).text, "0")


func test_a_question_is_shown_on_the_board() -> void:
	assert_eq(frame().link.open("kind=3"), "")
	var question := MovingPlatformsExercise.of_the_lecture(MovingPlatformsExercise.Kind.SOFT)
	assert_no_refusal(_model().take(question.board_state()))
	assert_vec2(_model().impact().leaving, Vec2.new(250, 0), 0.0)


func test_it_has_links() -> void:
	await click_button("From behind")
	assert_string_contains(frame().link.text(), "velocity=100,50")
	assert_eq(frame().link.open("kind=1&ball=0,0&surface=-200,40,200,40&surface_speed=120"), "")
	assert_almost_eq(_model().rolling_speed(), 40.0, 1e-12)
	assert_string_contains(frame().link.open("turning=30"), "ω must be within −20..20, not 30.")


func _model() -> MovingPlatformsModel:
	return frame().lesson.get(&"_model")


func _part_at(part: String) -> Vec2:
	return (frame().lesson.get_node("%" + part) as BallView).at()
