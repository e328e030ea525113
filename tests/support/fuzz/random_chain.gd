class_name RandomChain
extends RefCounted
## A ball on a random chain of lines, or above it, under gravity.

## The shapes of chains; the number of a chain says which it is.
enum Shape {
	STRAIGHT,
	CONVEX,
	CONCAVE,
	HILLS,
	ZIGZAG,
	CIRCLE_OUTSIDE,
	CIRCLE_INSIDE,
	GAPS,
	CROSSING,
	DOUBLE,
	TEE,
	TABLE
}

## px/s², downwards.
const GRAVITY := 300.0

## The shape of the chain.
var shape: Shape
## The chain.
var lines: Array[LineSegment] = []
## Where the ball starts.
var ball: Ball


## The world of the chain with this number; the same for the same number.
static func world_of(number: int) -> FuzzWorld:
	var rng := FuzzKind.random(number)
	var chain := RandomChain.new()
	chain.shape = number % Shape.size() as Shape
	var made := FuzzWorld.new()
	made.gravity = Vec2.new(0.0, GRAVITY)
	made.bounciness = [1.0, 0.5, 0.0, 0.9, rng.randf()][rng.randi() % 5]
	chain._lay(rng)
	chain._put_ball(rng)
	if number % 10 == 7:
		chain._move_all(Vec2.random_unit(rng).scaled(10.0 ** rng.randf_range(3.0, 7.0)))
	made.lines = chain.lines
	made.balls = [chain.ball]
	return made


func _lay(rng: RandomNumberGenerator) -> void:
	match shape:
		Shape.STRAIGHT:
			_lay_turns(rng, rng.randi_range(2, 12), 0.0)
		Shape.CONVEX:
			_lay_turns(rng, rng.randi_range(2, 8), _small_angle(rng))
		Shape.CONCAVE:
			_lay_turns(rng, rng.randi_range(2, 8), -_small_angle(rng))
		Shape.HILLS:
			_lay_hills(rng)
		Shape.ZIGZAG:
			_lay_zigzag(rng)
		Shape.CIRCLE_OUTSIDE, Shape.CIRCLE_INSIDE:
			_lay_circle(rng)
		Shape.GAPS:
			_lay_turns(rng, rng.randi_range(2, 6), _small_angle(rng) * rng.randf_range(-1, 1))
			_open_gaps(rng)
		Shape.CROSSING:
			_lay_zigzag(rng)
			_lengthen(rng)
		Shape.DOUBLE:
			_lay_turns(rng, rng.randi_range(2, 6), _small_angle(rng) * rng.randf_range(-1, 1))
			_double(rng)
		Shape.TEE:
			_lay_turns(rng, rng.randi_range(2, 6), _small_angle(rng) * rng.randf_range(-1, 1))
			_hang(rng)
		Shape.TABLE:
			_add(Vec2.new(-200, 0), Vec2.new(0, 0))
			_add(Vec2.new(0, 0), Vec2.new(rng.randf_range(-5, 5), rng.randf_range(5, 200)))


# From 1e-12 to some radians.
func _small_angle(rng: RandomNumberGenerator) -> float:
	return 10.0 ** rng.randf_range(-12.0, 0.4)


func _add(from: Vec2, to: Vec2) -> void:
	if from.distance_to(to) > 0.0:
		lines.append(LineSegment.new(from, to))


# A chain whose pieces turn by the same angle, downwards where it is above 0.
func _lay_turns(rng: RandomNumberGenerator, count: int, turn: float) -> void:
	var angle := rng.randf_range(-0.8, 0.8)
	var at := Vec2.new(-100.0, 0.0)
	var is_whole := rng.randf() < 0.3
	for piece: int in count:
		var length := rng.randf_range(10.0, 120.0)
		if piece == 0:
			length = 100.0
		var next := at.plus(Vec2.unit_radians(angle).scaled(length))
		if is_whole:
			next = Vec2.new(roundf(next.x), roundf(next.y))
		_add(at, next)
		at = next
		angle += turn


