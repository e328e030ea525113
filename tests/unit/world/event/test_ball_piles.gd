extends LabTest
## Balls that come to lie in piles under gravity: see BallPiles.

const _GRAVITY := 500.0


func test_ten_balls_in_a_v_come_to_rest_after_few_impacts() -> void:
	for half: float in [30.0, 45.0, 60.0]:
		for bounciness: float in [0.0, 0.3, 0.6]:
			var world := _world_with_v(half, bounciness, _equal_balls(10))
			_assert_rests(world, 8.0, 15_000, "V of %s degrees, C = %s" % [half, bounciness])


func test_unequal_balls_in_a_v_come_to_rest() -> void:
	for half: float in [30.0, 45.0, 60.0]:
		var world := _world_with_v(half, 0.5, _unequal_balls(8))
		_assert_rests(world, 10.0, 20_000, "V of %s degrees" % half)


func test_balls_in_a_box_and_on_a_floor_come_to_rest() -> void:
	for half_width: float in [20.0, 40.0]:
		var world := _world_with_walls(half_width, 0.3, _equal_balls(9))
		_assert_rests(world, 10.0, 20_000, "box of %s px" % (2.0 * half_width))


func test_two_balls_in_a_steep_v_come_to_lie_where_they_are_in_balance() -> void:
	# One at the bottom, and the other one, which rolls off it, on one of the lines.
	for half: float in [30.0, 45.0]:
		for bounciness: float in [0.0, 0.3, 0.6]:
			var balls: Array[Ball] = [
				Ball.new(Vec2.new(-3.0, -60.0), 10.0), Ball.new(Vec2.new(3.0, -92.0), 10.0)
			]
			var world := _world_with_v(half, bounciness, balls)
			assert_eq(world.advance(8.0), "")
			assert_eq(_resting(world), 2)
			var apart := absf(world.position_y(1) - world.position_y(0))
			assert_almost_eq(apart, 20.0 * cos(deg_to_rad(half)), 0.05)


func test_the_energy_does_not_grow() -> void:
	var world := _world_with_v(45.0, 0.3, _equal_balls(6))
	# A hop of each of the 15 pairs, with half of the mass: see EnergyCheck.of_hops.
	var allowed := 15 * 0.5 * (_GRAVITY * BallPiles.LEAST_HOP) ** 2 / 8.0
	var lowest := world.energy()
	for step: int in 400:
		assert_eq(world.advance(0.01), "")
		assert_lt(world.energy(), lowest + allowed + 1e-6)
		lowest = minf(lowest, world.energy())


# The light one is between the heavy one and the round end of a line. They would meet again at the
# top of each hop, and so climb.
func test_balls_that_are_put_into_each_other_do_not_climb_out_by_hops() -> void:
	for depth: float in [0.5, 3.0, 10.0]:
		for angle: float in [-68.0, -45.0, -22.0]:
			var heavy := Ball.new(Vec2.new(0, -10), 10.0)
			var apart := Vec2.unit_degrees(angle).scaled(20.0 - depth)
			var light := Ball.new(heavy.position.plus(apart), 10.0, Vec2.zero(), 0.3)
			var end := light.position.plus(Vec2.new(9.6, 2.8))
			var lines: Array[Vector4] = [
				Vector4(-50, 0, 50, 0), Vector4(end.x, end.y, end.x + 30.0, end.y + 10.0)
			]
			var world := EventWorlds.world(lines, [heavy, light], Vec2.new(0, _GRAVITY), 0.0)
			assert_no_refusal(world.set_friction(0.2))
			var lowest := world.energy()
			for step: int in 200:
				assert_no_refusal(world.advance(0.005))
				assert_lt(world.energy(), lowest + 1e-9, "%s px, %s degrees" % [depth, angle])
				lowest = minf(lowest, world.energy())


