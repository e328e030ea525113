extends LabTest
## Segments that move with a constant velocity, in the event world: the numbers of the lessons, and
## frames of reference.

const _FLOOR := Vector4(-900, 0, 900, 0)


# The lesson on platforms: -200 against +100.
func test_a_wall_that_comes_to_meet_the_ball_adds_twice_its_speed() -> void:
	for bounciness: float in [1.0, 0.5]:
		var ball := Ball.new(Vec2.new(100, 0), 10, Vec2.new(-200, 0))
		var world := EventWorlds.world([Vector4(0, -50, 0, 50)], [ball], Vec2.zero(), bounciness)
		assert_no_refusal(world.set_segment_motion(0, SegmentMotion.steady(Vec2.new(100, 0))))
		world.keeps_events = true
		assert_no_refusal(world.advance(0.5))
		assert_vec2(world.velocity(0), Vec2.new(100 + 300 * bounciness, 0), 1e-12)
		assert_eq(world.events.size(), 1)
		assert_almost_eq(world.events[0].time, 0.3, 1e-15)
		assert_vec2(world.events[0].point, Vec2.new(30, 0), 1e-13)
		assert_vec2(world.events[0].velocity_before, Vec2.new(-200, 0), 1e-13)
		assert_vec2(world.segment(0).start, Vec2.new(50, -50), 1e-13)


func test_a_wall_that_is_faster_than_the_ball_hits_it_from_behind() -> void:
	for speed: float in [150.0, 1e9]:
		var ball := Ball.new(Vec2.new(110, 0), 10, Vec2.new(50, 0))
		var world := EventWorlds.world([Vector4(0, -50, 0, 50)], [ball])
		assert_no_refusal(world.set_segment_motion(0, SegmentMotion.steady(Vec2.new(speed, 0))))
		assert_no_refusal(world.advance(1.5))
		assert_eq(world.impacts, 1)
		assert_almost_eq(world.velocity(0).x / (2.0 * speed - 50.0), 1.0, 1e-15)


func test_a_platform_carries_what_rests_on_it() -> void:
	for velocity: Vec2 in [Vec2.new(60, 0), Vec2.new(30, -80), Vec2.new(-10, 40)]:
		var ball := Ball.new(Vec2.new(0, -10), 10, velocity)
		var world := EventWorlds.world([_FLOOR], [ball], Vec2.new(0, 500), 0.5)
		assert_no_refusal(world.set_segment_motion(0, SegmentMotion.steady(velocity)))
		assert_no_refusal(world.advance(0.0))
		assert_true(world.is_resting(0))
		for step: int in 7:
			assert_no_refusal(world.advance(0.3))
			var way := velocity.scaled(world.time)
			assert_vec2(world.position(0), way.plus(Vec2.new(0, -10)), 1e-11)
			assert_vec2(world.velocity(0), velocity, 1e-12)


func test_a_ball_that_falls_on_a_lift_comes_to_rest_on_it() -> void:
	var world := EventWorlds.world(
		[_FLOOR], [Ball.new(Vec2.new(0, -100), 10)], Vec2.new(0, 500), 0.5
	)
	assert_no_refusal(world.set_friction(0.3))
	assert_no_refusal(world.set_segment_motion(0, SegmentMotion.steady(Vec2.new(50, -100))))
	assert_no_refusal(world.advance(4.0))
	assert_true(world.is_resting(0))
	assert_almost_eq(world.position_y(0), -410.0, 1e-9)
	# It was at rest, and rolls at two thirds of the difference less.
	assert_true(world.is_rolling(0))
	assert_almost_eq(world.velocity(0).x, 50.0 / 3.0, 1e-10)
	assert_almost_eq(world.velocity(0).y, -100.0, 1e-12)


# Belt 90, disc put on at rest: ends at 30.
func test_a_disc_on_a_belt_ends_at_a_third_of_its_speed() -> void:
	for moved: float in [0.0, 40.0]:
		var ball := Ball.new(Vec2.new(-600, -20), 20, Vec2.new(moved, 0))
		var world := EventWorlds.world([_FLOOR], [ball], Vec2.new(0, 600), 0.5)
		assert_no_refusal(world.set_friction(0.2))
		assert_no_refusal(world.set_belt_speed(0, 90.0))
		assert_no_refusal(world.set_segment_motion(0, SegmentMotion.steady(Vec2.new(moved, 0))))
		assert_no_refusal(world.advance(3.0))
		assert_true(world.is_rolling(0))
		assert_almost_eq(world.velocity(0).x - moved, 30.0, 1e-12)
		assert_almost_eq(world.spin(0), -60.0 / 20.0, 1e-13)


