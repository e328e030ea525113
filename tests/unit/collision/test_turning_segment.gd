extends LabTest
## A segment that turns about a pivot.

var _paddle := LineSegment.new(Vec2.new(10, 0), Vec2.new(30, 0))


func test_a_quarter_turn_is_clockwise_on_screen() -> void:
	var turning := TurningSegment.new(_paddle, Vec2.zero(), PI / 2.0)
	var moved := turning.segment_at(1.0)
	assert_vec2(moved.start, Vec2.new(0, 10), 1e-14)
	assert_vec2(moved.end, Vec2.new(0, 30), 1e-14)


func test_the_pivot_moves_and_takes_the_segment_along() -> void:
	var turning := TurningSegment.new(_paddle, Vec2.new(10, 0), PI, Vec2.new(5, -7))
	assert_vec2(turning.pivot_at(2.0), Vec2.new(20, -14), 0.0)
	var moved := turning.segment_at(1.0)
	assert_vec2(moved.start, Vec2.new(15, -7), 1e-13)
	assert_vec2(moved.end, Vec2.new(-5, -7), 1e-13)


func test_a_point_moves_across_its_arm() -> void:
	var turning := TurningSegment.new(_paddle, Vec2.zero(), 2.0, Vec2.new(1, 1))
	assert_vec2(turning.velocity_at(Vec2.new(30, 0)), Vec2.new(1, 61), 0.0)
	assert_vec2(turning.velocity_at(Vec2.new(0, 30)), Vec2.new(-59, 1), 0.0)


func test_that_is_how_fast_the_ends_move() -> void:
	var turning := TurningSegment.new(_paddle, Vec2.new(3, 4), -1.5, Vec2.new(20, 10))
	var way := turning.segment_at(1e-6).end.minus(_paddle.end)
	var arm := _paddle.end.minus(turning.pivot)
	assert_vec2(way.scaled(1e6), turning.velocity_at(arm), 1e-4)


func test_it_reaches_as_far_as_its_farther_end() -> void:
	assert_eq(TurningSegment.new(_paddle, Vec2.new(12, 0), 1.0).reach(), 18.0)


func test_it_shares_nothing_with_what_it_was_made_of() -> void:
	var pivot := Vec2.zero()
	var paddle := _paddle.copy()
	var turning := TurningSegment.new(paddle, pivot, 1.0)
	pivot.x = 99.0
	paddle.start.x = 99.0
	assert_vec2(turning.pivot, Vec2.zero(), 0.0)
	assert_vec2(turning.segment.start, Vec2.new(10, 0), 0.0)


func test_what_cannot_be_used_is_named() -> void:
	assert_eq(TurningSegment.new(_paddle, Vec2.zero(), -40.0).problem(40.0), "")
	for bad: float in [INF, NAN, -41.0]:
		var turning := TurningSegment.new(_paddle, Vec2.zero(), bad)
		assert_eq(turning.problem(40.0), "A segment must turn by -40..40 rad/s, not by %s." % bad)
		turning = TurningSegment.new(_paddle, Vec2.new(bad, 0), 1.0)
		assert_string_contains(turning.problem(40.0), "must be within -40..40, not (")
	var point := LineSegment.new(Vec2.zero(), Vec2.zero())
	var problem := TurningSegment.new(point, Vec2.zero(), 1.0).problem(40.0)
	assert_string_contains(problem, "A segment must be longer than 0")
