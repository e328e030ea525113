extends LabTest
## Tests that catch the known mistakes of stepping: numbers 14, 21, 24 and 26 of the course.

const FRAME := SteppedWorlds.FRAME


# Mistake 14. The ball overlaps by 1 px and moves away so slowly that it still does after the frame.
func test_a_ball_that_moves_away_is_not_reflected_again() -> void:
	var floor_line: Array[Vector4] = [Vector4(-90, 0, 90, 0)]
	for method: int in SteppingMethods.Method.size():
		var ball := Ball.new(Vec2.new(0.0, -9.0), 10.0, Vec2.new(30.0, -30.0))
		var world := SteppedWorlds.world(floor_line, ball)
		world.mover = SteppingMethods.mover_of(method as SteppingMethods.Method)
		assert_no_refusal(world.step(FRAME))
		assert_vec2(world.balls[0].velocity, Vec2.new(30.0, -30.0), 0.0, "method %d" % method)


# Mistake 21. The motion of this frame reaches both walls, the second one behind the first.
func test_the_earliest_of_two_walls_is_hit() -> void:
	var walls: Array[Vector4] = [Vector4(20, -90, 20, 90), Vector4(60, -90, 60, 90)]
	for order: int in 2:
		var ball := Ball.new(Vec2.new(-30.0, 0.0), 10.0, Vec2.new(6000.0, 0.0))
		var world := SteppedWorlds.world(walls, ball)
		assert_no_refusal(world.step(FRAME))
		# 40 px to the contact, 60 px back.
		assert_vec2(world.balls[0].position, Vec2.new(-50.0, 0.0), 1e-9, "order %d" % order)
		walls.reverse()


# Mistake 24. The ball touches after 40 of the 100 px of the frame.
func test_the_rest_of_the_frame_is_used() -> void:
	var ball := Ball.new(Vec2.new(0.0, -50.0), 10.0, Vec2.new(0.0, 6000.0))
	var world := SteppedWorlds.world([Vector4(-90, 0, 90, 0)], ball)
	assert_no_refusal(world.step(FRAME))
	assert_vec2(world.balls[0].position, Vec2.new(0.0, -70.0), 1e-9)


# Mistake 26. The ball falls 3 px before the bounce: v^2 = v0^2 + 2 g s.
func test_gravity_before_the_bounce_lasts_until_the_bounce() -> void:
	var ball := Ball.new(Vec2.new(0.0, -13.0), 10.0, Vec2.new(0.0, 400.0))
	var world := SteppedWorlds.world([Vector4(-90, 0, 90, 0)], ball, Vec2.new(0.0, 3000.0))
	assert_no_refusal(world.step(FRAME))
	var record := world.latest_bounces[0]
	assert_almost_eq(record.velocity_before.y, sqrt(400.0 ** 2 + 2.0 * 3000.0 * 3.0), 1e-9)
	assert_almost_eq(record.velocity_after.y, -record.velocity_before.y, 1e-9)
