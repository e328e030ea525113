extends LabTest
## Spin and friction in the event world: the numbers of the lessons, and what stays as it is.

const _FLOOR := Vector4(-900, 0, 900, 0)


func test_a_ball_sticks_or_slips_as_the_lesson_says() -> void:
	# µ, spin before, speed and spin after.
	var rows: Array[PackedFloat64Array] = [
		[0.25, 0, 200, 10], [0.1, 0, 220, 8], [0, 0, 300, 0], [0.5, -30, 0, 0], [0.5, 15, 300, 15]
	]
	for row: PackedFloat64Array in rows:
		var ball := Ball.new(Vec2.new(-300, -220), 20, Vec2.new(300, 400), 1.0, row[1])
		for has_walls: bool in [false, true]:
			var lines: Array[Vector4] = []
			if not has_walls:
				lines = [_FLOOR]
			var world := _world(lines, [ball], 0.0, row[0], 1.0)
			if has_walls:
				assert_no_refusal(world.set_walls(Vec2.new(-900, -900), Vec2.new(900, 0)))
			assert_no_refusal(world.advance(0.75))
			assert_vec2(world.velocity(0), Vec2.new(row[2], -400), 1e-12)
			assert_almost_eq(world.spin(0), row[3], 1e-14)
			assert_almost_eq(world.angle(0), 0.5 * row[1] + 0.25 * row[3], 1e-14)


func test_friction_throws_a_pool_ball_aside() -> void:
	var one := Ball.new(Vec2.new(-157, -24), 20, Vec2.new(250, 0))
	var other := Ball.new(Vec2.zero(), 20)
	var world := _world([], [one, other], 0.0, 0.2, 1.0)
	assert_no_refusal(world.advance(0.6))
	assert_vec2(world.velocity(1), Vec2.new(175, 100), 1e-12)
	assert_vec2(world.velocity(0), Vec2.new(75, -100), 1e-12)
	# Both turn the same way round.
	assert_almost_eq(world.spin(0), 2.5, 1e-14)
	assert_almost_eq(world.spin(1), 2.5, 1e-14)


func test_three_balls_race_down_a_slope_of_3_to_4() -> void:
	var speeds := {0.0: 360.0, 0.1: 312.0, 0.5: 240.0}
	for friction: float in speeds:
		var acceleration: float = speeds[friction]
		var world := _world([Vector4(0, 0, 96, 72)], [_above_slope()], 600.0, friction)
		world.keeps_events = true
		assert_no_refusal(world.advance(0.5))
		assert_almost_eq(world.velocity(0).length(), 0.5 * acceleration, 1e-11)
		assert_eq(world.is_rolling(0), friction == 0.5)
		assert_no_refusal(world.advance(0.6))
		var leave := world.events[-1]
		for event: WorldEvent in world.events:
			if event.kind == WorldEvent.Kind.LEAVE:
				leave = event
		assert_almost_eq(leave.time, sqrt(240.0 / acceleration), 1e-13)
		# A rolling ball turns by its way; one that slips by µ N of its 480 px/s².
		var turning := 12.0 if friction == 0.5 else 2.0 * friction * 480.0 / 20.0
		assert_almost_eq(leave.spin_before, turning * leave.time, 1e-12)


func test_on_the_level_it_rolls_at_two_thirds_after_a_while() -> void:
	var world := _world([_FLOOR], [Ball.new(Vec2.new(-800, -20), 20, Vec2.new(300, 0))], 600, 0.2)
	world.keeps_events = true
	assert_no_refusal(world.advance(0.5))
	assert_true(world.is_resting(0))
	assert_false(world.is_rolling(0))
	assert_no_refusal(world.advance(1.0))
	assert_true(world.is_rolling(0))
	assert_vec2(world.velocity(0), Vec2.new(200, 0), 1e-12)
	assert_almost_eq(world.spin(0), 10.0, 1e-14)
	var last := world.events[-1]
	assert_eq([last.kind, last.other], [WorldEvent.Kind.SLIP_ENDS, 0])
	assert_almost_eq(last.time, 300.0 / 360.0, 1e-14)
	# 3 s later it still rolls, and has turned by its way.
	var turned := world.angle(0)
	var at := world.position_x(0)
	assert_no_refusal(world.advance(3.0))
	assert_almost_eq(20.0 * (world.angle(0) - turned), world.position_x(0) - at, 1e-11)
	assert_almost_eq(world.position_x(0) - at, 600.0, 1e-11)


