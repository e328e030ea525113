extends LabTest
## Balls that lie, slide, roll over an end or lie on each other: no ball sinks in, no step hangs.

const GRAVITY := 500.0


func test_a_ball_that_is_put_on_a_floor_lies_there() -> void:
	for bounciness: float in [0.0, 0.5, 1.0]:
		var world := _falling([Vector4(-90, 0, 900, 0)], [_ball(0, -10, 70, 0)], bounciness)
		assert_no_refusal(world.advance(2.0))
		assert_true(world.is_resting(0))
		assert_vec2(world.position(0), Vec2.new(140, -10), 1e-12)


func test_a_resting_ball_stays_on_its_line_whatever_is_changed() -> void:
	var gaps := PackedFloat64Array()
	for change: int in 100:
		var along := Vec2.unit_radians(-0.5 + change / 100.0)
		var line := LineSegment.new(along.scaled(-5000.0), along.scaled(5000.0))
		var world := _falling([], [Ball.new(along.normal().scaled(-37.0), 7.0)], 0.3)
		assert_no_refusal(world.add_segment(line))
		assert_no_refusal(world.advance(2.0))
		_change(world, change % 4, line)
		assert_no_refusal(world.advance(1.0))
		var nearest := line.closest_point(world.position(0))
		gaps.append(absf(nearest.distance_to(world.position(0)) - 7.0))
	assert_all_at_most(gaps, 1e-9)


func test_a_ball_that_slides_into_a_wall_stays_on_the_floor() -> void:
	var lines: Array[Vector4] = [Vector4(-900, 0, 100, 0), Vector4(100, 0, 100, -200)]
	var world := _falling(lines, [_ball(0, -10, 60, 0)], 0.5)
	assert_no_refusal(world.advance(3.5))
	assert_vec2(world.position(0), Vec2.new(30, -10), 1e-9)
	assert_true(world.is_resting(0))


func test_a_ball_comes_to_rest_between_two_slopes() -> void:
	for bounciness: float in [0.0, 0.5, 0.9]:
		var lines: Array[Vector4] = [Vector4(-200, -100, 0, 0), Vector4(0, 0, 200, -100)]
		var world := _falling(lines, [_ball(30, -150, 0, 0)], bounciness)
		assert_no_refusal(world.advance(30.0))
		var impacts := world.impacts
		assert_no_refusal(world.advance(10.0))
		assert_vec2(world.position(0), Vec2.new(0, -5.0 * sqrt(5.0)), 1e-4)
		assert_eq([world.impacts, world.next_event_time()], [impacts, INF])
		assert_eq([world.velocity(0).x, world.velocity(0).y], [0.0, 0.0])


func test_a_slow_ball_rolls_over_the_end_of_a_segment() -> void:
	var world := _falling([Vector4(-200, 0, 0, 0)], [_ball(-20, -10, 20, 0)], 0.5)
	world.keeps_events = true
	var distances := PackedFloat64Array()
	var energies := PackedFloat64Array()
	var energy := world.energy()
	for step: int in 1500:
		assert_no_refusal(world.advance(0.001))
		energies.append(absf(world.energy() / energy - 1.0))
		if world.position_x(0) > 0.0 and world.is_resting(0):
			distances.append(absf(world.position(0).length() - 10.0))
	assert_gt(distances.size(), 100)
	assert_all_at_most(distances, CapRolls.OFF_CIRCLE)
	assert_all_at_most(energies, 1e-6)
	# It leaves where gravity no longer presses it on the end: cos a = (v0^2 / (g R) + 2) / 3.
	var leave := world.events[-1]
	assert_eq(leave.kind, WorldEvent.Kind.LEAVE)
	assert_almost_eq(-leave.normal.y, (20.0 * 20.0 / (GRAVITY * 10.0) + 2.0) / 3.0, 1e-9)
	assert_almost_eq(leave.velocity_after.length_squared(), -leave.normal.y * GRAVITY * 10.0, 1e-6)


func test_a_fast_ball_flies_off_the_end_of_a_segment() -> void:
	# Following the round end would take 80^2 / 10 = 640 px/s^2, and gravity is 500 px/s^2.
	var world := _falling([Vector4(-200, 0, 0, 0)], [_ball(-40, -10, 80, 0)], 0.5)
	assert_no_refusal(world.advance(1.0))
	assert_vec2(world.position(0), Vec2.new(40, -10.0 + GRAVITY / 8.0), 1e-9)