func test_a_fast_ball_wakes_the_pile_and_a_slow_one_does_not() -> void:
	for speed: float in [3.0, 300.0]:
		var world := _world_with_v(45.0, 0.0, _equal_balls(4))
		assert_eq(world.advance(6.0), "")
		assert_eq(_resting(world), 4)
		var snapshot := world.positions()
		var top := world.position(0)
		for index: int in 4:
			if world.position_y(index) < top.y:
				top = world.position(index)
		# Just above the topmost ball, so that it has hardly time to fall.
		var above := Vec2.new(top.x, top.y - 20.001)
		assert_eq(world.add_ball(Ball.new(above, 10.0, Vec2.new(0.0, speed))), "")
		assert_eq(world.advance(0.5), "")
		var moved := 0.0
		for index: int in 4:
			moved = maxf(moved, absf(world.position_x(index) - snapshot[2 * index]))
		if speed > 100.0:
			assert_gt(moved, 0.1, "a fast ball moves the pile")
		else:
			assert_lt(moved, 0.1, "a slow one does not")


func test_a_lying_pile_takes_a_slow_ball_that_lands_on_it_later() -> void:
	var world := _world_with_v(45.0, 0.0, _equal_balls(3))
	assert_eq(world.advance(6.0), "")
	var count := world.impacts
	assert_eq(world.advance(1.0), "")
	assert_eq(world.impacts, count, "it lies")
	assert_eq(_resting(world), 3)


func test_without_one_of_the_lines_the_pile_falls() -> void:
	var world := _world_with_v(45.0, 0.3, _equal_balls(5))
	assert_eq(world.advance(8.0), "")
	assert_eq(_resting(world), 5)
	assert_eq(world.remove_segment(0), "")
	assert_eq(world.advance(1.0), "")
	for index: int in 5:
		assert_gt(world.velocity(index).length(), 100.0)


func test_nothing_hangs_in_the_air_when_what_was_below_is_gone() -> void:
	var world := _world_with_v(45.0, 0.3, _equal_balls(5))
	assert_eq(world.advance(8.0), "")
	var lowest := 0
	for index: int in 5:
		if world.position_y(index) > world.position_y(lowest):
			lowest = index
	var height := world.energy()
	assert_eq(world.remove_ball(lowest), "")
	assert_eq(world.advance(8.0), "")
	assert_lt(world.energy(), height, "the others have come down")
	assert_eq(_resting(world), 5 - 1 + int(world.is_resting(lowest)))


func test_kept_events_change_no_bit() -> void:
	var plain := _world_with_v(45.0, 0.3, _equal_balls(6))
	var kept := _world_with_v(45.0, 0.3, _equal_balls(6))
	kept.keeps_events = true
	for step: int in 40:
		assert_eq(plain.advance(0.1), "")
		assert_eq(kept.advance(0.1), "")
		assert_eq(kept.positions(), plain.positions())
	assert_eq(kept.impacts, plain.impacts)


func test_a_snapshot_of_a_pile_is_put_back_to_the_last_bit() -> void:
	var world := _world_with_v(45.0, 0.3, _equal_balls(6))
	assert_eq(world.advance(1.5), "")
	var snapshot := world.snapshot()
	assert_eq(world.advance(2.0), "")
	var places := world.positions()
	var impacts := world.impacts
	assert_eq(world.restore(snapshot), "")
	assert_eq(world.advance(2.0), "")
	assert_eq(world.positions(), places)
	assert_eq(world.impacts, impacts)


func test_slow_balls_on_a_floor_keep_their_momentum() -> void:
	var balls: Array[Ball] = [
		Ball.new(Vec2.new(-20.0, -10.0), 10.0, Vec2.new(3.0, 0.0)),
		Ball.new(Vec2.new(1.0, -10.0), 10.0)
	]
	var world := _world_with_walls(100.0, 0.5, balls)
	assert_eq(world.advance(5.0), "")
	assert_almost_eq(world.velocity(0).x + world.velocity(1).x, 3.0, 1e-12)
	assert_gt(world.velocity(1).x, 2.0, "they are not squeezed, however slow they are")


