class_name ChainCase
extends RefCounted
## A ball on a random chain of lines, and what must hold there in every way of stepping: time goes
## on, the ball is never inside a line, and its energy never grows and is kept while nothing is lost.

## The kinds of chains.
enum Kind {
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

const GRAVITY := 300.0
## The ball may be inside a line by this much, in pixels.
const DEEPEST := 1e-8
## Energy is kept within this share of the largest energy of the motion.
const ENERGY := 1e-9

var kind: Kind
var ball: Ball
var bounciness := 1.0
var seconds := 2.0
# Full precision: Vector4 has single precision.
var points: Array[LineSegment] = []


## The case with this number; the same for the same number.
static func of(number: int) -> ChainCase:
	var rng := RandomNumberGenerator.new()
	rng.seed = number
	var made := ChainCase.new()
	made.kind = number % Kind.size() as Kind
	made.bounciness = [1.0, 0.5, 0.0, 0.9, rng.randf()][rng.randi() % 5]
	made._lay(rng)
	made._put_ball(rng)
	return made


## The event world of this case.
func world() -> EventWorld:
	var made := EventWorld.new()
	Refusal.push(made.set_gravity(Vec2.new(0.0, GRAVITY)))
	Refusal.push(made.set_bounciness(bounciness))
	Refusal.push(made.set_segments(points))
	Refusal.push(made.set_balls([ball]))
	return made


## "" or what does not hold in the event world.
func problem(samples: int = 60) -> String:
	var flight := world()
	var energy := flight.energy()
	var scale := 0.5 * ball.velocity.length_squared() + GRAVITY * 50.0
	for sample: int in samples:
		var refusal := flight.advance(seconds / samples)
		if refusal:
			return refusal
		if flight.impacts > 20_000:
			return ""
		var at := flight.position(0)
		var now := flight.energy()
		scale = maxf(scale, 0.5 * flight.velocity(0).length_squared())
		if now - energy > ENERGY * scale:
			return "At %s s the energy has grown by %s." % [flight.time, now - energy]
		if bounciness == 1.0 and energy - now > ENERGY * scale:
			return "At %s s energy is lost: %s." % [flight.time, energy - now]
		var inside := depth(at)
		if inside > DEEPEST:
			return "At %s s the ball at %s is inside a line by %s px." % [flight.time, at, inside]
	return ""


## How deep a ball at this place is inside a line, in pixels.
func depth(at: Vec2) -> float:
	var deepest := -INF
	for line: LineSegment in points:
		deepest = maxf(deepest, ball.radius - line.closest_point(at).distance_to(at))
	return deepest


## As a person can build it again.
func text() -> String:
	var parts: PackedStringArray = []
	for line: LineSegment in points.slice(0, 8):
		parts.append("%s to %s" % [line.start, line.end])
	return (
		"%s, C = %s, ball at %s, r = %s, v = %s; %d lines: %s"
		% [
			Kind.keys()[kind],
			bounciness,
			ball.position,
			ball.radius,
			ball.velocity,
			points.size(),
			", ".join(parts)
		]
	)


func _lay(rng: RandomNumberGenerator) -> void:
	match kind:
		Kind.STRAIGHT:
			_lay_turns(rng, rng.randi_range(2, 12), 0.0)
		Kind.CONVEX:
			_lay_turns(rng, rng.randi_range(2, 8), _small_angle(rng))
		Kind.CONCAVE:
			_lay_turns(rng, rng.randi_range(2, 8), -_small_angle(rng))
		Kind.HILLS:
			_lay_hills(rng)
		Kind.ZIGZAG:
			_lay_zigzag(rng)
		Kind.CIRCLE_OUTSIDE, Kind.CIRCLE_INSIDE:
			_lay_circle(rng)
		Kind.GAPS:
			_lay_turns(rng, rng.randi_range(2, 6), _small_angle(rng) * rng.randf_range(-1, 1))
			_open_gaps(rng)
		Kind.CROSSING:
			_lay_zigzag(rng)
			_lengthen(rng)
		Kind.DOUBLE:
			_lay_turns(rng, rng.randi_range(2, 6), _small_angle(rng) * rng.randf_range(-1, 1))
			_double(rng)
		Kind.TEE:
			_lay_turns(rng, rng.randi_range(2, 6), _small_angle(rng) * rng.randf_range(-1, 1))
			_hang(rng)
		Kind.TABLE:
			_add(Vec2.new(-200, 0), Vec2.new(0, 0))
			_add(Vec2.new(0, 0), Vec2.new(rng.randf_range(-5, 5), rng.randf_range(5, 200)))


# From 1e-12 to some radians.
func _small_angle(rng: RandomNumberGenerator) -> float:
	return 10.0 ** rng.randf_range(-12.0, 0.4)


func _add(from: Vec2, to: Vec2) -> void:
	if from.distance_to(to) > 0.0:
		points.append(LineSegment.new(from, to))


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
	for line: LineSegment in points:
		var gap := 10.0 ** rng.randf_range(-12.0, -3.0)
		line.start.add(Vec2.random_unit(rng).scaled(gap))


func _lengthen(rng: RandomNumberGenerator) -> void:
	for line: LineSegment in points:
		line.end.add(line.end.minus(line.start).scaled(rng.randf_range(0.0, 0.3)))


func _double(rng: RandomNumberGenerator) -> void:
	for line: LineSegment in points.duplicate():
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
	for line: LineSegment in points.duplicate():
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
	var line := points[0]
	if kind == Kind.CIRCLE_OUTSIDE:
		line = points[int(points.size() * rng.randf_range(0.65, 0.85))]
	elif kind == Kind.CIRCLE_INSIDE:
		line = points[int(points.size() * rng.randf_range(0.05, 0.45))]
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


## "" or what does not hold where [param mover] moves the ball frame by frame: it stands still
## although it is fast, is inside a line, or gains energy.
func stepped_problem(mover: BallMover, may_gain: bool = false) -> String:
	var stepped := SteppedWorld.new(mover)
	Refusal.push(stepped.surroundings.set_gravity(Vec2.new(0.0, GRAVITY)))
	Refusal.push(stepped.surroundings.set_bounciness(bounciness))
	Refusal.push(stepped.surroundings.set_segments(points))
	Refusal.push(stepped.set_balls([ball]))
	var energy := stepped.energy()
	var scale := 0.5 * ball.velocity.length_squared() + GRAVITY * 50.0
	for frame: int in roundi(60.0 * seconds):
		var before := stepped.balls[0].position.copy()
		var refusal := stepped.step(1.0 / 60.0)
		if refusal:
			return refusal
		var at := stepped.balls[0].position
		if stepped.is_lost[0]:
			return ""
		var speed := stepped.balls[0].velocity.length()
		var now := stepped.energy()
		scale = maxf(scale, 0.5 * speed * speed)
		if now - energy > ENERGY * scale and not may_gain:
			return "In frame %d the energy has grown by %s." % [frame, now - energy]
		if speed > 1.0 and at.distance_to(before) < 1e-3 * speed / 60.0 and bounciness < 1.0:
			return (
				"In frame %d it stands still at %s with v = %s."
				% [frame, at, stepped.balls[0].velocity]
			)
		var inside := depth(at)
		if inside > DEEPEST:
			return "In frame %d the ball at %s is inside a line by %s px." % [frame, at, inside]
	return ""
