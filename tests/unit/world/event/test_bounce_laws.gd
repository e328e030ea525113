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


# Sets both worlds up alike by `set_up`, and compares them after each of 20 steps.
func _check(set_up: Callable) -> void:
	var different: PackedInt32Array = []
	var impacts := 0
	for trial: int in _WORLDS:
		var fast := EventWorld.new()
		var readable := ReadableWorld.new()
		for world: EventWorld in [fast, readable]:
			var rng := RandomNumberGenerator.new()
			rng.seed = trial
			world.most_impacts_per_second = 2000
			set_up.call(world, rng)
		for step: int in 20:
			var problems := [fast.advance(0.05), readable.advance(0.05)]
			if problems[0] != problems[1] or _state(fast) != _state(readable):
				different.append(trial)
				break
		impacts += fast.impacts
	assert_eq(different, PackedInt32Array())
	assert_gt(impacts, 3 * _WORLDS)


static func _state(world: EventWorld) -> Array:
	return [world.time, world.impacts, world.next_event_time(), EventWorlds.numbers(world)]


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