func test_where_spin_and_speed_end_together_it_stops() -> void:
	var ball := Ball.new(Vec2.new(-800, -20), 20, Vec2.new(300, 0), 1.0, -30.0)
	var world := _world([], [ball], 600.0, 0.2)
	assert_no_refusal(world.set_walls(Vec2.new(-900, -900), Vec2.new(900, 0)))
	assert_no_refusal(world.advance(2.6))
	assert_eq([world.velocity(0).x, world.velocity(0).y, world.spin(0)], [0.0, 0.0, 0.0])
	assert_eq(world.next_event_time(), INF)
	assert_vec2(world.position(0), Vec2.new(-425, -20), 1e-11)


func test_with_more_backspin_it_comes_back() -> void:
	var ball := Ball.new(Vec2.new(-800, -20), 20, Vec2.new(300, 0), 1.0, -60.0)
	var world := _world([_FLOOR], [ball], 600.0, 0.2)
	assert_no_refusal(world.advance(4.5))
	assert_vec2(world.velocity(0), Vec2.new(-200, 0), 1e-12)
	assert_true(world.is_rolling(0))


# About a point of the floor nothing turns the ball, however often it bounces before it rolls.
func test_a_ball_that_is_thrown_on_the_floor_rolls_at_two_thirds() -> void:
	for bounciness: float in [0.0, 0.3, 0.5, 0.8]:
		for friction: float in [0.05, 0.5, 2.0]:
			var ball := Ball.new(Vec2.new(-800, -120), 20, Vec2.new(150, 0), 1.0, -3.0)
			var world := _world([_FLOOR], [ball], 600.0, friction, bounciness)
			assert_no_refusal(world.advance(8.0))
			assert_true(world.is_rolling(0))
			assert_almost_eq(world.velocity(0).x, (2.0 * 150.0 - 60.0) / 3.0, 1e-10)
			assert_almost_eq(world.spin(0), 4.0, 1e-11)


func test_a_ball_rolls_over_a_seam_as_if_there_were_none() -> void:
	for pull: float in [600.0, 611.7, 333.3]:
		var gravity := Vec2.new(0.1 * pull, pull)
		var whole := EventWorlds.world([Vector4(0, 0, 960, 720)], [_above_slope()], gravity)
		var lines: Array[Vector4] = [Vector4(0, 0, 32, 24), Vector4(96, 72, 32, 24)]
		lines.append(Vector4(96, 72, 960, 720))
		var cut := EventWorlds.world(lines, [_above_slope()], gravity)
		cut.keeps_events = true
		for world: EventWorld in [whole, cut]:
			assert_no_refusal(world.set_friction(0.5))
			assert_no_refusal(world.advance(1.5))
		assert_vec2(cut.position(0), whole.position(0), 1e-10)
		assert_almost_eq(cut.spin(0), whole.spin(0), 1e-12)
		assert_eq(cut.events.size(), 2, "it touches and lies")
		assert_true(cut.is_rolling(0))


func test_on_a_round_end_there_is_no_friction() -> void:
	var ball := Ball.new(Vec2.new(-20, -10), 10, Vec2.new(20, 0), 1.0, 2.0)
	var world := _world([Vector4(-200, 0, 0, 0)], [ball], 500.0, 0.5)
	assert_no_refusal(world.advance(1.05))
	assert_true(world.is_resting(0) and not world.is_rolling(0))
	assert_gt(world.position_x(0), 0.1)
	assert_almost_eq(world.spin(0), 2.0, 1e-13)


