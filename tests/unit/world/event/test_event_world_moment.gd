extends LabTest
## To set the moment of a world gives the same bits as to let time pass and to ask for each ball,
## whatever happens to the world in between.

const _ROOM := 400.0
const _STEPS := 60
const _LINES: Array[Vector4] = [
	Vector4(40, 250, 220, 330), Vector4(250, 200, 380, 120), Vector4(120, 90, 130, 160)
]


func test_lone_balls_between_walls() -> void:
	_compare_worlds(30, func(rng: RandomNumberGenerator) -> EventWorld: return _room(rng, 1))


func test_lone_balls_among_segments_with_and_without_gravity() -> void:
	_compare_worlds(
		30,
		func(rng: RandomNumberGenerator) -> EventWorld:
			var world := _room(rng, 1)
			assert_no_refusal(world.set_segments(_segments()))
			if rng.randi() % 2 == 0:
				assert_no_refusal(world.set_gravity(Vec2.new(30, 500)))
			return world
	)


func test_some_balls_and_crowds() -> void:
	_compare_worlds(
		24,
		func(rng: RandomNumberGenerator) -> EventWorld:
			var world := _room(rng, rng.randi_range(2, 20))
			if rng.randi() % 3 == 0:
				assert_no_refusal(world.set_segments(_segments()))
			if rng.randi() % 3 == 0:
				assert_no_refusal(world.set_gravity(Vec2.new(-20, 300)))
			return world
	)


func test_balls_that_come_to_rest_and_slide_over_ends() -> void:
	var balls: Array[Ball] = [Ball.new(Vec2.new(60, 20), 8), Ball.new(Vec2.new(300, 20), 5)]
	var asked := EventWorlds.world(_LINES, balls, Vec2.new(0, 500), 0.4)
	var told := EventWorlds.world(_LINES, balls, Vec2.new(0, 500), 0.4)
	var places := asked.places
	var different: PackedInt32Array = []
	for frame: int in 240:
		asked.moment = (frame + 1) / 60.0
		assert_no_refusal(told.advance_to((frame + 1) / 60.0))
		if places != _positions(told):
			different.append(frame)
	assert_eq(different, PackedInt32Array())


func test_a_moment_that_cannot_be_is_refused_and_changes_nothing() -> void:
	for count: int in [1, 3]:
		var world := EventWorlds.gas(count, 5)
		world.moment = 2.0
		var before := [world.moment, world.places.duplicate(), EventWorlds.numbers(world)]
		for wrong: float in [1.999, -1.0, NAN, INF, -INF, 1.1e15]:
			world.moment = wrong
			assert_push_error(
				"Refused: The world stands at 2.0 s and can advance to at most 1e15 s"
			)
			assert_eq([world.moment, world.places, EventWorlds.numbers(world)], before)
	assert_push_error_count(12)


func test_the_present_moment_is_no_past() -> void:
	var world := EventWorlds.gas(1, 5)
	world.moment = 2.0
	world.moment = 2.0
	assert_no_refusal(world.advance(0.25))
	world.moment = 2.25
	assert_eq(world.places, _positions(world))


func test_too_many_impacts_are_told_and_the_moment_says_where() -> void:
	var world := EventWorld.new()
	assert_no_refusal(world.set_walls(Vec2.zero(), Vec2.new(20.0 + 1e-12, 100)))
	assert_no_refusal(world.set_balls([Ball.new(Vec2.new(10, 50), 10, Vec2.new(50, 1))]))
	world.most_impacts_per_second = 1000
	world.moment = 1.0
	assert_push_error("more than 1000 impacts within a second")
	assert_lt(world.moment, 1.0)
	assert_eq(world.impacts, 1001)
	assert_eq(world.places, _positions(world))


func test_a_removed_ball_stays_where_it_was() -> void:
	for gravity: float in [0.0, 300.0]:
		for count: int in [1, 2, 20]:
			var world := EventWorlds.gas(count, 3)
			assert_no_refusal(world.set_gravity(Vec2.new(0, gravity)))
			world.moment = 0.2
			var place := world.position(0)
			assert_no_refusal(world.remove_ball(0))
			world.moment = 0.7
			assert_vec2(Vec2.new(world.places[0], world.places[1]), place, 0.0)
			assert_vec2(world.position(0), place, 0.0)
			assert_eq(world.positions(), world.places)


func test_places_that_are_held_stay_those_of_the_world() -> void:
	var world := EventWorlds.gas(3, 7)
	var held := world.places
	var kept := world.snapshot()
	assert_no_refusal(world.add_ball(Ball.new(Vec2.new(12, 12), 1)))
	world.moment = 0.5
	assert_eq(held.size(), 8)
	assert_no_refusal(world.restore(kept))
	world.moment = 0.25
	assert_eq(held, _positions(world))
	assert_no_refusal(world.set_balls([Ball.new(Vec2.new(20, 20), 1, Vec2.new(5, 9))]))
	world.moment = 0.5
	assert_eq(held, _positions(world))
	assert_eq(held.size(), 2)


