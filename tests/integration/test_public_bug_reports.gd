extends LabTest
## Situations from the public bug reports of physics engines and games, rebuilt here, that once
## broke the lab: P1 to P13. Those of numbers, keys and pointers are held by the tests of those: P9
## by test_number_text, P10 and P11 by test_drags, P12 by test_layout_direction.

const GRAVITY := Vector2(0, 300)


# P1, a wheel stops where two pieces of a track meet.
func test_a_ball_slides_over_a_downhill_joint_and_off_a_table() -> void:
	for end: Vector2 in [Vector2(200, 35), Vector2(0, 200), Vector2(-100, 200)]:
		var world := _world([Vector4(-100, 0, 0, 0), Vector4(0, 0, end.x, end.y)], 0.5)
		assert_no_refusal(world.set_balls([_ball(-20, -10, 20, 0)]))
		assert_no_refusal(world.advance(4.0))
		assert_gt(world.position_x(0), 10.0, "to %s" % end)


# P2, a solver goes to and fro between two planes.
func test_frame_by_frame_a_ball_passes_a_joint_at_every_angle_and_speed() -> void:
	for degrees: float in [2.0, 9.926, 30.0, 60.0, 90.0]:
		for speed: float in [5.0, 20.0, 40.0]:
			var turned := Vec2.unit_degrees(degrees).scaled(200.0)
			var lines: Array[Vector4] = [Vector4(-100, 0, 0, 0), Vector4(0, 0, turned.x, turned.y)]
			var stepped := _stepped(lines, 0.5, _ball(-20, -10, speed, 0), 2)
			_step(stepped, 300)
			assert_gt(stepped.balls[0].position.x, 5.0, "%s degrees, %s px/s" % [degrees, speed])


# P3, bumps on flush edges.
func test_a_slope_of_two_pieces_is_as_one() -> void:
	for bounciness: float in [0.5, 1.0]:
		var one := _world([Vector4(0, 0, 60, 20)], bounciness)
		var two := _world([Vector4(0, 0, 30, 10), Vector4(30, 10, 60, 20)], bounciness)
		for world: EventWorld in [one, two]:
			var along := Vec2.new(3, 1).normalized()
			var place := Vec2.new(15, 5).plus(Vec2.new(along.y, -along.x).scaled(10.0))
			assert_no_refusal(world.set_balls([Ball.new(place, 10.0)]))
			assert_no_refusal(world.advance(0.8))
		assert_vec2(two.position(0), one.position(0), 1e-9)


# P4, a sleeper floats when its support goes.
func test_a_ball_in_a_v_falls_when_one_line_goes() -> void:
	for line: int in 2:
		for is_moved: bool in [false, true]:
			var world := _world([Vector4(-200, -200, 0, 0), Vector4(0, 0, 200, -200)], 0.5)
			assert_no_refusal(world.set_balls([_ball(-20, -150, 0, 0)]))
			assert_no_refusal(world.advance(60.0))
			assert_true(world.is_resting(0))
			if is_moved:
				assert_no_refusal(world.move_segment(line, _line(Vector4(900, 0, 990, 0))))
			else:
				assert_no_refusal(world.remove_segment(line))
			assert_no_refusal(world.advance(1.0))
			# Down the other line to its end, round it, and away from it.
			var sideways := world.position_x(0) * (1.0 if line == 1 else -1.0)
			assert_gt(sideways, 30.0)
			assert_gt(world.position_y(0), 50.0)
			assert_false(world.is_resting(0))


# P5, the object hit last is skipped.
func test_a_line_that_was_just_hit_is_met_where_it_is_moved_to() -> void:
	var world := _world([Vector4(0, -100, 0, 100), Vector4(500, -100, 500, 100)], 1.0)
	assert_no_refusal(world.set_gravity(Vec2.zero()))
	assert_no_refusal(world.set_balls([_ball(50, 0, -100, 0)]))
	assert_no_refusal(world.advance(1.0))
	assert_no_refusal(world.move_segment(0, _line(Vector4(200, -100, 200, 100))))
	assert_no_refusal(world.advance(3.0))
	assert_vec2(world.position(0), Vec2.new(10, 0), 1e-12)


func test_under_gravity_a_moved_line_is_met_where_it_is() -> void:
	var world := _world([Vector4(-100, 60, 100, -60), Vector4(-2000, 900, 2000, 900)], 1.0)
	world.keeps_events = true
	assert_no_refusal(world.set_balls([_ball(0, -200, 0, 0)]))
	assert_no_refusal(world.advance(1.3))
	world.events.clear()
	assert_no_refusal(world.move_segment(0, _line(Vector4(-2000, 600, 2000, 600))))
	assert_no_refusal(world.advance(5.0))
	for event: WorldEvent in world.events:
		assert_almost_eq(event.point.y, 600.0, 1e-9)


# P6, a paddle moves into a ball, and a ball grows: in all four ways it stays above.
func test_what_rests_stays_above_what_is_moved_into_it() -> void:
	for way: int in 4:
		for up: float in [1e-12, 1e-9, 1e-6, 1e-3, 1.0, 9.0, 15.0]:
			var stepped := _stepped([Vector4(-100, 0, 100, 0)], 0.5, _ball(0, -10, 0, 0), way)
			_step(stepped, 30)
			var moved: Array[LineSegment] = [_line(Vector4(-100, -up, 100, -up))]
			assert_no_refusal(stepped.surroundings.set_segments(moved))
			_step(stepped, 60)
			var height := -stepped.balls[0].position.y
			# By position reset a resting ball makes hops.
			var hop := 0.1 if way == SteppingMethods.Method.POSITION_RESET else 2e-6
			assert_almost_eq(height, 10.0 + up, hop, "way %d, %s px" % [way, up])