# Friction at the floor presses it to the wall, and that at the wall lifts it: N = 600 / (1 + µ²) at
# the floor and µ N at the wall, and both work against the spin.
func test_a_ball_spins_in_a_corner_until_friction_has_stopped_it() -> void:
	var ball := Ball.new(Vec2.new(880, -20), 20, Vec2.zero(), 1.0, 30.0)
	var world := _world([], [ball], 600.0, 0.2)
	assert_no_refusal(world.set_walls(Vec2.new(-900, -900), Vec2.new(900, 0)))
	assert_no_refusal(world.advance(1.0))
	var turning := 2.0 * 0.2 * 600.0 * 1.2 / 1.04 / 20.0
	assert_almost_eq(world.spin(0), 30.0 - turning, 1e-12)
	assert_vec2(world.position(0), Vec2.new(880, -20), 0.0)
	assert_no_refusal(world.advance(2.0))
	assert_eq([world.spin(0), world.next_event_time()], [0.0, INF])
	assert_almost_eq(world.angle(0), 450.0 / turning, 1e-11)


# Friction alone would hold it there, in ever faster touches of both lines.
func test_a_ball_that_is_driven_into_a_narrow_wedge_comes_out() -> void:
	for bounciness: float in [0.0, 0.5, 1.0]:
		for friction: float in [0.1, 0.5, 2.0]:
			var lines: Array[Vector4] = [Vector4(0, 0, 500, 40), Vector4(0, 0, 500, -40)]
			var ball := Ball.new(Vec2.new(300, 3), 10, Vec2.new(-200, 20), 1.0, 5.0)
			var world := _world(lines, [ball], 0.0, friction, bounciness)
			world.most_impacts_per_second = 5000
			assert_no_refusal(world.advance(3.0))
			assert_gt(world.velocity(0).x, 0.0, "C = %s, µ = %s" % [bounciness, friction])


# Bounces take no speed from the ball there, but friction does.
func test_an_elastic_ball_that_friction_slows_down_in_a_wedge_comes_out() -> void:
	var driven := Ball.new(Vec2.new(-59, -71), 7, Vec2.new(-1, 0))
	var world := _world([Vector4(70, -16, -92.1, -75)], [driven], 300.0, 1.0, 1.0)
	# It pushes the ball into the wedge.
	var above := LineSegment.new(Vec2.new(100, 30), Vec2.new(-120, -115))
	assert_no_refusal(world.add_segment(above))
	assert_no_refusal(world.add_ball(Ball.new(Vec2.new(-89, -82.3), 7.67, Vec2.new(0, 1))))
	world.most_impacts_per_second = 20000
	assert_no_refusal(world.advance(1.0))


# With its last spin friction would take it off the wall, so slowly that no time passes.
func test_a_ball_comes_to_rest_on_a_round_end_and_a_wall() -> void:
	var ball := Ball.new(Vec2.new(10, 10), 4, Vec2.new(300, 0))
	var world := _world([Vector4(0, 130, 294, 120)], [ball], 300.0, 1.0, 0.03)
	assert_no_refusal(world.set_walls(Vec2.zero(), Vec2.new(300, 200)))
	world.most_impacts_per_second = 1000
	assert_no_refusal(world.advance(2.0))
	assert_vec2(world.position(0), Vec2.new(296, 120.0 - sqrt(12.0)), 1e-6)
	assert_eq([world.spin(0), world.next_event_time()], [0.0, INF])


func test_without_friction_the_spin_changes_nothing_and_stays() -> void:
	for gravity: float in [0.0, 500.0]:
		var plain := EventWorlds.gas(20, 5)
		var spinning := EventWorlds.gas(20, 5)
		for index: int in 20:
			var ball := spinning.ball(index)
			ball.spin = index - 7.5
			assert_no_refusal(spinning.change_ball(index, ball))
		for world: EventWorld in [plain, spinning]:
			assert_no_refusal(world.set_gravity(Vec2.new(0, gravity)))
			assert_no_refusal(world.set_bounciness(0.9))
			assert_no_refusal(world.advance(2.0))
		assert_eq(spinning.positions(), plain.positions())
		assert_eq([spinning.spin(3), spinning.angle(3)], [-4.5, -9.0])


func test_balls_keep_momentum_and_angular_momentum_and_lose_energy() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 12
	var balls: Array[Ball] = []
	for index: int in 25:
		var place := Vec2.new(40.0 * (index % 5), 40.0 * floorf(index / 5.0))
		var to_the_middle := Vec2.new(80, 80).minus(place)
		balls.append(Ball.new(place, 12, to_the_middle, rng.randf_range(1, 4)))
		balls[-1].spin = rng.randf_range(-20, 20)
	var world := _world([], balls, 0.0, 0.3, 1.0)
	var momentum := _momentum(world)
	var turning := _angular_momentum(world)
	var energy := world.energy()
	assert_no_refusal(world.advance(3.0))
	assert_gt(world.impacts, 40)
	assert_vec2(_momentum(world), momentum, 1e-10)
	assert_almost_eq(_angular_momentum(world), turning, 1e-7)
	assert_lt(world.energy(), 0.999 * energy)


