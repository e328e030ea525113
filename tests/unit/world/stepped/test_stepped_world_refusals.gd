extends LabTest
## Tests that a stepped world refuses what it cannot take, in one sentence, and stays as it was.


func test_a_bounciness_outside_0_to_1_is_refused() -> void:
	for value: float in [-0.1, 1.5, NAN, INF]:
		var surroundings := Surroundings.new()
		assert_eq(
			surroundings.set_bounciness(value),
			"The bounciness C must be within 0..1, not %s." % value
		)
		assert_eq(surroundings.bounciness, 1.0)


func test_gravity_that_is_not_finite_or_too_large_is_refused() -> void:
	var surroundings := Surroundings.new()
	assert_eq(surroundings.set_gravity(Vec2.new(0.0, 300.0)), "")
	for value: float in [NAN, INF, 2e6]:
		var problem := surroundings.set_gravity(Vec2.new(value, 0.0))
		assert_string_contains(problem, "Gravity must be within -1000000..1000000")
	assert_vec2(surroundings.gravity, Vec2.new(0.0, 300.0), 0.0)


func test_one_line_without_length_refuses_all_and_keeps_the_old_ones() -> void:
	var surroundings := Surroundings.new()
	var line := LineSegment.new(Vec2.new(), Vec2.new(5.0, 0.0))
	assert_eq(surroundings.set_segments([line]), "")
	var dot := LineSegment.new(Vec2.new(3.0, 3.0), Vec2.new(3.0, 3.0))
	assert_string_contains(surroundings.set_segments([line, line, dot]), "longer than 0")
	assert_eq(surroundings.segments.size(), 1)


func test_a_line_too_far_away_is_refused() -> void:
	var far := LineSegment.new(Vec2.new(), Vec2.new(2e6, 0.0))
	assert_string_contains(Surroundings.new().set_segments([far]), "-1000000..1000000 px")


func test_balls_that_cannot_be_used_are_refused_and_the_old_ones_stay() -> void:
	var world := SteppedWorlds.world([], Ball.new(Vec2.new(1.0, 2.0), 5.0))
	var wrong: Array[Ball] = [
		Ball.new(Vec2.new(NAN, 0.0), 5.0),
		Ball.new(Vec2.new(), 0.0),
		Ball.new(Vec2.new(900.0, 0.0), 5.0),
		Ball.new(Vec2.new(), 5.0, Vec2.new(2e6, 0.0)),
		Ball.new(Vec2.new(), 5.0, Vec2.new(), -1.0),
	]
	for ball: Ball in wrong:
		assert_ne(world.set_balls([ball]), "", "%s %s" % [ball.position, ball.radius])
	assert_vec2(world.balls[0].position, Vec2.new(1.0, 2.0), 0.0)


func test_a_ball_cannot_be_put_out_of_reach() -> void:
	var world := SteppedWorlds.world([], Ball.new(Vec2.new(1.0, 2.0), 5.0))
	var problem := world.change_ball(0, Vec2.new(0.0, 801.0), Vec2.new())
	assert_eq(problem, "A ball must be within -800..800 px in x and y, not at (0, 801).")
	assert_vec2(world.balls[0].position, Vec2.new(1.0, 2.0), 0.0)


func test_a_step_that_is_not_a_time_is_refused() -> void:
	var world := SteppedWorlds.world([], Ball.new(Vec2.new(), 5.0, Vec2.new(60.0, 0.0)))
	for seconds: float in [0.0, -0.1, 1.5, NAN]:
		assert_eq(
			world.step(seconds), "A step must last above 0 and at most 1 s, not %s." % seconds
		)
	assert_eq(world.frames, 0)


func test_a_state_of_the_wrong_size_or_with_nan_is_refused() -> void:
	var world := SteppedWorlds.world([], Ball.new(Vec2.new(1.0, 2.0), 5.0))
	var state := world.state()
	var broken := state.duplicate()
	broken[4] = NAN
	assert_string_contains(world.put_state(broken), "must be finite")
	assert_eq(world.put_state(state.slice(1)), "The state of 1 balls has 8 numbers, not 7.")
	assert_eq(world.state(), state)
