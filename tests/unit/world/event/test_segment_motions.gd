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