# A whole world that moves with its segments is the same world, seen from elsewhere.
func test_a_world_whose_segments_all_move_alike_does_the_same() -> void:
	for friction: float in [0.0, 0.3]:
		for bounciness: float in [1.0, 0.7]:
			for gravity: float in [0.0, 400.0]:
				_compare_frames(friction, bounciness, gravity, Vec2.new(37, -23))


func _compare_frames(friction: float, bounciness: float, gravity: float, wind: Vec2) -> void:
	var worlds: Array[EventWorld] = []
	for velocity: Vec2 in [Vec2.zero(), wind]:
		var lines: Array[Vector4] = [Vector4(-100, 100, 0, 120), Vector4(0, 120, 100, 90)]
		lines.append_array([Vector4(-100, 100, -90, -100), Vector4(100, 90, 95, -100)])
		lines.append_array([Vector4(-90, -100, 95, -100), Vector4(-20, 20, 20, 30)])
		var start := Vec2.new(30, -60)
		var ball := Ball.new(start, 8, Vec2.new(170, 40).plus(velocity), 1.0, 6.0)
		var world := EventWorlds.world(lines, [ball], Vec2.new(0, gravity), bounciness)
		assert_no_refusal(world.set_friction(friction))
		for place: int in lines.size():
			assert_no_refusal(world.set_segment_motion(place, SegmentMotion.steady(velocity)))
		worlds.append(world)
	var errors: PackedFloat64Array = []
	while worlds[0].impacts < 100 and worlds[0].time < 10.0:
		for world: EventWorld in worlds:
			assert_no_refusal(world.advance(0.125))
		var way := wind.scaled(worlds[0].time)
		errors.append(worlds[1].position(0).minus(way).distance_to(worlds[0].position(0)))
		errors.append(absf(worlds[1].spin(0) - worlds[0].spin(0)))
	assert_eq(worlds[1].impacts, worlds[0].impacts)
	var message := "µ %s, C %s, g %s" % [friction, bounciness, gravity]
	assert_all_at_most(errors, 1e-9, message)


# h0 200, u0 300, V 100: way left 200 / (n + 1), speed 300 + 200 n, crushed at 2 s.
func test_a_press_squeezes_a_ball_until_it_is_crushed() -> void:
	var ball := Ball.new(Vec2.new(10, 0), 10, Vec2.new(300, 0))
	var lines: Array[Vector4] = [Vector4(0, -50, 0, 50), Vector4(220, -50, 220, 50)]
	var world := EventWorlds.world(lines, [ball])
	assert_no_refusal(world.set_segment_motion(0, SegmentMotion.steady(Vec2.new(100, 0))))
	world.keeps_events = true
	assert_no_refusal(world.advance(1.9895))
	var bounces := 0
	for event: WorldEvent in world.events:
		if event.other == 0:
			bounces += 1
			assert_almost_eq(event.velocity_after.x, 300.0 + 200.0 * bounces, 1e-9)
			assert_almost_eq(200.0 - 100.0 * event.time, 200.0 / (bounces + 1), 1e-9)
	assert_eq(bounces, 189)
	assert_false(world.is_crushed(0))
	assert_no_refusal(world.advance(1.0))
	assert_true(world.is_crushed(0))
	assert_false(world.has_ball(0))
	var last := world.events[-1]
	assert_eq(last.kind, WorldEvent.Kind.CRUSHED)
	assert_almost_eq(last.time, 2.0, 1e-12)
	assert_vec2(world.position(0), Vec2.new(210, 0), 1e-9)
	assert_eq(world.next_event_time(), INF)


func test_a_ceiling_that_comes_down_crushes_what_lies_below_it() -> void:
	for friction: float in [0.0, 0.4]:
		for bounciness: float in [0.0, 0.5, 1.0]:
			var ball := Ball.new(Vec2.new(0, -10), 10)
			var lines: Array[Vector4] = [_FLOOR, Vector4(-50, -120, 50, -120)]
			var world := EventWorlds.world(lines, [ball], Vec2.new(0, 500), bounciness)
			assert_no_refusal(world.set_friction(friction))
			assert_no_refusal(world.set_segment_motion(1, SegmentMotion.steady(Vec2.new(0, 50))))
			world.keeps_events = true
			assert_no_refusal(world.advance(5.0))
			assert_true(world.is_crushed(0))
			assert_eq(world.events[-1].kind, WorldEvent.Kind.CRUSHED)
			assert_almost_eq(world.events[-1].time, 2.0, 1e-12)