func test_a_world_in_a_mirror_does_the_same() -> void:
	var lines: Array[Vector4] = [Vector4(-300, -60, 0, 0), Vector4(0, 0, 300, -100)]
	var mirrored: Array[Vector4] = [Vector4(300, -60, 0, 0), Vector4(0, 0, -300, -100)]
	var one := Ball.new(Vec2.new(-100, -80), 10, Vec2.new(50, 0), 1.0, 25.0)
	var other := Ball.new(Vec2.new(100, -80), 10, Vec2.new(-50, 0), 1.0, -25.0)
	var world := _world(lines, [one], 500.0, 0.3)
	var mirror := _world(mirrored, [other], 500.0, 0.3)
	for step: int in 40:
		assert_no_refusal(world.advance(0.05))
		assert_no_refusal(mirror.advance(0.05))
		assert_almost_eq(world.position_x(0), -mirror.position_x(0), 1e-7)
		assert_almost_eq(world.spin(0), -mirror.spin(0), 1e-8)


func test_a_snapshot_holds_spin_and_slip() -> void:
	var ball := Ball.new(Vec2.new(-800, -20), 20, Vec2.new(300, 0), 1.0, 1.0)
	var world := _world([_FLOOR], [ball], 600.0, 0.2)
	assert_no_refusal(world.advance(0.3))
	var kept := world.snapshot()
	var wanted := [_state_after(world, 0.1), _state_after(world, 2.0)]
	assert_no_refusal(world.restore(kept))
	assert_eq([_state_after(world, 0.1), _state_after(world, 2.0)], wanted)
	assert_no_refusal(world.set_friction(0.3))
	assert_string_contains(world.restore(kept), "was taken among other")


func test_short_steps_are_one_long_step() -> void:
	var lines: Array[Vector4] = [Vector4(-300, -60, 0, 0), Vector4(0, 0, 300, 10)]
	var ball := Ball.new(Vec2.new(-200, -80), 10, Vec2.new(50, 0), 1.0, 25.0)
	var long := _world(lines, [ball], 512.0, 0.3)
	var short := _world(lines, [ball], 512.0, 0.3)
	for step: int in 256:
		assert_no_refusal(short.advance(1.0 / 128.0))
	assert_eq(_state_after(long, 2.0), _state_after(short, 0.0))


func test_friction_that_is_taken_away_leaves_the_spin() -> void:
	var world := _world([_FLOOR], [Ball.new(Vec2.new(-800, -20), 20, Vec2.new(300, 0))], 600, 0.2)
	assert_no_refusal(world.advance(0.5))
	var spin := world.spin(0)
	assert_almost_eq(spin, 6.0, 1e-13)
	assert_no_refusal(world.set_friction(0.0))
	assert_no_refusal(world.advance(0.5))
	assert_eq(world.spin(0), spin)
	assert_almost_eq(world.velocity(0).x, 240.0, 1e-12)
	assert_almost_eq(world.angle(0), 1.5 + 3.0, 1e-12)


func test_a_changed_ball_keeps_its_angle_and_a_removed_one_turns_no_more() -> void:
	var world := _world([], [Ball.new(Vec2.zero(), 10, Vec2.zero(), 1.0, 4.0)], 0.0, 0.2)
	assert_no_refusal(world.advance(0.5))
	assert_no_refusal(world.change_ball(0, world.ball(0)))
	assert_no_refusal(world.advance(0.5))
	assert_eq([world.spin(0), world.angle(0)], [4.0, 4.0])
	assert_no_refusal(world.remove_ball(0))
	assert_no_refusal(world.advance(0.5))
	assert_eq([world.spin(0), world.angle(0)], [0.0, 4.0])
	assert_no_refusal(world.set_balls([Ball.new(Vec2.zero(), 10, Vec2.zero(), 1.0, 4.0)]))
	assert_eq(world.angle(0), 0.0)


