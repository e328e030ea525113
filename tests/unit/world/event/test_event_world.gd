extends LabTest
## Balls among segments and walls, from event to event.


func test_a_ball_in_a_box_is_where_unfolding_says() -> void:
	var errors := PackedFloat64Array()
	for speed: float in [300.0, 3000.0, 30000.0]:
		var velocity := Vec2.unit_radians(0.7).scaled(speed)
		var world := EventWorld.new()
		assert_no_refusal(world.set_walls(Vec2.zero(), Vec2.new(600, 400)))
		assert_no_refusal(world.set_balls([Ball.new(Vec2.new(100, 100), 10, velocity)]))
		for frame: int in 6000:
			assert_no_refusal(world.advance(1.0 / 60.0))
		var seconds := DoubleDouble.product_of(1.0 / 60.0, 6000.0)
		var x := _unfolded(100, velocity.x, seconds, 10, 590)
		var y := _unfolded(100, velocity.y, seconds, 10, 390)
		errors.append(world.position(0).distance_to(Vec2.new(x, y)))
	assert_all_at_most(errors, 1e-9)


func test_four_segments_keep_a_ball_as_walls_do() -> void:
	var lines: Array[Vector4] = [
		Vector4(0, 0, 600, 0),
		Vector4(600, 0, 600, 400),
		Vector4(600, 400, 0, 400),
		Vector4(0, 400, 0, 0)
	]
	var ball := Ball.new(Vec2.new(100, 100), 10, Vec2.new(229, 193))
	var among := EventWorlds.world(lines, [ball])
	var within := EventWorld.new()
	assert_no_refusal(within.set_walls(Vec2.zero(), Vec2.new(600, 400)))
	assert_no_refusal(within.set_balls([ball]))
	assert_no_refusal(among.advance(40.0))
	assert_no_refusal(within.advance(40.0))
	assert_vec2(among.position(0), within.position(0), 1e-11)
	assert_eq(among.impacts, within.impacts)


func test_one_long_step_and_many_short_ones_give_the_same_bits() -> void:
	var long := EventWorlds.gas(30, 4)
	var short := EventWorlds.gas(30, 4)
	assert_no_refusal(long.advance(2.0))
	for step: int in 512:
		assert_no_refusal(short.advance(1.0 / 256.0))
	assert_true(EventWorlds.numbers(long) == EventWorlds.numbers(short))
	assert_gt(long.impacts, 30)


func test_balls_keep_energy_and_momentum_and_never_overlap() -> void:
	for mixed: bool in [false, true]:
		var world := EventWorlds.gas(60, 9, mixed)
		var energy := world.energy()
		var overlaps := PackedFloat64Array()
		for step: int in 40:
			assert_no_refusal(world.advance(0.125))
			overlaps.append(EventWorlds.deepest_overlap(world))
		assert_almost_eq(world.energy() / energy, 1.0, 1e-13)
		assert_all_at_most(overlaps, 1e-11)


func test_neighbour_cells_and_all_pairs_give_the_same_flight() -> void:
	var all := EventWorlds.gas(15, 2)
	var cells := EventWorlds.gas(15, 2)
	# A sixteenth ball far outside makes the world use cells.
	cells.remove_walls()
	all.remove_walls()
	assert_no_refusal(cells.add_ball(Ball.new(Vec2.new(1e6, 1e6), 10)))
	assert_no_refusal(all.advance(5.0))
	assert_no_refusal(cells.advance(5.0))
	var wanted := EventWorlds.numbers(all)
	assert_true(EventWorlds.numbers(cells).slice(0, wanted.size()) == wanted)
	assert_gt(all.impacts, 3)


func test_two_balls_of_mass_1_and_2_bounce_as_the_course_says() -> void:
	var one := Ball.new(Vec2.new(0, 0), 5, Vec2.new(6, 0), 1)
	var other := Ball.new(Vec2.new(22, 0), 5, Vec2.new(), 2)
	for row: Vector3 in [Vector3(1, -2, 4), Vector3(0.5, 0, 3), Vector3(0, 2, 2)]:
		var world := EventWorlds.world([], [one, other], Vec2.new(), row.x)
		assert_no_refusal(world.advance(2.5))
		assert_vec2(world.velocity(0), Vec2.new(row.y, 0), 1e-14)
		assert_vec2(world.velocity(1), Vec2.new(row.z, 0), 1e-14)