func test_places_change_with_the_moment_alone() -> void:
	var world := EventWorlds.gas(2, 7)
	world.moment = 0.5
	var before := world.places.duplicate()
	assert_no_refusal(world.advance(0.1))
	assert_eq(world.places, before)


func test_places_are_read_only() -> void:
	var world := EventWorlds.gas(2, 7)
	var held := world.places
	world.places = PackedFloat64Array()
	assert_push_error("The places of an EventWorld are read only")
	world.moment = 0.5
	assert_eq(held, _positions(world))


# Sets up pairs of worlds alike, asks one by its moment and the other by advance_to and position,
# and changes both alike from outside now and then.
func _compare_worlds(trials: int, set_up: Callable) -> void:
	var different: PackedStringArray = []
	var impacts := 0
	var refusals := 0
	for trial: int in trials:
		var rng := RandomNumberGenerator.new()
		rng.seed = trial
		var asked: EventWorld = set_up.call(rng)
		rng.seed = trial
		var told: EventWorld = set_up.call(rng)
		var places := asked.places
		var kept: Array[WorldSnapshot] = [asked.snapshot(), told.snapshot()]
		for step: int in _STEPS:
			if rng.randi() % 4 == 0:
				_change(asked, told, rng, kept)
			var target := told.time + rng.randf() * (0.3 if step % 9 == 0 else 0.02)
			asked.moment = target
			refusals += 1 if told.advance_to(target) else 0
			var are_same := places == _positions(told) and asked.moment == told.time
			if not are_same or asked.impacts != told.impacts:
				different.append("%d, step %d" % [trial, step])
				break
		impacts += told.impacts
	assert_eq(different, PackedStringArray())
	assert_gt(impacts, trials)
	assert_push_error_count(refusals)


func _change(
	asked: EventWorld, told: EventWorld, rng: RandomNumberGenerator, kept: Array[WorldSnapshot]
) -> void:
	var kind := rng.randi() % 9
	var index := rng.randi() % maxi(told.ball_count(), 1)
	var new_ball := _ball(rng)
	var gravity := Vec2.new(0.0, 400.0 * (rng.randi() % 2))
	var number := rng.randf()
	var worlds: Array[EventWorld] = [asked, told]
	var answers: PackedStringArray = []
	for which: int in 2:
		var world := worlds[which]
		match kind:
			0:
				assert_no_refusal(world.add_ball(new_ball))
			1:
				if world.has_ball(index):
					assert_no_refusal(world.change_ball(index, new_ball))
			2:
				if world.has_ball(index):
					assert_no_refusal(world.remove_ball(index))
			3:
				assert_no_refusal(world.set_balls([new_ball]))
			4:
				assert_no_refusal(world.set_bounciness(number))
			5:
				assert_no_refusal(world.set_gravity(gravity))
			6:
				assert_no_refusal(world.add_segment(_segments()[0]))
			7:
				answers.append(world.advance(0.05 * number))
			_:
				# Refused where something else than balls has changed; then it is kept anew.
				if world.restore(kept[which]):
					kept[which] = world.snapshot()
				world.keeps_events = number < 0.3
	assert_eq(answers.slice(0, 1), answers.slice(1))


func _room(rng: RandomNumberGenerator, count: int) -> EventWorld:
	var world := EventWorld.new()
	world.most_impacts_per_second = 2000
	assert_no_refusal(world.set_walls(Vec2.zero(), Vec2.new(_ROOM, _ROOM)))
	assert_no_refusal(world.set_bounciness(1.0 if rng.randi() % 2 == 0 else rng.randf()))
	var balls: Array[Ball] = []
	for index: int in count:
		balls.append(_ball(rng))
	assert_no_refusal(world.set_balls(balls))
	return world


static func _ball(rng: RandomNumberGenerator) -> Ball:
	var place := Vec2.new(rng.randf_range(20, _ROOM - 20), rng.randf_range(20, _ROOM - 20))
	var velocity := Vec2.random_unit(rng).scaled(10.0 ** rng.randf_range(1.0, 4.5))
	return Ball.new(place, rng.randf_range(2, 12), velocity, rng.randf_range(1, 9))


static func _segments() -> Array[LineSegment]:
	var segments: Array[LineSegment] = []
	for line: Vector4 in _LINES:
		segments.append(LineSegment.new(Vec2.new(line.x, line.y), Vec2.new(line.z, line.w)))
	return segments


static func _positions(world: EventWorld) -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	for index: int in world.ball_count():
		found.append(world.position_x(index))
		found.append(world.position_y(index))
	return found
