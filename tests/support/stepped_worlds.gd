class_name SteppedWorlds
extends RefCounted
## Worlds for tests of stepping: each test gets a new one, so that none changes another's.

## A frame of the course, in seconds.
const FRAME := 1.0 / 60.0


## A world with these lines, given as x and y of both ends, and one ball.
static func world(lines: Array[Vector4], ball: Ball, gravity: Vec2 = Vec2.new()) -> SteppedWorld:
	var made := SteppedWorld.new(WholeFrameMover.new())
	var segments: Array[LineSegment] = []
	for line: Vector4 in lines:
		segments.append(LineSegment.new(Vec2.new(line.x, line.y), Vec2.new(line.z, line.w)))
	Refusal.push(made.surroundings.set_segments(segments))
	Refusal.push(made.surroundings.set_gravity(gravity))
	Refusal.push(made.set_balls([ball]))
	return made


## A closed box of slanted walls with slanted lines and `count` balls in it, under gravity; the same
## for the same seed.
static func box(count: int, seed_number: int) -> SteppedWorld:
	var lines: Array[Vector4] = [
		Vector4(-280, -170, 280, -190),
		Vector4(280, -190, 260, 190),
		Vector4(260, 190, -270, 170),
		Vector4(-270, 170, -280, -170),
	]
	var rng := RandomNumberGenerator.new()
	rng.seed = seed_number
	for i: int in 16:
		var start := Vector2(-240 + 120 * (i % 4), -120 + 70 * (i >> 2))
		var end := start + Vector2(rng.randf_range(30, 70), rng.randf_range(-30, 30))
		lines.append(Vector4(start.x, start.y, end.x, end.y))
	var made := world(lines, Ball.new(Vec2.new(), 1.0), Vec2.new(0.0, 300.0))
	var balls: Array[Ball] = []
	for i: int in count:
		var place := Vec2.new(rng.randf_range(-230, 230), rng.randf_range(-150, -130))
		var velocity := Vec2.random_unit(rng).scaled(rng.randf_range(50, 400))
		balls.append(Ball.new(place, 6.0, velocity))
	Refusal.push(made.set_balls(balls))
	return made


## Steps a world by this many frames.
static func run(made: SteppedWorld, frames: int) -> void:
	for frame: int in frames:
		Refusal.push(made.step(FRAME))
