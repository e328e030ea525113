class_name EventWorlds
extends RefCounted
## Worlds for tests of events: each test gets a new one, so that none changes another's.


## A world with these segments, given as x and y of both ends, and these balls. A refused value
## is an error.
static func world(
	lines: Array[Vector4], balls: Array[Ball], gravity: Vec2 = Vec2.new(), bounciness: float = 1.0
) -> EventWorld:
	var made := EventWorld.new()
	var segments: Array[LineSegment] = []
	for line: Vector4 in lines:
		segments.append(LineSegment.new(Vec2.new(line.x, line.y), Vec2.new(line.z, line.w)))
	Refusal.push(made.set_segments(segments))
	Refusal.push(made.set_gravity(gravity))
	Refusal.push(made.set_bounciness(bounciness))
	Refusal.push(made.set_balls(balls))
	return made


## A box of walls with balls of 10 px on a tenth of its area; the same for the same seed. With
## `mixed` their radii and masses differ.
static func gas(count: int, seed_number: int, mixed: bool = false) -> EventWorld:
	var rng := RandomNumberGenerator.new()
	rng.seed = seed_number
	var side := sqrt(count * PI * 1000.0)
	var columns := ceili(sqrt(count))
	var balls: Array[Ball] = []
	for index: int in count:
		var row := floori(index / float(columns))
		var place := Vec2.new(index % columns + 0.5, row + 0.5).scaled(side / columns)
		var velocity := Vec2.random_unit(rng).scaled(rng.randf_range(100, 300))
		var radius := rng.randf_range(2, 12) if mixed else 10.0
		balls.append(Ball.new(place, radius, velocity, radius * radius if mixed else 1.0))
	var made := EventWorld.new()
	Refusal.push(made.set_walls(Vec2.zero(), Vec2.new(side, side)))
	Refusal.push(made.set_balls(balls))
	return made


## The deepest overlap of two balls of the world, in pixels; negative where none touch.
static func deepest_overlap(made: EventWorld) -> float:
	var deepest := -INF
	for one: int in made.ball_count():
		var ball := made.ball(one)
		for other: int in one:
			var reach := ball.radius + made.ball(other).radius
			deepest = maxf(deepest, reach - ball.position.distance_to(made.position(other)))
	return deepest


## Place, velocity and spin of all balls, for comparisons to the last bit.
static func numbers(made: EventWorld) -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	for index: int in made.ball_count():
		var ball := made.ball(index)
		found.append_array([ball.position.x, ball.position.y, ball.velocity.x, ball.velocity.y])
		found.append(ball.spin)
	return found
