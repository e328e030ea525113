extends LabTest
## Tests of the event world as a way of stepping. It agrees with the course's best way where both
## are exact, does not depend on the length of a frame, and predicts anew after a change.

const FRAME := SteppedWorlds.FRAME
const BOX: Array[Vector4] = [
	Vector4(-100, -80, 100, -80),
	Vector4(100, -80, 100, 80),
	Vector4(100, 80, -100, 80),
	Vector4(-100, 80, -100, -80),
]


func test_without_gravity_it_agrees_with_the_whole_frame_used() -> void:
	var exact := _world(Vec2.new(310.0, 170.0))
	var stepped := exact.copy()
	stepped.mover = WholeFrameMover.new()
	for frame: int in 300:
		assert_no_refusal(exact.step(FRAME))
		assert_no_refusal(stepped.step(FRAME))
	assert_vec2(exact.balls[0].position, stepped.balls[0].position, 1e-8)
	assert_eq(exact.bounces, stepped.bounces)
	assert_gt(exact.bounces, 5)


func test_under_gravity_the_end_does_not_depend_on_the_frame() -> void:
	var ends: Array[Vec2] = []
	for frames: int in [10, 60, 240]:
		var world := _world(Vec2.new(90.0, 0.0))
		assert_no_refusal(world.surroundings.set_gravity(Vec2.new(0.0, 300.0)))
		for frame: int in frames:
			assert_no_refusal(world.step(1.0 / frames))
		ends.append(world.balls[0].position)
	assert_vec2(ends[0], ends[1], 1e-10)
	assert_vec2(ends[2], ends[1], 1e-10)


func test_a_drop_bounces_at_the_time_of_the_fall() -> void:
	var world := _world(Vec2.new())
	assert_no_refusal(world.surroundings.set_gravity(Vec2.new(0.0, 300.0)))
	while world.bounces == 0:
		assert_no_refusal(world.step(FRAME))
	var seconds := (world.frames - 1 + world.latest_bounces[0].fraction) * FRAME
	# 75 px to fall: t = sqrt(2 h / g).
	assert_almost_eq(seconds, sqrt(2.0 * 75.0 / 300.0), 1e-12)
	assert_vec2(world.latest_bounces[0].position, Vec2.new(0.0, 75.0), 1e-10)


func test_a_ball_that_was_put_elsewhere_is_predicted_anew() -> void:
	var world := _world(Vec2.new(100.0, 0.0))
	assert_no_refusal(world.step(FRAME))
	assert_no_refusal(world.change_ball(0, Vec2.new(-50.0, 0.0), Vec2.new(0.0, 60.0)))
	assert_no_refusal(world.step(FRAME))
	assert_vec2(world.balls[0].position, Vec2.new(-50.0, 1.0), 1e-12)


func test_a_line_that_comes_is_bounced_off() -> void:
	var world := _world(Vec2.new(600.0, 0.0))
	assert_no_refusal(world.step(FRAME))
	var lines := world.surroundings.segments.duplicate()
	lines.append(LineSegment.new(Vec2.new(30.0, -20.0), Vec2.new(30.0, 20.0)))
	assert_no_refusal(world.surroundings.set_segments(lines))
	for frame: int in 2:
		assert_no_refusal(world.step(FRAME))
	# The contact is at x = 25, after 25 px of 30.
	assert_vec2(world.balls[0].position, Vec2.new(20.0, 0.0), 1e-10)


func test_a_copy_does_not_move_the_ball_it_was_copied_from() -> void:
	var world := _world(Vec2.new(310.0, 170.0))
	assert_no_refusal(world.step(FRAME))
	var before := world.state()
	var copy := world.copy()
	assert_no_refusal(copy.step(FRAME))
	assert_eq(world.state(), before)
	assert_ne(copy.mover, world.mover)


func test_a_jammed_ball_stops_instead_of_hanging() -> void:
	var world := SteppedWorlds.world(
		[Vector4(-50, 5, 50, 5), Vector4(-50, -5, 50, -5)] as Array[Vector4],
		Ball.new(Vec2.new(), 5.0, Vec2.new(0.0, 1000.0))
	)
	world.mover = EventMover.new()
	for frame: int in 3:
		assert_string_contains(world.step(FRAME), "more than 2000 impacts within a second")
	assert_true(world.balls[0].position.is_finite())
	assert_between(world.balls[0].position.y, -1e-6, 1e-6)


# Its bounces off both lines get lower and more frequent without end.
func test_a_ball_in_a_corner_comes_to_rest(
	bounciness: float = use_parameters([0.8, 0.9, 0.95])
) -> void:
	var world := SteppedWorld.new(EventMover.new())
	var lines: Array[LineSegment] = [
		LineSegment.new(Vec2.new(-70.0, -74.0), Vec2.zero()),
		LineSegment.new(Vec2.zero(), Vec2.new(70.0, -70.0)),
	]
	assert_no_refusal(world.surroundings.set_segments(lines))
	assert_no_refusal(world.surroundings.set_gravity(Vec2.new(0.0, 300.0)))
	assert_no_refusal(world.surroundings.set_bounciness(bounciness))
	assert_no_refusal(world.set_balls([Ball.new(Vec2.new(-5.0, -22.0), 12.0)]))
	for frame: int in 900:
		assert_eq(world.step(FRAME), "", "frame %d" % frame)
	var ball := world.balls[0]
	for line in lines:
		var gap := line.closest_point(ball.position).distance_to(ball.position) - ball.radius
		assert_between(gap, -1e-9, EventMover.UNSEEN_HEIGHT)
	assert_eq(world.is_lost[0], 0)


func test_other_balls_move_on_beside_a_jammed_one() -> void:
	var world := SteppedWorlds.world(
		[Vector4(-50, 5, 50, 5), Vector4(-50, -5, 50, -5)] as Array[Vector4],
		Ball.new(Vec2.new(), 5.0, Vec2.new(0.0, 1000.0))
	)
	world.mover = EventMover.new()
	var free := Ball.new(Vec2.new(0.0, 100.0), 5.0, Vec2.new(60.0, 0.0))
	assert_eq(world.set_balls([world.balls[0], free]), "")
	assert_string_contains(world.step(FRAME), "impacts within a second")
	assert_vec2(world.balls[1].position, Vec2.new(1.0, 100.0), 1e-12)


func test_balls_do_not_touch_each_other() -> void:
	var world := _world(Vec2.new(60.0, 0.0))
	var other := Ball.new(Vec2.new(20.0, 0.0), 5.0, Vec2.new(-60.0, 0.0))
	assert_no_refusal(world.set_balls([world.balls[0], other]))
	for frame: int in 60:
		assert_no_refusal(world.step(FRAME))
	assert_vec2(world.balls[0].position, Vec2.new(60.0, 0.0), 1e-9)
	assert_vec2(world.balls[1].position, Vec2.new(-40.0, 0.0), 1e-9)


func _world(velocity: Vec2) -> SteppedWorld:
	var world := SteppedWorlds.world(BOX, Ball.new(Vec2.new(), 5.0, velocity))
	world.mover = EventMover.new()
	return world