func test_a_change_is_seen_at_once() -> void:
	var world := EventWorlds.world([], [Ball.new(Vec2.new(0, 0), 5, Vec2.new(10, 0))])
	assert_no_refusal(world.advance(1.0))
	assert_eq(world.segment_count(), 0)
	assert_no_refusal(world.add_segment(LineSegment.new(Vec2.new(25, -10), Vec2.new(25, 10))))
	assert_eq(world.segment_count(), 1)
	assert_no_refusal(world.advance(2.0))
	assert_vec2(world.position(0), Vec2.new(10, 0), 1e-14)
	assert_no_refusal(world.remove_segment(0))
	assert_no_refusal(world.change_ball(0, Ball.new(Vec2.new(10, 0), 5, Vec2.new(10, 0))))
	assert_no_refusal(world.advance(2.0))
	assert_vec2(world.position(0), Vec2.new(30, 0), 1e-14)


func test_a_moved_segment_is_met_at_its_new_place() -> void:
	var world := EventWorlds.world(
		[Vector4(25, -10, 25, 10)], [Ball.new(Vec2.new(0, 0), 5, Vec2.new(10, 0))]
	)
	assert_no_refusal(world.advance(1.0))
	assert_no_refusal(world.move_segment(0, LineSegment.new(Vec2.new(45, -10), Vec2.new(45, 10))))
	assert_no_refusal(world.advance(4.0))
	assert_vec2(world.position(0), Vec2.new(30, 0), 1e-14)


func test_a_removed_ball_is_met_by_none() -> void:
	var balls: Array[Ball] = [
		Ball.new(Vec2.new(0, 0), 5, Vec2.new(10, 0)), Ball.new(Vec2.new(50, 0), 5)
	]
	var world := EventWorlds.world([], balls)
	assert_no_refusal(world.advance(1.0))
	assert_no_refusal(world.remove_ball(1))
	assert_no_refusal(world.advance(9.0))
	assert_vec2(world.position(0), Vec2.new(100, 0), 1e-13)
	assert_eq([world.has_ball(1), world.ball_count(), world.impacts], [false, 2, 0])


func test_a_ball_added_in_the_way_is_met() -> void:
	var world := EventWorlds.world([], [Ball.new(Vec2.new(0, 0), 5, Vec2.new(10, 0))])
	assert_no_refusal(world.advance(1.0))
	assert_no_refusal(world.add_ball(Ball.new(Vec2.new(40, 0), 5)))
	assert_no_refusal(world.advance(3.0))
	assert_vec2(world.position(0), Vec2.new(30, 0), 1e-14)
	assert_vec2(world.position(1), Vec2.new(50, 0), 1e-14)


func test_a_snapshot_is_put_back_to_the_last_bit() -> void:
	var world := EventWorlds.gas(40, 6)
	assert_no_refusal(world.advance(0.7))
	var kept := world.snapshot()
	assert_no_refusal(world.advance(1.1))
	var wanted := EventWorlds.numbers(world)
	assert_eq(world.restore(kept), "")
	assert_eq(world.time, 0.7)
	assert_no_refusal(world.advance(1.1))
	assert_true(EventWorlds.numbers(world) == wanted)


func test_a_snapshot_is_put_back_when_the_cells_have_been_laid_out_anew() -> void:
	for count: int in [15, 16, 40]:
		var world := EventWorlds.gas(count, 6, true)
		assert_no_refusal(world.advance(0.7))
		var kept := world.snapshot()
		assert_no_refusal(world.advance(1.1))
		var wanted := EventWorlds.numbers(world)
		# Add a ball that needs larger cells; then leave only two balls.
		assert_no_refusal(world.add_ball(Ball.new(Vec2.new(60, 60), 50)))
		assert_no_refusal(world.advance(0.3))
		if count == 40:
			assert_no_refusal(
				world.set_balls([Ball.new(Vec2.new(60, 60), 5), Ball.new(Vec2.new(90, 60), 5)])
			)
		assert_eq(world.restore(kept), "")
		assert_no_refusal(world.advance(1.1))
		assert_true(EventWorlds.numbers(world) == wanted, "%d balls" % count)