func test_balls_that_lie_in_a_pile_do_not_spin() -> void:
	var balls: Array[Ball] = []
	for index: int in 3:
		balls.append(Ball.new(Vec2.new(20 + 20 * index, -10), 10, Vec2.zero(), 1.0, 9.0))
		balls.append(Ball.new(Vec2.new(30 + 20 * index, -40), 10, Vec2.zero(), 1.0, -9.0))
	var world := _world([], balls, 500.0, 0.4)
	assert_no_refusal(world.set_walls(Vec2.new(0, -300), Vec2.new(80, 0)))
	assert_no_refusal(world.advance(20.0))
	assert_eq(world.next_event_time(), INF)
	for index: int in 6:
		assert_eq(world.spin(index), 0.0)


func test_a_ball_that_lies_in_a_pile_takes_a_slow_push_without_turning_and_rubs() -> void:
	var balls: Array[Ball] = [
		Ball.new(Vec2.new(10, -10), 10),
		Ball.new(Vec2.new(30, -10), 10),
		Ball.new(Vec2.new(60, -10), 10, Vec2.new(-3, 0), 1.0, -0.3),
	]
	# The second one presses the first one to the wall.
	var world := EventWorlds.world([], balls, Vec2.new(-1, 500), 0.5)
	assert_no_refusal(world.set_walls(Vec2.new(0, -300), Vec2.new(800, 0)))
	assert_no_refusal(world.set_friction(0.4))
	world.keeps_events = true
	assert_no_refusal(world.advance(4.0))
	var pushes := world.events.filter(
		func(event: WorldEvent) -> bool:
			return event.kind == WorldEvent.Kind.BALL and event.ball == 2
	)
	assert_gt(pushes.size(), 0)
	var push: WorldEvent = pushes[0]
	assert_ne(push.spin_after, push.spin_before)
	assert_lt(push.velocity_after.y, 0.0)


# The upper ball presses the lower one on the floor, by hops: so the floor brakes both.
func test_the_floor_rubs_on_what_lies_on_it_with_all_that_it_bears() -> void:
	var balls: Array[Ball] = [
		Ball.new(Vec2.new(0, -10), 10, Vec2.new(300, 0)),
		Ball.new(Vec2.new(0, -30), 10, Vec2.new(300, 0))
	]
	var world := _world([_FLOOR], balls, 500.0, 0.2)
	assert_no_refusal(world.advance(0.1))
	assert_almost_eq(_momentum(world).x, 600.0 - 0.2 * 1000.0 * 0.1, 3.0)


func test_a_friction_that_cannot_be_is_refused() -> void:
	var world := EventWorld.new()
	for bad: float in [-0.1, 2e6, NAN]:
		var wanted := "The friction µ must be within 0..1000000, not %s." % bad
		assert_eq(world.set_friction(bad), wanted)
	assert_no_refusal(world.set_friction(1e6))
	assert_string_contains(
		world.add_ball(Ball.new(Vec2.zero(), 1, Vec2.zero(), 1.0, 2e15)), "A ball's spin must be"
	)


func _above_slope() -> Ball:
	return Ball.new(Vec2.new(12, -16), 20)


func _state_after(world: EventWorld, seconds: float) -> Array:
	assert_no_refusal(world.advance(seconds))
	return [EventWorlds.numbers(world), world.angle(0), world.next_event_time()]


static func _world(
	lines: Array[Vector4],
	balls: Array[Ball],
	gravity: float,
	friction: float,
	bounciness: float = 0.5
) -> EventWorld:
	var made := EventWorlds.world(lines, balls, Vec2.new(0, gravity), bounciness)
	Refusal.push(made.set_friction(friction))
	return made


static func _momentum(world: EventWorld) -> Vec2:
	var sum := Vec2.zero()
	for index: int in world.ball_count():
		var ball := world.ball(index)
		sum.add(ball.velocity.scaled(ball.mass))
	return sum


static func _angular_momentum(world: EventWorld) -> float:
	var sum := 0.0
	for index: int in world.ball_count():
		sum += Disc.angular_momentum(world.ball(index), Vec2.new(20, -30))
	return sum