func _lay_hills(rng: RandomNumberGenerator) -> void:
	var width := rng.randf_range(3.0, 20.0)
	var height := rng.randf_range(1.0, 40.0)
	for piece: int in 40:
		var from := Vec2.new(-100.0 + piece * width, height * sin(0.4 * piece))
		_add(from, Vec2.new(-100.0 + (piece + 1) * width, height * sin(0.4 * (piece + 1))))


func _lay_zigzag(rng: RandomNumberGenerator) -> void:
	var at := Vec2.new(-100.0, 0.0)
	for piece: int in rng.randi_range(2, 10):
		var next := at.plus(Vec2.new(rng.randf_range(1.0, 90.0), rng.randf_range(-60.0, 60.0)))
		if piece == 0:
			next.x = at.x + 100.0
		_add(at, next)
		at = next


func _lay_circle(rng: RandomNumberGenerator) -> void:
	var count := rng.randi_range(90, 360)
	var radius := rng.randf_range(60.0, 300.0)
	for piece: int in count:
		var one := Vec2.unit_radians(TAU * piece / count).scaled(radius)
		_add(one, Vec2.unit_radians(TAU * ((piece + 1) % count) / count).scaled(radius))


func _open_gaps(rng: RandomNumberGenerator) -> void:
	for line: LineSegment in lines:
		var gap := 10.0 ** rng.randf_range(-12.0, -3.0)
		line.start.add(Vec2.random_unit(rng).scaled(gap))


func _lengthen(rng: RandomNumberGenerator) -> void:
	for line: LineSegment in lines:
		line.end.add(line.end.minus(line.start).scaled(rng.randf_range(0.0, 0.3)))


func _double(rng: RandomNumberGenerator) -> void:
	for line: LineSegment in lines.duplicate():
		if rng.randf() < 0.5:
			_add(line.start.copy(), line.end.copy())
		elif rng.randf() < 0.5:
			_add(line.end.copy(), line.start.copy())
		else:
			var along := line.end.minus(line.start)
			_add(
				line.start.plus(along.scaled(0.25)),
				line.start.plus(along.scaled(rng.randf_range(0.5, 1.3)))
			)


func _hang(rng: RandomNumberGenerator) -> void:
	for line: LineSegment in lines.duplicate():
		var along := line.end.minus(line.start)
		var share: float = [0.0, 1.0, rng.randf()][rng.randi() % 3]
		var at := line.start.plus(along.scaled(share))
		_add(at, at.plus(Vec2.new(rng.randf_range(-30.0, 30.0), rng.randf_range(30.0, 90.0))))


# On the first line, above it, or inside the circle.
func _put_ball(rng: RandomNumberGenerator) -> void:
	var radius := 10.0 ** rng.randf_range(0.0, 1.3)
	var speed: float = [0.0, rng.randf_range(0.0, 60.0), rng.randf_range(0.0, 400.0)][
		rng.randi() % 3
	]
	var line := lines[0]
	if shape == Shape.CIRCLE_OUTSIDE:
		line = lines[int(lines.size() * rng.randf_range(0.65, 0.85))]
	elif shape == Shape.CIRCLE_INSIDE:
		line = lines[int(lines.size() * rng.randf_range(0.05, 0.45))]
	var along := line.end.minus(line.start).normalized()
	var normal := Vec2.new(along.y, -along.x)
	if normal.y > 0.0:
		normal = normal.negated()
	var at := line.start.lerped(line.end, rng.randf_range(0.0, 1.0))
	var height := 0.0
	if rng.randf() < 0.5:
		height = rng.randf_range(0.0, 60.0)
	at.add(normal.scaled(radius + height))
	var velocity := along.scaled(speed * signf(rng.randf() - 0.3))
	if height > 0.0:
		velocity = Vec2.random_unit(rng).scaled(speed)
	ball = Ball.new(at, radius, velocity)


func _move_all(way: Vec2) -> void:
	for line: LineSegment in lines:
		line.start.add(way)
		line.end.add(way)
	ball.position.add(way)