func test_balls_in_the_air_keep_their_momentum_where_they_collapse() -> void:
	# Three balls that lose speed in a row: they meet ever sooner, but nothing holds them.
	var balls: Array[Ball] = [
		Ball.new(Vec2.new(-30.0, 0.0), 10.0, Vec2.new(200.0, 0.0)),
		Ball.new(Vec2.new(0.0, 0.0), 10.0),
		Ball.new(Vec2.new(30.0, 0.0), 10.0, Vec2.new(-190.0, 0.0))
	]
	var world := _world(0.1)
	assert_eq(world.set_balls(balls), "")
	assert_eq(world.advance(1.0), "")
	var sum := 0.0
	for index: int in 3:
		sum += world.velocity(index).x
		assert_almost_eq(world.velocity(index).y, _GRAVITY, 1e-9)
	assert_almost_eq(sum, 10.0, 1e-9)


# Balls that fall one after the other, of the same size or of three sizes and masses.
func _stack(count: int, is_equal: bool) -> Array[Ball]:
	var balls: Array[Ball] = []
	for index: int in count:
		var at := Vec2.new(3.0 * (index % 3) - 3.0, -60.0 - 32.0 * index)
		var radius := 10.0 if is_equal else 6.0 + 4.0 * (index % 3)
		var mass := 1.0 if is_equal else 10.0 ** (index % 3 - 1)
		balls.append(Ball.new(at, radius, Vec2.zero(), mass))
	return balls


func _equal_balls(count: int) -> Array[Ball]:
	return _stack(count, true)


func _unequal_balls(count: int) -> Array[Ball]:
	return _stack(count, false)


func _world(bounciness: float) -> EventWorld:
	var world := EventWorld.new()
	world.most_impacts_per_second = 30_000
	assert_eq(world.set_gravity(Vec2.new(0.0, _GRAVITY)), "")
	assert_eq(world.set_bounciness(bounciness), "")
	return world


func _world_with_v(half_angle: float, bounciness: float, balls: Array[Ball]) -> EventWorld:
	var world := _world(bounciness)
	var one := Vec2.unit_degrees(-90.0 + half_angle).scaled(1000.0)
	var other := Vec2.unit_degrees(-90.0 - half_angle).scaled(1000.0)
	var lines: Array[LineSegment] = [
		LineSegment.new(Vec2.zero(), one), LineSegment.new(Vec2.zero(), other)
	]
	assert_eq(world.set_segments(lines), "")
	assert_eq(world.set_balls(balls), "")
	return world


func _world_with_walls(half_width: float, bounciness: float, balls: Array[Ball]) -> EventWorld:
	var world := _world(bounciness)
	var low := Vec2.new(-half_width, -1000.0)
	assert_eq(world.set_walls(low, Vec2.new(half_width, 0.0)), "")
	assert_eq(world.set_balls(balls), "")
	return world


func _resting(world: EventWorld) -> int:
	var count := 0
	for index: int in world.ball_count():
		count += int(world.is_resting(index))
	return count


# The deepest that two balls, or a ball and a line, are inside each other, in pixels.
func _deepest(world: EventWorld) -> float:
	var deepest := 0.0
	for one: int in world.ball_count():
		var ball := world.ball(one)
		for other: int in one:
			var second := world.ball(other)
			var gap := ball.position.distance_to(second.position)
			deepest = maxf(deepest, ball.radius + second.radius - gap)
		for place: int in world.segment_count():
			var nearest := world.segment(place).closest_point(ball.position)
			deepest = maxf(deepest, ball.radius - ball.position.distance_to(nearest))
	return deepest


# Rests within this time, and has cost no more impacts than this.
func _assert_rests(world: EventWorld, seconds: float, most_impacts: int, what: String) -> void:
	assert_eq(world.advance(seconds), "", what)
	assert_eq(_resting(world), world.ball_count(), what + ": all rest")
	assert_lt(world.impacts, most_impacts, what + ": impacts")
	assert_lt(_deepest(world), 1e-6, what + ": nothing has sunk in")
	var before := world.impacts
	assert_eq(world.advance(100.0), "", what)
	assert_eq(world.impacts, before, what + ": nothing happens any more")