func test_a_wall_of_any_speed_lets_no_ball_through() -> void:
	for speed: float in [1.0, 1e3, 1e6, 1e9]:
		for bounciness: float in [0.0, 0.6, 1.0]:
			var ball := Ball.new(Vec2.new(60, 0), 10, Vec2.new(-7, 0))
			var lines: Array[Vector4] = [Vector4(0, -50, 0, 50), Vector4(220, -50, 220, 50)]
			var world := EventWorlds.world(lines, [ball], Vec2.zero(), bounciness)
			assert_no_refusal(world.set_segment_motion(0, SegmentMotion.steady(Vec2.new(speed, 0))))
			world.keeps_events = true
			assert_no_refusal(world.advance(300.0 / speed))
			assert_true(world.is_crushed(0))
			assert_almost_eq(world.events[-1].time * speed, 200.0, 1e-9)


func test_a_lift_that_turns_lets_a_ball_fly_and_catches_it() -> void:
	var motion := SegmentMotion.along(
		[0.0, 1.0, 2.0, 3.0], [Vec2.zero(), Vec2.new(0, -100), Vec2.zero(), Vec2.new(60, 0)]
	)
	var world := EventWorlds.world(
		[_FLOOR], [Ball.new(Vec2.new(0, -10), 10)], Vec2.new(0, 500), 0.0
	)
	assert_no_refusal(world.set_segment_motion(0, motion))
	assert_no_refusal(world.advance(0.5))
	assert_vec2(world.position(0), Vec2.new(0, -60), 1e-12)
	assert_true(world.is_resting(0))
	# At 1 s it is left behind with 200 px/s, and comes back after 0.8 s.
	assert_no_refusal(world.advance(1.0))
	assert_false(world.is_resting(0))
	assert_vec2(world.position(0), Vec2.new(0, -110 - 50 + 62.5), 1e-12)
	assert_no_refusal(world.advance_to(1.9))
	assert_true(world.is_resting(0))
	assert_vec2(world.position(0), Vec2.new(0, -20), 1e-12)
	# At 2 s it is hit from below, and without bounciness taken along.
	assert_no_refusal(world.advance_to(2.5))
	assert_true(world.is_resting(0))
	assert_vec2(world.position(0), Vec2.new(0, -10), 1e-12)
	assert_vec2(world.segment(0).start, Vec2.new(-870, 0), 1e-12)
	assert_no_refusal(world.advance_to(9.0))
	assert_vec2(world.position(0), Vec2.new(0, -10), 1e-12)
	assert_vec2(world.segment(0).start, Vec2.new(-840, 0), 1e-12)


func test_a_platform_that_goes_to_and_fro_carries_a_ball_by_friction() -> void:
	var motion := SegmentMotion.along(
		[0.0, 1.0, 2.0], [Vec2.zero(), Vec2.new(60, 0), Vec2.zero()], true
	)
	var world := EventWorlds.world(
		[_FLOOR], [Ball.new(Vec2.new(0, -10), 10)], Vec2.new(0, 500), 0.5
	)
	assert_no_refusal(world.set_friction(0.5))
	assert_no_refusal(world.set_segment_motion(0, motion))
	assert_no_refusal(world.advance(0.9))
	# It rolls as on a belt of 60 px/s.
	assert_almost_eq(world.velocity(0).x, 20.0, 1e-12)
	assert_almost_eq(world.spin(0), -4.0, 1e-12)
	assert_no_refusal(world.advance(1.0))
	assert_almost_eq(world.velocity(0).x, -20.0, 1e-12)
	assert_no_refusal(world.advance(400.0))
	assert_true(world.is_resting(0))
	assert_almost_eq(world.position_y(0), -10.0, 1e-12)


# What a path does piece by piece, flown as changes from outside.
func test_a_ball_meets_a_path_as_if_each_piece_were_given_anew() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 5
	for number: int in 40:
		var times: PackedFloat64Array = [0.0, 0.5, 0.75, 1.5]
		var ways: Array[Vec2] = [Vec2.zero()]
		for place: int in 3:
			ways.append(Vec2.random_unit(rng).scaled(rng.randf_range(0, 120)))
		var line := Vector4(-60, 40, 60, rng.randf_range(20, 60))
		var ball := Ball.new(Vec2.new(rng.randf_range(-50, 50), -40), 8, Vec2.new(0, 120))
		var whole := EventWorlds.world([line], [ball], Vec2.new(0, 200), 0.8)
		var cut := EventWorlds.world([line], [ball], Vec2.new(0, 200), 0.8)
		assert_no_refusal(whole.set_segment_motion(0, SegmentMotion.along(times, ways)))
		for place: int in 3:
			var seconds := times[place + 1] - times[place]
			var velocity := ways[place + 1].minus(ways[place]).divided(seconds)
			assert_no_refusal(cut.set_segment_motion(0, SegmentMotion.steady(velocity)))
			assert_no_refusal(cut.advance_to(times[place + 1]))
		assert_no_refusal(whole.advance_to(1.5))
		assert_vec2(whole.segment(0).end, cut.segment(0).end, 1e-11)
		assert_vec2(whole.position(0), cut.position(0), 1e-9)


