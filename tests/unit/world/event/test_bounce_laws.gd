extends LabTest
## The laws that are written out for speed give the same bits as the readable steps, in random
## worlds.

const _ROOM := 400.0
const _WORLDS := 40


func test_bounces_between_walls() -> void:
	_check(
		func(world: EventWorld, rng: RandomNumberGenerator) -> void:
			_set_walls(world)
			assert_no_refusal(world.set_bounciness(_bounciness(rng)))
			assert_no_refusal(world.set_balls(_balls(rng, 1)))
	)


func test_bounces_of_some_balls_between_walls_and_segments() -> void:
	_check(
		func(world: EventWorld, rng: RandomNumberGenerator) -> void:
			_set_walls(world)
			assert_no_refusal(world.set_bounciness(_bounciness(rng)))
			assert_no_refusal(world.set_segments(_segments(rng, rng.randi_range(1, 12))))
			assert_no_refusal(world.set_balls(_balls(rng, rng.randi_range(1, 9))))
	)


func test_elastic_bounces_off_segments() -> void:
	_check(
		func(world: EventWorld, rng: RandomNumberGenerator) -> void:
			var corners: Array[Vec2] = [
				Vec2.zero(), Vec2.new(_ROOM, 30), Vec2.new(_ROOM, _ROOM), Vec2.new(-50, _ROOM)
			]
			var segments := _segments(rng, rng.randi_range(0, 20))
			for place: int in corners.size():
				segments.append(LineSegment.new(corners[place - 1], corners[place]))
			assert_no_refusal(world.set_segments(segments))
			assert_no_refusal(world.set_balls(_balls(rng, rng.randi_range(1, 3))))
	)


func test_meetings_of_many_balls() -> void:
	_check(
		func(world: EventWorld, rng: RandomNumberGenerator) -> void:
			_set_walls(world)
			assert_no_refusal(world.set_bounciness(_bounciness(rng)))
			assert_no_refusal(world.set_balls(_balls(rng, rng.randi_range(16, 40))))
			if rng.randi() % 4 == 0:
				assert_no_refusal(world.set_gravity(Vec2.new(40, 300)))
	)


func test_crowds_among_segments_that_balls_join_and_leave() -> void:
	_check(
		func(world: EventWorld, rng: RandomNumberGenerator) -> void:
			_set_walls(world)
			assert_no_refusal(world.set_bounciness(_bounciness(rng)))
			assert_no_refusal(world.set_segments(_segments(rng, rng.randi_range(0, 5))))
			assert_no_refusal(world.set_balls(_balls(rng, rng.randi_range(15, 22))))
			world.keeps_events = rng.randi() % 3 == 0,
		func(world: EventWorld, rng: RandomNumberGenerator) -> void:
			var index := rng.randi() % world.ball_count()
			match rng.randi() % 4:
				0:
					assert_no_refusal(world.add_ball(_balls(rng, 1)[0]))
				1:
					if world.has_ball(index):
						assert_no_refusal(world.remove_ball(index))
				2:
					if world.has_ball(index):
						assert_no_refusal(world.change_ball(index, _balls(rng, 1)[0]))
	)


func test_a_lone_ball_that_has_too_many_impacts() -> void:
	_check(
		func(world: EventWorld, rng: RandomNumberGenerator) -> void:
			_set_walls(world)
			world.most_impacts_per_second = rng.randi_range(1, 9)
			assert_no_refusal(world.set_balls(_balls(rng, 1)))
	)


func test_a_lone_ball_that_comes_to_the_very_moment_of_a_bounce() -> void:
	var different: PackedInt32Array = []
	for trial: int in _WORLDS:
		var worlds: Array[EventWorld] = [EventWorld.new(), EventWorld.new(), ReadableWorld.new()]
		for world: EventWorld in worlds:
			var rng := RandomNumberGenerator.new()
			rng.seed = trial
			_set_walls(world)
			assert_no_refusal(world.set_balls(_balls(rng, 1)))
		# The bounce after the next: the loop over bounces has to stop before it or after it.
		assert_no_refusal(worlds[0].advance_to(worlds[0].next_event_time() + 1e-9))
		var moment := worlds[0].next_event_time()
		assert_no_refusal(worlds[1].advance_to(moment))
		assert_no_refusal(worlds[2].advance_to(moment))
		if _state(worlds[1]) != _state(worlds[2]):
			different.append(trial)
	assert_eq(different, PackedInt32Array())


func test_a_pair_that_is_put_back_is_not_taken_for_a_lone_ball() -> void:
	var world := EventWorlds.gas(2, 6)
	var kept := world.snapshot()
	assert_no_refusal(world.set_balls([Ball.new(Vec2.new(20, 20), 10, Vec2.new(90, 50))]))
	assert_no_refusal(world.restore(kept))
	var other := EventWorlds.gas(2, 6)
	assert_no_refusal(world.advance(20.0))
	assert_no_refusal(other.advance(20.0))
	assert_eq(_state(world), _state(other))
	assert_gt(world.impacts, 20)


# Sets both worlds up alike by `set_up`, and compares them after each of 20 steps, before which
# `change` may change both alike.
func _check(set_up: Callable, change: Callable = Callable()) -> void:
	var different: PackedInt32Array = []
	var impacts := 0
	for trial: int in _WORLDS:
		var fast := EventWorld.new()
		var readable := ReadableWorld.new()
		var worlds: Array[EventWorld] = [fast, readable]
		var rngs: Array[RandomNumberGenerator] = []
		for world: EventWorld in worlds:
			rngs.append(RandomNumberGenerator.new())
			rngs[-1].seed = trial
			world.most_impacts_per_second = 2000
			set_up.call(world, rngs[-1])
		for step: int in 20:
			for which: int in 2:
				if change:
					change.call(worlds[which], rngs[which])
			var problems := [fast.advance(0.05), readable.advance(0.05)]
			if problems[0] != problems[1] or _state(fast) != _state(readable):
				different.append(trial)
				break
		impacts += fast.impacts
	assert_eq(different, PackedInt32Array())
	assert_gt(impacts, 3 * _WORLDS)


static func _state(world: EventWorld) -> Array:
	var next := world.next_event_time()
	return [world.time, world.impacts, next, world.positions(), EventWorlds.numbers(world)]


func _set_walls(world: EventWorld) -> void:
	assert_no_refusal(world.set_walls(Vec2.zero(), Vec2.new(_ROOM, _ROOM)))


static func _bounciness(rng: RandomNumberGenerator) -> float:
	return 1.0 if rng.randi() % 2 == 0 else rng.randf()


static func _balls(rng: RandomNumberGenerator, count: int) -> Array[Ball]:
	var balls: Array[Ball] = []
	for index: int in count:
		var place := Vec2.new(rng.randf_range(20, _ROOM - 20), rng.randf_range(50, _ROOM - 20))
		var velocity := Vec2.random_unit(rng).scaled(rng.randf_range(50, 3000))
		balls.append(Ball.new(place, rng.randf_range(2, 12), velocity, rng.randf_range(1, 9)))
	return balls


static func _segments(rng: RandomNumberGenerator, count: int) -> Array[LineSegment]:
	var segments: Array[LineSegment] = []
	for place: int in count:
		var start := Vec2.new(rng.randf() * _ROOM, rng.randf() * _ROOM)
		var way := Vec2.random_unit(rng).scaled(rng.randf_range(5, 150))
		segments.append(LineSegment.new(start, start.plus(way)))
	return segments