func test_balls_on_top_of_each_other_neither_sink_in_nor_hang() -> void:
	for bounciness: float in [0.0, 0.5]:
		var balls: Array[Ball] = [_ball(0, -10, 0, 0), _ball(0, -30, 0, 0), _ball(0, -55, 0, 0)]
		var world := _falling([Vector4(-90, 0, 90, 0)], balls, bounciness)
		var overlaps := PackedFloat64Array()
		for step: int in 60:
			assert_eq(world.advance(1.0 / 60.0), "")
			overlaps.append(EventWorlds.deepest_overlap(world))
		assert_all_at_most(overlaps, 1e-9)
		assert_lt(world.impacts, 5000)
		assert_gt(world.position_y(2), -50.1)


func test_balls_that_lose_all_speed_do_not_meet_without_end() -> void:
	var balls: Array[Ball] = []
	for place: int in 5:
		balls.append(_ball(20.0 * place, 0, 50 - 20 * place, 0))
	var world := EventWorlds.world([], balls, Vec2.new(), 0.0)
	world.most_impacts_per_second = 1000
	assert_eq(world.advance(1.0), "")
	assert_lt(EventWorlds.deepest_overlap(world), 1e-9)


func test_a_ball_comes_to_rest_on_a_line_and_a_round_end() -> void:
	var lines: Array[Vector4] = [Vector4(-200, -100, 0, 0), Vector4(12, -15, 200, -15)]
	var world := _falling(lines, [_ball(-60, -60, 0, 0)], 0.3)
	assert_no_refusal(world.advance(30.0))
	assert_eq(world.next_event_time(), INF)
	assert_eq([world.velocity(0).x, world.velocity(0).y], [0.0, 0.0])
	assert_almost_eq(world.position(0).distance_to(Vec2.new(12, -15)), 10.0, 1e-6)


func test_a_light_ball_squeezed_into_a_corner_by_a_heavy_one_is_let_go() -> void:
	var lines: Array[Vector4] = [Vector4(100, -90, 100, 90), Vector4(-90, 90, 100, 90)]
	for trial: int in 20:
		var light := Ball.new(Vec2.new(89, 79), 10.0)
		var aim := Vec2.unit_degrees(40.0 + 0.5 * trial)
		var start := light.position.minus(aim.scaled(60.0))
		var heavy := Ball.new(start, 20.0, aim.scaled(120.0), 1e4)
		var world := EventWorlds.world(lines, [light, heavy], Vec2.new(), 0.5)
		world.most_impacts_per_second = 5000
		assert_eq(world.advance(2.0), "", "trial %d" % trial)
		assert_lt(EventWorlds.deepest_overlap(world), 1e-9)


# They overlap by 6 px. Each is in a corner of two lines that it could leave only through the other
# one, and no speed is lost.
func test_balls_that_lines_press_into_each_other_are_told_and_go_on_when_there_is_room() -> void:
	var one := Ball.new(Vec2.new(-98.7, -33), 11.8, Vec2.new(0, -1))
	var other := Ball.new(Vec2.new(-80, -10), 10.0)
	var world := EventWorlds.world([Vector4(-70, 30, -124, -49)], [one, other])
	world.most_impacts_per_second = 5000
	var above := LineSegment.new(Vec2.new(0, -40), Vec2.new(-100, -40))
	var aside := LineSegment.new(Vec2.new(-80, 0), Vec2.new(-70, -70))
	assert_no_refusal(world.add_segment(above))
	assert_no_refusal(world.add_segment(aside))
	assert_string_starts_with(world.advance(2.0), "There are more than 5000 impacts")
	assert_almost_eq(world.energy(), 0.5, 1e-9)
	assert_no_refusal(world.remove_segment(2))
	assert_no_refusal(world.advance(2.0))


func test_a_centre_on_a_line_is_stopped_once() -> void:
	var world := EventWorlds.world([Vector4(-90, 0, 90, 0)], [_ball(3, 0, 7, 8)])
	assert_no_refusal(world.advance(2.0))
	assert_vec2(world.position(0), Vec2.new(17, -16), 0.0)
	assert_eq(world.impacts, 1)