func test_short_and_long_steps_and_a_snapshot_give_the_same_bits() -> void:
	var long := _busy_world()
	var short := _busy_world()
	for step: int in 256:
		assert_no_refusal(short.advance(1.0 / 64.0))
	assert_no_refusal(long.advance(1.5))
	var kept := long.snapshot()
	assert_no_refusal(long.advance(2.5))
	assert_eq(EventWorlds.numbers(long), EventWorlds.numbers(short))
	assert_no_refusal(long.restore(kept))
	assert_eq(long.time, 1.5)
	assert_no_refusal(long.advance(2.5))
	assert_eq(EventWorlds.numbers(long), EventWorlds.numbers(short))
	assert_gt(long.impacts, 30)


static func _busy_world() -> EventWorld:
	var lines: Array[Vector4] = [_FLOOR, Vector4(-200, -300, 200, -260), Vector4(-60, -90, 60, -90)]
	lines.append(Vector4(-300, 0, -300, -400))
	lines.append(Vector4(300, 0, 300, -400))
	var balls: Array[Ball] = []
	for index: int in 5:
		balls.append(Ball.new(Vec2.new(60 * index - 130, -140), 9, Vec2.new(40, 0), 1.0, 3.0))
	var world := EventWorlds.world(lines, balls, Vec2.new(0, 400), 0.8)
	Refusal.push(world.set_friction(0.3))
	Refusal.push(world.set_belt_speed(0, 70.0))
	Refusal.push(world.set_segment_motion(1, SegmentMotion.turning(Vec2.new(0, -280), 3.0)))
	var motion := SegmentMotion.along(
		[0.0, 0.4, 1.0], [Vec2.zero(), Vec2.new(60, -40), Vec2.zero()], true
	)
	Refusal.push(world.set_segment_motion(2, motion))
	return world


# Turned by a quarter, the paddle meets the ball with 100 px times 2 rad/s = 200 px/s upwards.
func test_a_paddle_meets_the_ball_as_fast_as_the_touched_point_moves() -> void:
	var ball := Ball.new(Vec2.new(100, -10), 10)
	var world := EventWorlds.world([Vector4(0, 0, 0, 150)], [ball])
	assert_no_refusal(world.set_segment_motion(0, SegmentMotion.turning(Vec2.zero(), -2.0)))
	world.keeps_events = true
	assert_no_refusal(world.advance(1.0))
	assert_eq(world.events.size(), 1)
	assert_almost_eq(world.events[0].time, PI / 4.0, 1e-15)
	assert_vec2(world.velocity(0), Vec2.new(0, -400), 1e-12)
	assert_vec2(world.surface_velocity(0, Vec2.new(3, 4)), Vec2.new(8, -6), 1e-14)


# What turns slowly under a ball: it hops, too low to be seen, and slides down as it gets steeper.
func test_a_ball_on_a_segment_that_turns_hops_and_time_goes_on() -> void:
	for friction: float in [0.0, 0.5]:
		for bounciness: float in [0.0, 0.5, 1.0]:
			var world := EventWorlds.world(
				[Vector4(-200, 0, 200, 0)],
				[Ball.new(Vec2.new(20, -10), 10)],
				Vec2.new(0, 500),
				bounciness
			)
			assert_no_refusal(world.set_friction(friction))
			var motion := SegmentMotion.turning(Vec2.zero(), 0.4)
			assert_no_refusal(world.set_segment_motion(0, motion))
			for step: int in 40:
				assert_no_refusal(world.advance(0.025))
				var gap := world.segment(0).closest_point(world.position(0))
				assert_between(gap.distance_to(world.position(0)) - 10.0, -1e-9, 0.08)
			assert_gt(world.position_x(0), 35.0)
			assert_lt(world.impacts, 500)


# The belt presses the ball on the floor and the floor on the belt, in ever faster touches.
func test_a_ball_between_a_belt_and_a_floor_hops_and_stays_outside() -> void:
	var ball := Ball.new(Vec2.new(132.311, 170), 13.9936, Vec2.new(0, 10), 1.0, -1.0)
	var world := EventWorlds.world([Vector4(118.317, 0, 118.317, 200)], [ball], Vec2.new(0, 600), 0)
	assert_no_refusal(world.set_friction(1.0))
	assert_no_refusal(world.set_walls(Vec2.zero(), Vec2.new(300, 200)))
	assert_no_refusal(world.set_belt_speed(0, 200.0))
	for step: int in 40:
		assert_no_refusal(world.advance(0.025))
		assert_gt(world.position_x(0), 118.317 + 13.9936 - 1e-9)
		assert_lt(world.position_y(0), 200.0 - 13.9936 + 1e-9)
	assert_lt(world.impacts, 2000)