func test_in_the_event_world_it_is_carried_and_may_grow() -> void:
	for up: float in [1e-12, 1e-9, 1e-6, 1e-3, 1.0, 9.0, 15.0, 50.0]:
		var world := _world([Vector4(-100, 0, 100, 0)], 0.5)
		assert_no_refusal(world.set_balls([_ball(0, -10, 0, 0)]))
		assert_no_refusal(world.advance(1.0))
		# Its ends are exchanged, too: the ball stays above all the same.
		assert_no_refusal(world.move_segment(0, _line(Vector4(100, -up, -100, -up))))
		assert_no_refusal(world.advance(1.0))
		assert_vec2(world.position(0), Vec2.new(0, -10.0 - up), 1e-9)
		assert_no_refusal(world.change_ball(0, Ball.new(world.position(0), 10.0 + up)))
		assert_no_refusal(world.advance(1.0))
		assert_vec2(world.position(0), Vec2.new(0, -10.0 - 2.0 * up), 1e-9)
		assert_true(world.is_resting(0))


# P7, keeping the events changed what happened.
func test_with_and_without_events_the_same_happens() -> void:
	for touches: bool in [false, true]:
		var places: Array[PackedFloat64Array] = []
		for keeps: bool in [true, false]:
			var world := EventWorld.new()
			world.keeps_events = keeps
			assert_no_refusal(world.set_walls(Vec2.zero(), Vec2.new(2000, 100)))
			assert_no_refusal(world.set_bounciness(0.9 if touches else 0.5))
			var light := Ball.new(Vec2.new(40, 50), 10.0)
			var heavy := Ball.new(
				Vec2.new(60 if touches else 120, 50), 10.0, Vec2.new(-500, 0), 100.0
			)
			assert_no_refusal(world.set_balls([light, heavy]))
			assert_no_refusal(world.advance(2.0))
			places.append(EventWorlds.numbers(world))
			if not touches:
				assert_almost_eq(world.position_x(1), 747.862151, 1e-6)
		assert_true(places[0] == places[1])


# P8, gravity adds up on the ground. It is what dropping the rest of a frame does; the lesson says
# so where it shows the energy.
func test_what_the_dropped_rest_does_to_the_energy_is_told() -> void:
	for way: SteppingMethods.Method in SteppingMethods.Method.values():
		var model := AngledLinesModel.new()
		assert_eq(model.set_method(way), "")
		var lines: Array[LineSegment] = [
			_line(Vector4(-100, -100, 0, 0)), _line(Vector4(0, 0, 100, -100))
		]
		assert_no_refusal(model.set_lines(lines))
		assert_no_refusal(model.set_bounciness(0.5))
		assert_no_refusal(model.world.set_balls([_ball(-20, -150, 0, 0)]))
		assert_no_refusal(model.set_gravity(Vec2.new(0, 300)))
		for frame: int in 600:
			model.step()
		for text: String in AngledLinesTexts.steps(model, null):
			var tells := text.contains("stays there while gravity adds to v")
			assert_eq(tells, way == SteppingMethods.Method.POINT_OF_IMPACT, text)


# P13, edges of length zero.
func test_a_segment_is_refused_or_holds() -> void:
	for length: float in [1e-300, 1e-165, 0.9e-150]:
		var world := EventWorld.new()
		var problem := world.add_segment(LineSegment.new(Vec2.zero(), Vec2.new(length, 0)))
		assert_string_contains(problem, "at least 1e-150 px long, not ")
		assert_eq(world.segment_count(), 0)
	for length: float in [1e-149, 1e-100, 1e-30, 1e-9, 1e-3]:
		for bounciness: float in [0.0, 0.5, 1.0]:
			var world := _world([], bounciness)
			var short_line := LineSegment.new(Vec2.zero(), Vec2.new(length, 0))
			assert_no_refusal(world.add_segment(short_line))
			assert_no_refusal(world.set_balls([_ball(2, -30, 0, 0)]))
			var nearest := INF
			for step: int in 400:
				assert_no_refusal(world.advance(0.002))
				nearest = minf(nearest, world.position(0).length())
			assert_between(nearest, 10.0 - 1e-8, 10.2, "%s px" % length)


func _world(lines: Array[Vector4], bounciness: float) -> EventWorld:
	return EventWorlds.world(lines, [], Vec2.new(GRAVITY.x, GRAVITY.y), bounciness)


func _stepped(lines: Array[Vector4], bounciness: float, ball: Ball, way: int) -> SteppedWorld:
	var made := SteppedWorld.new(SteppingMethods.mover_of(way as SteppingMethods.Method))
	var segments: Array[LineSegment] = []
	for line: Vector4 in lines:
		segments.append(_line(line))
	assert_no_refusal(made.surroundings.set_segments(segments))
	assert_no_refusal(made.surroundings.set_gravity(Vec2.new(GRAVITY.x, GRAVITY.y)))
	assert_no_refusal(made.surroundings.set_bounciness(bounciness))
	assert_no_refusal(made.set_balls([ball]))
	return made


func _step(stepped: SteppedWorld, frames: int) -> void:
	for frame: int in frames:
		assert_no_refusal(stepped.step(1.0 / 60.0))


func _line(ends: Vector4) -> LineSegment:
	return LineSegment.new(Vec2.new(ends.x, ends.y), Vec2.new(ends.z, ends.w))


func _ball(x: float, y: float, velocity_x: float, velocity_y: float) -> Ball:
	return Ball.new(Vec2.new(x, y), 10.0, Vec2.new(velocity_x, velocity_y))
