extends LabTest
## Where the ball in the box is exactly, and how an answer is judged.


func test_a_free_flight_is_start_plus_velocity_times_time() -> void:
	assert_eq(BallInBox.folded(10.0, 3.0, 2.0, 0.0, 100.0).to_float(), 16.0)


func test_a_wall_turns_the_way_round() -> void:
	# 90 + 3 * 7 = 111: 11 beyond the upper end. 10 - 3 * 7 = -11: 11 below the lower one.
	assert_eq(BallInBox.folded(90.0, 3.0, 7.0, 0.0, 100.0).to_float(), 89.0)
	assert_eq(BallInBox.folded(10.0, -3.0, 7.0, 0.0, 100.0).to_float(), 11.0)


func test_whole_rounds_bring_it_back() -> void:
	# There and back is 200 px: the ball makes 2e9 rounds and 30 px.
	assert_eq(BallInBox.folded(20.0, 1.0, 4e11 + 30.0, 0.0, 100.0).to_float(), 50.0)


func test_the_answer_agrees_with_bouncing_step_by_step() -> void:
	# Whole numbers in a room that does not begin at 0: neither answer is rounded.
	var x := -37
	var velocity := 13
	for second: int in 500:
		var exact := BallInBox.folded(-37.0, 13.0, float(second), -51.0, 46.0)
		assert_eq(exact.to_float(), float(x))
		x += velocity
		if x > 46:
			x = 92 - x
			velocity = -velocity
		elif x < -51:
			x = -102 - x
			velocity = -velocity


func test_digits_beyond_a_double_are_kept() -> void:
	# The double 0.1 is 5.55e-18 too large: times 1e6 this shows in the low part.
	var exact := BallInBox.folded(0.0, 0.1, 1e6, 0.0, 1e9)
	assert_almost_eq(exact.error_of(100000.0), -5.551115123125783e-12, 1e-20)


func test_the_error_is_the_distance_from_the_exact_place() -> void:
	var velocity := BallInBox.ball(300.0).velocity
	var place := Vec2.new(BallInBox.START_X + 0.25 * velocity.x, BallInBox.START_Y)
	place.add(Vec2.new(3.0, 0.25 * velocity.y + 4.0))
	assert_almost_eq(BallInBox.error_of(place, 300.0, 0.25), 5.0, 1e-12)


func test_a_ball_outside_gives_no_answer() -> void:
	for place: Vec2 in [Vec2.new(300.5, 0.0), Vec2.new(0.0, -200.5), Vec2.new(NAN, 0.0)]:
		assert_eq(BallInBox.error_of(place, 300.0, 1.0), Measurement.NO_ANSWER)


func test_the_walls_surround_the_ball() -> void:
	for wall in BallInBox.walls():
		assert_gt(wall.closest_point(BallInBox.ball(1.0).position).x, -301.0)
	assert_eq(BallInBox.walls().size(), 4)