func test_a_ball_that_is_driven_into_a_wedge_comes_out() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 4
	for trial: int in 200:
		var half := rng.randf_range(0.01, 1.5)
		var turn := rng.randf_range(0.0, TAU)
		var one := Vec2.unit_radians(turn + half).scaled(500.0)
		var other := Vec2.unit_radians(turn - half).scaled(500.0)
		var lines: Array[Vector4] = [Vector4(0, 0, one.x, one.y), Vector4(0, 0, other.x, other.y)]
		var pull := Vec2.new(0, 300.0 * (trial % 2))
		var bounciness: float = [1.0, 0.5, 0.0, 0.9, 0.99][trial % 5]
		var way := rng.randf_range(1.0, 100.0)
		var start := Vec2.unit_radians(turn).scaled(10.0 / sin(half) + way)
		var aim := turn + rng.randf_range(-0.5, 0.5) * half
		var ball := Ball.new(start, 10.0, Vec2.unit_radians(aim).scaled(-rng.randf_range(10, 3000)))
		var world := EventWorlds.world(lines, [ball], pull, bounciness)
		world.most_impacts_per_second = 20000
		assert_eq(world.advance(2.0), "", "trial %d" % trial)


func test_a_ball_between_two_round_ends_comes_to_rest() -> void:
	for bounciness: float in [0.0, 0.3, 0.5]:
		var lines: Array[Vector4] = [Vector4(-90, 0, -8, 0), Vector4(8, 0, 90, -30)]
		var world := _falling(lines, [_ball(40, -40, 0, 0)], bounciness)
		world.most_impacts_per_second = 20000
		assert_no_refusal(world.advance(30.0))
		assert_true(world.is_resting(0), "C = %s" % bounciness)
		assert_vec2(world.position(0), Vec2.new(0, -6), 1e-4)


func test_with_c_1_a_ball_in_a_corner_lies_still() -> void:
	var world := EventWorlds.world([], [_ball(20, 20, 0, 0)], Vec2.new(400, 1), 0.0)
	assert_no_refusal(world.set_walls(Vec2.zero(), Vec2.new(100, 100)))
	assert_no_refusal(world.advance(60.0))
	assert_no_refusal(world.set_bounciness(1.0))
	assert_no_refusal(world.advance(1.0))
	assert_vec2(world.position(0), Vec2.new(90, 90), 1e-9)


func _falling(lines: Array[Vector4], balls: Array[Ball], bounciness: float) -> EventWorld:
	return EventWorlds.world(lines, balls, Vec2.new(0, GRAVITY), bounciness)


func _ball(x: float, y: float, velocity_x: float, velocity_y: float) -> Ball:
	return Ball.new(Vec2.new(x, y), 10.0, Vec2.new(velocity_x, velocity_y))


func _change(world: EventWorld, kind: int, line: LineSegment) -> void:
	match kind:
		0:
			assert_no_refusal(world.set_gravity(Vec2.new(30, 400)))
		1:
			assert_no_refusal(world.move_segment(0, line))
		2:
			assert_no_refusal(world.change_ball(0, world.ball(0)))
		3:
			assert_no_refusal(world.set_walls(Vec2.new(-1e6, -1e6), Vec2.new(1e6, 1e6)))


func test_a_ball_that_flies_off_a_cap_meets_the_line_of_its_segment_as_fast_as_it_comes() -> void:
	# Before that it has left the line itself with 150 px/s.
	var world := EventWorlds.world(
		[Vector4(73, 1, -180, -65), Vector4(113, -70, 125, 0)],
		[Ball.new(Vec2.new(-37, -74.3), 4.0)],
		Vec2.new(0, 300)
	)
	world.keeps_events = true
	assert_no_refusal(world.advance_to(2.1))
	assert_no_refusal(world.set_bounciness(0.0))
	world.events.clear()
	assert_no_refusal(world.advance_to(2.5))
	assert_gt(world.events.size(), 1)
	for event: WorldEvent in world.events:
		var before := event.velocity_before.length()
		assert_lt(event.velocity_after.length(), before * (1.0 + 1e-12), str(event.time))
