extends LabTest
## The lines of week 4: endless, with one good side.

const _FRAME := 1.0 / 60.0


func test_a_line_acts_beyond_its_ends() -> void:
	var world := _world(Ball.new(Vec2.new(500.0, 85.0), 10.0, Vec2.new(0.0, 600.0)))
	assert_no_refusal(world.step(_FRAME))
	assert_vec2(world.balls[0].position, Vec2.new(500, 90), 1e-9)
	assert_vec2(world.balls[0].velocity, Vec2.new(0, -600), 1e-9)
	assert_eq(world.bounces, 1)


func test_a_ball_behind_a_line_is_put_before_it() -> void:
	var world := _world(Ball.new(Vec2.new(3.0, 250.0), 10.0))
	assert_no_refusal(world.step(_FRAME))
	assert_vec2(world.balls[0].position, Vec2.new(3, 90), 1e-9)
	assert_eq(world.bounces, 0)


func test_a_ball_on_the_good_side_flies_on() -> void:
	var world := _world(Ball.new(Vec2.new(0.0, 0.0), 10.0, Vec2.new(60.0, 60.0)))
	assert_no_refusal(world.step(_FRAME))
	assert_vec2(world.balls[0].position, Vec2.new(1, 1), 1e-9)


# The rule of overlap of lines that end would put it to the nearer side.
func test_no_changed_line_pushes_a_ball_out_before_the_frame() -> void:
	var world := _world(Ball.new(Vec2.new(0.0, 0.0), 10.0))
	assert_no_refusal(world.step(_FRAME))
	assert_no_refusal(world.surroundings.set_segments([_line(-5.0)]))
	world.push_out_balls()
	assert_vec2(world.balls[0].position, Vec2.new(), 1e-9)
	assert_no_refusal(world.step(_FRAME))
	assert_vec2(world.balls[0].position, Vec2.new(0, -15), 1e-9)


# A level line at this y; its good side is above it.
func _line(y: float) -> LineSegment:
	return LineSegment.new(Vec2.new(20.0, y), Vec2.new(-20.0, y))


func _world(ball: Ball) -> SteppedWorld:
	var world := SteppedWorld.new(EndlessLineMover.new())
	assert_no_refusal(world.surroundings.set_segments([_line(100.0)]))
	assert_no_refusal(world.set_balls([ball]))
	return world