func test_a_snapshot_of_other_surroundings_is_refused() -> void:
	var world := EventWorlds.gas(3, 6)
	var kept := world.snapshot()
	assert_no_refusal(world.add_segment(LineSegment.new(Vec2.new(1, 1), Vec2.new(9, 1))))
	assert_no_refusal(world.advance(0.5))
	assert_string_contains(world.restore(kept), "taken among other segments")
	assert_eq(world.time, 0.5)


func test_events_tell_who_where_and_how_fast() -> void:
	var world := EventWorlds.world(
		[Vector4(30, -10, 30, 10)], [Ball.new(Vec2.new(0, 0), 5, Vec2.new(10, 2))]
	)
	world.keeps_events = true
	assert_no_refusal(world.advance(3.0))
	assert_eq(world.events.size(), 1)
	var event := world.events[0]
	assert_eq(
		[event.time, event.ball, event.kind, event.other], [2.5, 0, WorldEvent.Kind.SEGMENT, 0]
	)
	assert_vec2(event.point, Vec2.new(30, 5), 1e-14)
	assert_vec2(event.normal, Vec2.new(-1, 0), 0.0)
	assert_vec2(event.velocity_before, Vec2.new(10, 2), 0.0)
	assert_vec2(event.velocity_after, Vec2.new(-10, 2), 1e-14)


func test_the_walls_are_told_by_number() -> void:
	var world := EventWorlds.gas(1, 1)
	world.keeps_events = true
	assert_no_refusal(world.change_ball(0, Ball.new(Vec2.new(20, 20), 10, Vec2.new(-10, 0))))
	assert_no_refusal(world.advance(1.5))
	assert_no_refusal(world.change_ball(0, Ball.new(Vec2.new(20, 20), 10, Vec2.new(0, -10))))
	assert_no_refusal(world.advance(1.5))
	assert_eq(world.events.map(func(event: WorldEvent) -> int: return event.other), [0, 2])
	assert_eq(world.events[0].kind, WorldEvent.Kind.WALL)


func test_two_balls_tell_of_their_impact_each() -> void:
	var balls: Array[Ball] = [
		Ball.new(Vec2.new(0, 0), 5, Vec2.new(10, 0)), Ball.new(Vec2.new(30, 0), 5)
	]
	var world := EventWorlds.world([], balls)
	world.keeps_events = true
	assert_no_refusal(world.advance(3.0))
	assert_eq(world.events.size(), 2)
	assert_eq([world.events[0].ball, world.events[0].other], [0, 1])
	assert_eq([world.events[1].ball, world.events[1].other], [1, 0])
	assert_vec2(world.events[1].normal, Vec2.new(1, 0), 0.0)


func test_stepping_to_the_next_event_stops_there() -> void:
	var world := EventWorlds.world(
		[Vector4(30, -10, 30, 10)], [Ball.new(Vec2.new(0, 0), 5, Vec2.new(10, 0))]
	)
	assert_eq(world.advance_to_next_event(), "")
	assert_eq(world.time, 2.5)
	assert_string_contains(world.advance_to_next_event(), "Nothing happens any more")


func test_a_fast_ball_after_a_long_time_is_never_seen_beyond_a_wall() -> void:
	# The ball moves 15 px in x while this time grows by one unit in its last place.
	var world := EventWorlds.gas(1, 1)
	assert_no_refusal(world.change_ball(0, Ball.new(Vec2.new(20, 20), 10)))
	assert_no_refusal(world.advance(1e8))
	assert_no_refusal(world.change_ball(0, Ball.new(Vec2.new(20, 20), 10, Vec2.new(1e9, 7e8))))
	var outside := PackedFloat64Array()
	for step: int in 500:
		assert_no_refusal(world.advance(1.37e-9))
		var x := world.position_x(0)
		outside.append(maxf(10.0 - x, x - (sqrt(PI * 1000.0) - 10.0)))
	assert_all_at_most(outside, 1e-6)


