extends LabTest
## The easy case of the lecture, parts 1 and 2: one coordinate tells whether the ball hits, is put
## back, and has its velocity flipped.


func test_a_ball_hits_the_floor_when_its_lowest_point_is_below_it() -> void:
	assert_true(AxisBounce.hits_floor(_ball(100.0, 91.0, 10.0), 100.0))
	assert_false(AxisBounce.hits_floor(_ball(100.0, 89.0, 10.0), 100.0))


func test_a_ball_that_just_touches_the_floor_has_not_hit_it() -> void:
	assert_false(AxisBounce.hits_floor(_ball(0.0, 90.0, 10.0), 100.0))


func test_a_ball_hits_the_wall_when_its_rightmost_point_is_beyond_it() -> void:
	assert_true(AxisBounce.hits_wall(_ball(91.0, 100.0, 10.0), 100.0))
	assert_false(AxisBounce.hits_wall(_ball(90.0, 200.0, 10.0), 100.0))


func test_only_y_decides_about_the_floor_and_only_x_about_the_wall() -> void:
	assert_false(AxisBounce.hits_floor(_ball(500.0, 0.0, 10.0), 100.0))
	assert_false(AxisBounce.hits_wall(_ball(0.0, 500.0, 10.0), 100.0))


func test_put_on_the_floor_a_ball_keeps_its_x_and_touches() -> void:
	var ball := _ball(7.0, 130.0, 10.0)
	AxisBounce.put_on_floor(ball, 100.0)
	assert_vec2(ball.position, Vec2.new(7.0, 90.0), 0.0)


func test_put_beside_the_wall_a_ball_keeps_its_y_and_touches() -> void:
	var ball := _ball(130.0, 7.0, 10.0)
	AxisBounce.put_beside_wall(ball, 100.0)
	assert_vec2(ball.position, Vec2.new(90.0, 7.0), 0.0)


func test_putting_back_leaves_the_velocity_alone() -> void:
	var ball := _ball(95.0, 95.0, 10.0)
	AxisBounce.put_on_floor(ball, 100.0)
	AxisBounce.put_beside_wall(ball, 100.0)
	assert_vec2(ball.velocity, Vec2.new(3.0, 4.0), 0.0)


func test_a_floor_flips_y_and_a_wall_flips_x() -> void:
	var on_floor := _ball(0.0, 0.0, 10.0)
	var at_wall := _ball(0.0, 0.0, 10.0)
	AxisBounce.flip_y(on_floor)
	AxisBounce.flip_x(at_wall)
	assert_vec2(on_floor.velocity, Vec2.new(3.0, -4.0), 0.0)
	assert_vec2(at_wall.velocity, Vec2.new(-3.0, 4.0), 0.0)


func test_bounciness_shortens_only_the_flipped_component() -> void:
	var on_floor := _ball(0.0, 0.0, 10.0)
	var at_wall := _ball(0.0, 0.0, 10.0)
	AxisBounce.flip_y(on_floor, 0.5)
	AxisBounce.flip_x(at_wall, 0.5)
	assert_vec2(on_floor.velocity, Vec2.new(3.0, -2.0), 0.0)
	assert_vec2(at_wall.velocity, Vec2.new(-1.5, 4.0), 0.0)


func test_without_bounciness_the_ball_slides_along() -> void:
	var ball := _ball(0.0, 0.0, 10.0)
	AxisBounce.flip_y(ball, 0.0)
	assert_vec2(ball.velocity, Vec2.new(3.0, 0.0), 0.0)


func test_on_a_level_floor_the_easy_steps_agree_with_those_of_the_normal() -> void:
	# The line goes from right to left, so that its normal points up to the balls.
	var floor_line := LineSegment.new(Vec2.new(300.0, 40.0), Vec2.new(-300.0, 40.0))
	for velocity: Vec2 in random_vectors(11, 40, 90.0):
		var easy := Ball.new(
			Vec2.new(velocity.y, 30.0), 25.0, Vec2.new(velocity.x, absf(velocity.y))
		)
		var right := easy.copy()
		assert_eq(AxisBounce.hits_floor(easy, 40.0), LineDistance.is_overlapping(right, floor_line))
		AxisBounce.put_on_floor(easy, 40.0)
		AxisBounce.flip_y(easy)
		PositionReset.reset(right, floor_line)
		Bounce.apply(right.velocity, floor_line.normal())
		assert_vec2(easy.position, right.position, 1e-12)
		assert_vec2(easy.velocity, right.velocity, 1e-12)


func _ball(x: float, y: float, radius: float) -> Ball:
	return Ball.new(Vec2.new(x, y), radius, Vec2.new(3.0, 4.0))
