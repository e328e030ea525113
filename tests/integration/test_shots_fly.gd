extends LabTest
## Computed shots, flown in the event world, hit when and where they should; and no earlier moment
## would do.

const _SHOTS := 300
# A search over walls takes longer than the flight.
const _BANK_SHOTS := 60
const _SEED := 17
## Pixels. The places are some hundred pixels from each other; a shot that takes long is far away.
const _MISS := 1e-8


func test_a_lead_shot_touches_its_target_then_and_not_before() -> void:
	var rng := _rng()
	var hits := 0
	for number: int in _SHOTS:
		var target := _target(rng, rng.randf_range(0, 30))
		var shooter := _place(rng)
		var speed := rng.randf_range(20, 400)
		var aim := LeadAim.first(shooter, target, speed)
		var last := aim.time if aim.hit else 100.0
		if aim.hit and aim.time == 0.0:
			continue
		assert_gt(_least_lead(shooter, target, speed, last), 0.0, "shot %d is too late" % number)
		if aim.hit:
			hits += 1
			_assert_meets(shooter, aim.direction.scaled(speed), target, aim.time, number)
	assert_between(hits, 150, _SHOTS)


func test_a_ballistic_shot_flies_to_its_target() -> void:
	var rng := _rng()
	var hits := 0
	for number: int in _SHOTS:
		var gravity := Vec2.random_unit(rng).scaled(rng.randf_range(10, 600))
		var shooter := _place(rng)
		var speed := rng.randf_range(100, 900)
		var target := _place(rng)
		for shot in BallisticAim.at_fixed(shooter, target, gravity, speed):
			hits += 1
			var world := _flown(shooter, shot.direction.scaled(speed), gravity, shot.time)
			var least := _MISS * (1.0 + shot.time)
			assert_lt(world.position(0).distance_to(target), least, "shot %d" % number)
		var least_speed := BallisticAim.least_speed(shooter, target, gravity)
		var is_reached := BallisticAim.at_fixed(shooter, target, gravity, speed).size() > 0
		assert_eq(is_reached, speed >= least_speed, "shot %d" % number)
	assert_gt(hits, _SHOTS)


func test_a_bank_shot_comes_to_its_target() -> void:
	var rng := _rng()
	var hits := 0
	for number: int in _BANK_SHOTS:
		var walls := _walls(rng)
		var radius := rng.randf_range(0, 12) if rng.randf() < 0.8 else 0.5
		var bounciness := 1.0 if rng.randf() < 0.4 else rng.randf_range(0.3, 1.0)
		var start := _free_place(rng, walls, radius)
		var target := _free_place(rng, walls, radius)
		var way := BankAim.first(start, target, radius, bounciness, walls, rng.randi_range(1, 3))
		if not way.hit:
			continue
		hits += 1
		var world := EventWorld.new()
		assert_no_refusal(world.set_segments(walls))
		assert_no_refusal(world.set_bounciness(bounciness))
		var velocity := way.direction.scaled(300)
		assert_no_refusal(world.set_balls([Ball.new(start, maxf(radius, 1e-9), velocity)]))
		assert_no_refusal(world.advance_to(way.distance / 300))
		assert_lt(world.position(0).distance_to(target), 1e-6, "shot %d" % number)
		assert_eq(world.impacts, way.bounces.size(), "shot %d" % number)
	assert_gt(hits, 25)


func test_a_timed_shot_meets_its_target() -> void:
	var rng := _rng()
	var hits := 0
	for number: int in _SHOTS:
		var muzzle := _place(rng)
		var bullet := Vec2.random_unit(rng).scaled(rng.randf_range(50, 500))
		var gravity := Vec2.zero()
		if rng.randf() < 0.5:
			gravity = Vec2.new(0, rng.randf_range(10, 300))
		var target := _target(rng, 0.0)
		var shot := TimedAim.at_line(muzzle, bullet, gravity, target.position, target.velocity)
		if not shot.hit:
			continue
		hits += 1
		var world := _flown(muzzle, bullet, gravity, shot.flight)
		var there := target.position_after(shot.fire + shot.flight)
		var least := _MISS * (1.0 + shot.fire + shot.flight) ** 2
		assert_lt(world.position(0).distance_to(there), least, "shot %d" % number)
	assert_gt(hits, 40)


# How far the bullet is from touching at its nearest before that time, wherever it is shot.
static func _least_lead(shooter: Vec2, target: AimTarget, speed: float, last: float) -> float:
	var least := INF
	for part: int in range(1, 60):
		var time := last * part / 60.0 * (1.0 - 1e-9)
		var gap := target.position_after(time).distance_to(shooter) - target.radius
		least = minf(least, gap - speed * time)
	return least


# In the event world, as two balls, which meet where their discs touch.
func _assert_meets(
	shooter: Vec2, bullet: Vec2, target: AimTarget, time: float, number: int
) -> void:
	var world := EventWorld.new()
	var half := maxf(0.5 * target.radius, 1e-9)
	var balls: Array[Ball] = [
		Ball.new(shooter, half, bullet), Ball.new(target.position, half, target.velocity)
	]
	assert_no_refusal(world.set_balls(balls))
	var gap := world.next_event_time() - time
	# A bullet that grazes is late or early by more.
	assert_almost_eq(gap, 0.0, 1e-6 * (1.0 + time), "shot %d" % number)


func _flown(start: Vec2, velocity: Vec2, gravity: Vec2, seconds: float) -> EventWorld:
	var world := EventWorld.new()
	assert_no_refusal(world.set_gravity(gravity))
	assert_no_refusal(world.set_balls([Ball.new(start, 1.0, velocity)]))
	assert_no_refusal(world.advance_to(seconds))
	return world


static func _rng() -> RandomNumberGenerator:
	var rng := RandomNumberGenerator.new()
	rng.seed = _SEED
	return rng


static func _place(rng: RandomNumberGenerator) -> Vec2:
	return Vec2.new(rng.randf_range(-400, 400), rng.randf_range(-300, 300))


static func _target(rng: RandomNumberGenerator, radius: float) -> AimTarget:
	var velocity := Vec2.random_unit(rng).scaled(rng.randf_range(0, 300))
	return AimTarget.new(_place(rng), velocity, Vec2.zero(), radius)


# A box with two walls in it.
static func _walls(rng: RandomNumberGenerator) -> Array[LineSegment]:
	var corners: Array[Vec2] = [
		Vec2.new(-400, -300), Vec2.new(400, -300), Vec2.new(400, 300), Vec2.new(-400, 300)
	]
	var walls: Array[LineSegment] = []
	for place: int in corners.size():
		walls.append(LineSegment.new(corners[place - 1], corners[place]))
	for more: int in 2:
		var from := _place(rng)
		walls.append(LineSegment.new(from, from.plus(Vec2.random_unit(rng).scaled(150))))
	return walls


static func _free_place(
	rng: RandomNumberGenerator, walls: Array[LineSegment], radius: float
) -> Vec2:
	var place := _place(rng)
	for wall in walls:
		if wall.closest_point(place).distance_to(place) < radius + 1.0:
			return _free_place(rng, walls, radius)
	return place
