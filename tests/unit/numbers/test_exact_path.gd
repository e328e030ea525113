extends LabTest
## The exact path against the reference trajectories, worked out elsewhere with 140 digits.

## The promised error: 8 units in the last of 106 bits, per unit of relative change in the start.
const PROMISED := 1.0 / 2.0 ** 103


func test_bounces_ends_and_velocities_of_the_reference_trajectories_agree() -> void:
	var shares := PackedFloat64Array()
	for case in ReferenceTrajectory.all():
		var path := _path(case.ball, case.segments, case.seconds)
		shares.append(_error_of_end(path, case) / (PROMISED * case.amplification))
		assert_eq(path.bounces(), case.bounces, case.title)
		assert_vec2(path.velocity(), case.end_velocity, _velocity_bound(case), case.title)
	var sorted := shares.duplicate()
	sorted.sort()
	gut.p("worst end of %d paths: %s of the bound" % [sorted.size(), String.num(sorted[-1], 3)])
	assert_all_at_most(shares, 1.0)


func test_a_place_in_the_past_is_that_of_a_path_which_ended_there() -> void:
	var case := ReferenceTrajectory.all()[-1]
	var path := _path(case.ball, case.segments, 3.0)
	for moment: float in [0.0, 0.4, 1.7, 3.0]:
		var ended := _path(case.ball, case.segments, moment)
		assert_vec2(path.position_at(moment), ended.position(), 0.0)


func test_a_flight_begins_where_the_one_before_ends() -> void:
	var path := _path(Ball.new(Vec2.new(0, 0), 1.0, Vec2.new(7, 0)), [_wall(8), _wall(-8)], 10.0)
	assert_eq(path.bounces(), 5)
	assert_eq(path.flights.map(_start_of), [0.0, 1.0, 3.0, 5.0, 7.0, 9.0])
	assert_eq(path.flights.map(_index_of), [-1, 0, 1, 0, 1, 0])
	assert_vec2(path.position(), Vec2.new(0, 0), 0.0)


func test_a_bounce_at_the_very_end_has_happened() -> void:
	var path := _path(Ball.new(Vec2.new(0, 0), 1.0, Vec2.new(7, 0)), [_wall(8)], 1.0)
	assert_eq(path.bounces(), 1)
	assert_vec2(path.velocity(), Vec2.new(-7, 0), 0.0)


func test_a_corner_hit_exactly_turns_the_ball_round() -> void:
	var floor_line := LineSegment.new(Vec2.new(-90, 8), Vec2.new(90, 8))
	var path := _path(Ball.new(Vec2.new(0, 0), 1.0, Vec2.new(7, 7)), [_wall(8), floor_line], 2.0)
	assert_eq(path.bounces(), 2)
	assert_vec2(path.position(), Vec2.new(0, 0), 0.0)


func test_without_anything_in_the_way_it_flies_on() -> void:
	var path := _path(Ball.new(Vec2.new(1, 2), 1.0, Vec2.new(-3, 4)), [_wall(8)], 1e6)
	assert_vec2(path.position(), Vec2.new(-2999999, 4000002), 0.0)


func test_later_pieces_of_a_path_are_those_of_one_call() -> void:
	var case := ReferenceTrajectory.all()[-1]
	var path := _path(case.ball, case.segments, 0.7)
	assert_eq(path.advance_to(2.9), "")
	assert_vec2(path.position(), _path(case.ball, case.segments, 2.9).position(), 0.0)


func test_what_cannot_be_used_is_refused_and_the_old_path_stays() -> void:
	var path := _path(Ball.new(Vec2.new(0, 0), 1.0, Vec2.new(7, 0)), [_wall(8)], 1.0)
	var dot := LineSegment.new(Vec2.new(3, 3), Vec2.new(3, 3))
	assert_string_contains(path.start(Ball.new(Vec2.new(), 1.0), [dot]), "longer than 0")
	assert_string_contains(path.start(Ball.new(Vec2.new(), -1.0), []), "above 0")
	assert_eq([path.time, path.bounces()], [1.0, 1])


func test_a_time_that_is_over_or_no_time_is_refused() -> void:
	var path := _path(Ball.new(Vec2.new(0, 0), 1.0, Vec2.new(7, 0)), [_wall(8)], 1.0)
	for until: float in [0.5, NAN, INF]:
		assert_string_contains(path.advance_to(until), "from 1.0 s to a finite time, not to")
	assert_string_contains(ExactPath.new().advance_to(1.0), "no start yet")


func test_bounces_without_end_are_refused() -> void:
	var caught := Ball.new(Vec2.new(0, 0), 5.0, Vec2.new(7, 0))
	var path := ExactPath.new()
	assert_eq(path.start(caught, [_wall(3), _wall(-3)]), "")
	assert_eq(path.advance_to(1.0, 100), "There are more than 100 bounces before 1.0 s.")
	assert_eq(path.time, 0.0)


func _path(ball: Ball, segments: Array[LineSegment], until: float) -> ExactPath:
	var path := ExactPath.new()
	assert_eq(path.start(ball, segments) + path.advance_to(until), "")
	return path


func _wall(x: float) -> LineSegment:
	return LineSegment.new(Vec2.new(x, -90), Vec2.new(x, 90))


# The error of the worse component, less the rounding of the reference.
func _error_of_end(path: ExactPath, case: ReferenceTrajectory) -> float:
	var end := path.exact_position()
	var error_x := absf(end.x.error_of(case.end.x)) - last_place(case.end.x) / 2.0
	var error_y := absf(end.y.error_of(case.end.y)) - last_place(case.end.y) / 2.0
	return maxf(maxf(error_x, error_y), 0.0)


# An error of one radius in the place turns the velocity by about 1 radian.
func _velocity_bound(case: ReferenceTrajectory) -> float:
	var speed := case.end_velocity.length()
	return last_place(speed) + speed / case.ball.radius * case.amplification * PROMISED


func _start_of(flight: ExactFlight) -> float:
	return flight.start.to_float()


func _index_of(flight: ExactFlight) -> int:
	return flight.segment_index
