extends LabTest
## What an event world takes, and the sentences that refuse everything else.


func test_what_is_within_the_limits_is_taken() -> void:
	var far := Vec2.new(1e15, -1e15)
	var world := EventWorld.new()
	var refusals: PackedStringArray = [
		world.set_gravity(far),
		world.set_bounciness(0.0),
		world.set_bounciness(1.0),
		world.add_segment(LineSegment.new(far, Vec2.zero())),
		world.add_ball(Ball.new(far, 1e15, far, 1e15)),
		world.set_walls(Vec2.new(0, -1e15), Vec2.new(1, 1e15)),
	]
	assert_eq(refusals, PackedStringArray(["", "", "", "", "", ""]))


func test_each_setter_names_the_value_and_the_limit() -> void:
	var too_far := Vec2.new(2e15, 0)
	var world := EventWorld.new()
	for refusal: String in [
		world.set_gravity(too_far),
		world.add_segment(LineSegment.new(Vec2.zero(), too_far)),
		world.set_segments([LineSegment.new(too_far, Vec2.zero())]),
		world.add_ball(Ball.new(too_far, 1)),
		world.set_balls([Ball.new(Vec2.zero(), 1, too_far)]),
		world.set_walls(Vec2.zero(), Vec2.new(2e15, 1)),
	]:
		assert_string_contains(refusal, "-1e+15..1e+15")
		assert_string_contains(refusal, "2e+15")


func test_a_bounciness_outside_0_to_1_is_refused() -> void:
	assert_eq(
		EventWorld.new().set_bounciness(1.5), "The bounciness C must be within 0..1, not 1.5."
	)


func test_a_changed_ball_and_a_moved_segment_are_held_to_the_limit_too() -> void:
	var too_far := Vec2.new(2e15, 0)
	var world := EventWorld.new()
	assert_eq(world.add_ball(Ball.new(Vec2.new(100, 100), 1)), "")
	assert_eq(world.add_segment(LineSegment.new(Vec2.zero(), Vec2.new(1, 0))), "")
	assert_string_contains(world.change_ball(0, Ball.new(too_far, 1)), "-1e+15..1e+15")
	var longer := LineSegment.new(Vec2.zero(), too_far)
	assert_string_contains(world.move_segment(0, longer), "-1e+15..1e+15")
	assert_vec2(world.segment(0).end, Vec2.new(1, 0), 0.0)


func test_nan_is_refused() -> void:
	var nan := Vec2.new(NAN, 0)
	var world := EventWorld.new()
	assert_ne(world.set_gravity(nan), "")
	assert_ne(world.set_bounciness(NAN), "")
	assert_ne(world.add_segment(LineSegment.new(nan, Vec2.zero())), "")
	assert_ne(world.add_ball(Ball.new(nan, 1)), "")
	assert_ne(world.set_walls(nan, Vec2.new(1, 1)), "")
	assert_eq(world.ball_count(), 0)
	assert_eq(world.segment_count(), 0)


func test_walls_need_a_corner_above_and_left_of_the_other() -> void:
	for high: Vec2 in [Vec2.new(0, 1), Vec2.new(1, 0), Vec2.new(-1, 1)]:
		assert_string_contains(WorldLimits.problem_of_walls(Vec2.zero(), high), str(high))


func test_an_empty_place_is_named() -> void:
	assert_eq(WorldLimits.problem_of_place(3, true, "ball"), "")
	assert_eq(
		WorldLimits.problem_of_place(3, false, "segment"), "There is no segment at the place 3."
	)
