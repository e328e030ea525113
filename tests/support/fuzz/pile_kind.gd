class_name PileKind
extends FuzzKind
## Balls of unequal radius and mass that fall onto each other in a V, in a box or on a floor: time
## goes on, the energy never grows, no ball is inside another one or a line, and the impacts of a
## second are bounded.
##
## Bounces of balls on balls end in hops: a pair that is pressed together without any speed is given
## that of a hop of [constant BallPiles.LEAST_HOP]: so much energy may come from nowhere.

## Pixels.
const DEEPEST := 1e-6
## So many impacts in a second are allowed for each ball.
const MOST_PER_BALL := 10_000

const _SAMPLES := 40


func _init() -> void:
	name = "piles"


func world_of(number: int) -> FuzzWorld:
	var rng := random(number)
	var made := FuzzWorld.new()
	var pull: float = [300.0, 500.0, rng.randf_range(10.0, 1000.0)][rng.randi() % 3]
	made.gravity = Vec2.new(0.0, pull)
	made.bounciness = [0.0, 0.5, 0.9, 1.0, rng.randf()][rng.randi() % 5]
	made.seconds = rng.randf_range(0.5, 2.0)
	var half := rng.randf_range(60.0, 150.0)
	match number % 3:
		0:
			var height := half * 10.0 ** rng.randf_range(-1.0, 0.5)
			made.lines.append(LineSegment.new(Vec2.new(-half, -height), Vec2.zero()))
			made.lines.append(LineSegment.new(Vec2.zero(), Vec2.new(half, -height)))
		1:
			made.walls = [Vec2.new(-half, -1000.0), Vec2.new(half, 100.0)]
		2:
			made.lines.append(LineSegment.new(Vec2.new(-half, 50.0), Vec2.new(half, 50.0)))
	_stack(made, rng, half)
	rub(made, rng)
	return made


func problem_of(world: FuzzWorld) -> String:
	var flight := world.event_world()
	flight.most_impacts_per_second = MOST_PER_BALL * maxi(world.balls.size(), 1)
	if _problem_now(flight):
		return ""
	var energy := EnergyCheck.new()
	energy.allowed = EnergyCheck.of_hops(world.balls, world.gravity)
	for sample: int in _SAMPLES + 1:
		var found := flight.fly_to(world.seconds * sample / _SAMPLES)
		if not found:
			found = energy.problem(balls_of(flight), world.gravity)
		if not found:
			found = _problem_now(flight)
		if found:
			return found
	return ""


# Rows from below, with gaps, so that no ball is inside anything at the start.
func _stack(made: FuzzWorld, rng: RandomNumberGenerator, half: float) -> void:
	var bottom := -4.0 * half if made.lines.size() == 2 else -40.0
	var columns := rng.randi_range(1, 3)
	for index: int in rng.randi_range(2, 12):
		var radius := rng.randf_range(4.0, 15.0)
		var x := 32.0 * (index % columns - 0.5 * (columns - 1))
		if rng.randf() < 0.7:
			x += rng.randf_range(-1.0, 1.0)
		var at := Vec2.new(x, bottom - 32.0 * floori(index / float(columns)))
		var velocity := Vec2.zero()
		if rng.randf() < 0.5:
			velocity = Vec2.random_unit(rng).scaled(rng.randf_range(0.0, 200.0))
		var mass: float = [1.0, radius * radius, 10.0 ** rng.randf_range(-3.0, 3.0)][
			rng.randi() % 3
		]
		made.balls.append(Ball.new(at, radius, velocity, mass))


func _problem_now(flight: WatchedWorld) -> String:
	var balls := balls_of(flight)
	for one: int in balls.size():
		var ball := balls[one]
		var found := InsideCheck.problem(ball, flight.nearest_points(ball), DEEPEST)
		if found:
			return found
		for other: int in one:
			var gap := ball.position.distance_to(balls[other].position)
			var inside := ball.radius + balls[other].radius - gap
			if inside > DEEPEST:
				return "Two balls are inside each other by %s px." % inside
	return ""
