extends LabTest
## What a world takes, and the sentences for everything else.


func test_what_is_within_the_limits_is_taken() -> void:
	var far := Vec2.new(1e15, -1e15)
	var problems: PackedStringArray = [
		WorldLimits.problem_of_gravity(far),
		WorldLimits.problem_of_bounciness(0.0),
		WorldLimits.problem_of_bounciness(1.0),
		WorldLimits.problem_of_segment(LineSegment.new(far, Vec2.zero())),
		WorldLimits.problem_of_ball(Ball.new(far, 1e15, far, 1e15)),
		WorldLimits.problem_of_walls(Vec2.zero(), Vec2.new(1, 1e15)),
		WorldLimits.problem_of_place(3, true, "ball"),
	]
	assert_eq(problems, PackedStringArray(["", "", "", "", "", "", ""]))


func test_the_sentence_names_the_value_and_the_limit() -> void:
	var too_far := Vec2.new(2e15, 0)
	for problem: String in [
		WorldLimits.problem_of_gravity(too_far),
		WorldLimits.problem_of_segment(LineSegment.new(Vec2.zero(), too_far)),
		WorldLimits.problem_of_ball(Ball.new(too_far, 1)),
		WorldLimits.problem_of_ball(Ball.new(Vec2.zero(), 1, too_far)),
		WorldLimits.problem_of_walls(Vec2.zero(), Vec2.new(2e15, 1)),
	]:
		assert_string_contains(problem, "-1e15..1e15")
		assert_string_contains(problem, "2e+15")
	var large := WorldLimits.problem_of_ball(Ball.new(Vec2.zero(), 2e15))
	assert_string_contains(large, "at most 1e15, not 2000000000000000.0")


func test_numbers_that_are_none_are_refused() -> void:
	var none := Vec2.new(NAN, 0)
	assert_ne(WorldLimits.problem_of_gravity(none), "")
	assert_ne(WorldLimits.problem_of_bounciness(NAN), "")
	assert_ne(WorldLimits.problem_of_segment(LineSegment.new(none, Vec2.zero())), "")
	assert_ne(WorldLimits.problem_of_ball(Ball.new(none, 1)), "")
	assert_ne(WorldLimits.problem_of_walls(none, Vec2.new(1, 1)), "")


func test_an_empty_place_is_named() -> void:
	assert_eq(
		WorldLimits.problem_of_place(3, false, "segment"), "There is no segment at the place 3."
	)