func test_a_place_within_a_flight_is_told_without_moving_anything() -> void:
	var world := EventWorlds.world(
		[Vector4(30, -10, 30, 10)], [Ball.new(Vec2.new(0, 0), 5, Vec2.new(10, 0))]
	)
	assert_no_refusal(world.advance(0.5))
	assert_eq(world.flight_start(0), 0.0)
	assert_vec2(world.position_at(0, 2.0), Vec2.new(20, 0), 0.0)
	assert_vec2(world.position(0), Vec2.new(5, 0), 0.0)


func test_all_places_at_once_are_those_of_each_ball() -> void:
	var world := EventWorlds.gas(20, 8)
	assert_no_refusal(world.set_gravity(Vec2.new(30, 200)))
	assert_no_refusal(world.advance(0.3))
	var places := world.positions()
	assert_eq(places.size(), 40)
	for index: int in 20:
		var place := Vec2.new(places[2 * index], places[2 * index + 1])
		assert_vec2(place, world.position(index), 0.0)


func test_a_ball_squeezed_between_two_walls_is_told_instead_of_hanging() -> void:
	var world := EventWorld.new()
	assert_no_refusal(world.set_walls(Vec2.zero(), Vec2.new(20.0 + 1e-12, 100)))
	assert_no_refusal(world.set_balls([Ball.new(Vec2.new(10, 50), 10, Vec2.new(50, 1))]))
	world.most_impacts_per_second = 10000
	assert_string_contains(world.advance(1.0), "more than 10000 impacts within a second")
	assert_lt(world.time, 1.0)
	assert_string_contains(world.advance(1.0), "more than 10000 impacts within a second")


func test_the_bound_counts_each_second_anew() -> void:
	var world := EventWorld.new()
	assert_no_refusal(world.set_walls(Vec2.zero(), Vec2.new(30, 100)))
	assert_no_refusal(world.set_balls([Ball.new(Vec2.new(15, 50), 10, Vec2.new(100, 0))]))
	world.most_impacts_per_second = 11
	assert_eq(world.advance(60.0), "")
	assert_eq(world.impacts, 600)


func test_the_short_ways_of_bouncing_agree_with_the_long_ones() -> void:
	var triangle: Array[Vector4] = [
		Vector4(0, 0, 500, 40), Vector4(500, 40, 200, 400), Vector4(200, 400, 0, 0)
	]
	var ball := Ball.new(Vec2.new(220, 150), 10, Vec2.new(311, -97))
	# A world that keeps its events does not take the short ways.
	var short := EventWorlds.world(triangle, [ball])
	var long := EventWorlds.world(triangle, [ball])
	long.keeps_events = true
	var short_in_walls := EventWorlds.gas(1, 3)
	var long_in_walls := EventWorlds.gas(1, 3)
	long_in_walls.keeps_events = true
	for world: EventWorld in [short, long, short_in_walls, long_in_walls]:
		assert_no_refusal(world.advance(30.0))
	var differences: PackedFloat64Array = [
		short.position(0).distance_to(long.position(0)),
		short_in_walls.position(0).distance_to(long_in_walls.position(0)),
	]
	assert_all_at_most(differences, 1e-10)
	assert_eq([short.impacts, short_in_walls.impacts], [long.impacts, long_in_walls.impacts])
	assert_gt(short.impacts, 40)


# Where a coordinate is after some seconds between two walls. The flight is unfolded into a straight
# line, so that only the answer is rounded, however long the flight.
static func _unfolded(
	from: float, velocity: float, seconds: DoubleDouble, low: float, high: float
) -> float:
	var way := seconds.times(DoubleDouble.from_float(velocity))
	way = way.plus(DoubleDouble.from_float(from - low))
	var turns := floorf(way.to_float() / (high - low))
	var rest := way.minus(DoubleDouble.product_of(turns, high - low)).to_float()
	return low + rest if fposmod(turns, 2.0) == 0.0 else high - rest
