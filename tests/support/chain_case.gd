class_name ChainCase
extends RefCounted
## A ball on a random chain of lines, and what must hold there in every way of stepping: time goes
## on, the ball is never inside a line, and its energy never grows. It is kept while nothing is
## lost.

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

const _SAMPLES := 60
const _FRAMES_PER_SECOND := 60.0
const _MOST_IMPACTS := 20_000
# An elastic ball makes some 200 000 of the lowest hops in a second.
const _MOST_IMPACTS_PER_SECOND := 300_000
const _EPSILON := 1.0 / 2.0 ** 52

## What kind of chain it is.
var kind: Kind
## The chain.
var lines: Array[LineSegment] = []
## Where the ball starts.
var ball: Ball
## C.
var bounciness := 1.0
## How long the ball is looked at.
var seconds := 2.0

# The largest energy of the motion so far, as a scale for what is lost.
var _scale := 0.0


## The case with this number; the same for the same number.
static func of(number: int) -> ChainCase:
	var rng := RandomNumberGenerator.new()
	rng.seed = number
	var made := ChainCase.new()
	made.kind = number % Kind.size() as Kind
	made.bounciness = [1.0, 0.5, 0.0, 0.9, rng.randf()][rng.randi() % 5]
	made._lay(rng)
	made._put_ball(rng)
	if number % 10 == 7:
		made._move_all(Vec2.random_unit(rng).scaled(10.0 ** rng.randf_range(3.0, 7.0)))
	return made


## The event world of this case.
func world() -> EventWorld:
	var made := EventWorld.new()
	made.most_impacts_per_second = _MOST_IMPACTS_PER_SECOND
	Refusal.push(made.set_gravity(Vec2.new(0.0, GRAVITY)))
	Refusal.push(made.set_bounciness(bounciness))
	Refusal.push(made.set_segments(lines))
	Refusal.push(made.set_balls([ball]))
	return made


## The event world of this case when [member seconds] are over.
func world_at_end() -> EventWorld:
	var made := world()
	Refusal.push(made.advance(seconds))
	return made


## Whether the ball is in no line at the start. What becomes of one that is, is another question.
func starts_outside() -> bool:
	return depth(ball.position) <= DEEPEST


## "" or what does not hold in the event world.
func problem() -> String:
	var flight := world()
	for sample: int in _SAMPLES:
		var refusal := flight.advance(seconds / _SAMPLES)
		if refusal:
			return refusal
		# Hops of a perfectly elastic ball are a case for patience, not for this test.
		if flight.impacts > _MOST_IMPACTS:
			return ""
		var found := _problem_at(flight.position(0), flight.velocity(0), true)
		if found:
			return "At %s s %s" % [flight.time, found]
	return ""


## "" or what does not hold where [param mover] moves the ball frame by frame. A mover that loses
## time may lose energy, too.
func stepped_problem(mover: BallMover) -> String:
	var stepped := SteppedWorld.new(mover)
	Refusal.push(stepped.surroundings.set_gravity(Vec2.new(0.0, GRAVITY)))
	Refusal.push(stepped.surroundings.set_bounciness(bounciness))
	Refusal.push(stepped.surroundings.set_segments(lines))
	Refusal.push(stepped.set_balls([ball]))
	for frame: int in roundi(_FRAMES_PER_SECOND * seconds):
		var before := stepped.balls[0].position.copy()
		var refusal := stepped.step(1.0 / _FRAMES_PER_SECOND)
		if refusal:
			return refusal
		if stepped.is_lost[0]:
			return ""
		var now := stepped.balls[0]
		var found := _problem_at(now.position, now.velocity, false)
		# A quick ball that bounces without loss can come back to where it was.
		var way := now.velocity.length() / _FRAMES_PER_SECOND
		if way > 0.1 and bounciness < 1.0 and now.position.distance_to(before) < 1e-3 * way:
			found = "it stands still at %s with v = %s." % [now.position, now.velocity]
		if found:
			return "In frame %d %s" % [frame, found]
	return ""


## How deep a ball at this place is inside a line, in pixels.
func depth(at: Vec2) -> float:
	var deepest := -INF
	for line: LineSegment in lines:
		deepest = maxf(deepest, ball.radius - line.closest_point(at).distance_to(at))
	return deepest


## As a person can build it again.
func text() -> String:
	var parts: PackedStringArray = []
	for line: LineSegment in lines.slice(0, 8):
		parts.append("%s to %s" % [line.start, line.end])
	return (
		"%s, C = %s, ball at %s, r = %s, v = %s; %d lines: %s"
		% [
			Kind.keys()[kind],
			bounciness,
			ball.position,
			ball.radius,
			ball.velocity,
			lines.size(),
			", ".join(parts)
		]
	)


# What is wrong with the ball at this place and velocity.
func _problem_at(at: Vec2, velocity: Vec2, is_exact: bool) -> String:
	var before := 0.5 * ball.velocity.length_squared()
	var now := 0.5 * velocity.length_squared() - GRAVITY * (at.y - ball.position.y)
	_scale = maxf(maxf(_scale, before + 50.0 * GRAVITY), 0.5 * velocity.length_squared())
	var last_places := 4.0 * _EPSILON * maxf(absf(at.x), absf(at.y))
	var tolerance := ENERGY * _scale + GRAVITY * last_places
	if now - before > tolerance:
		return "the energy has grown by %s." % (now - before)
	if is_exact and bounciness == 1.0 and before - now > tolerance:
		return "energy is lost: %s." % (before - now)
	var inside := depth(at)
	if inside > maxf(DEEPEST, last_places):
		return "the ball at %s is inside a line by %s px." % [at, inside]
	return ""


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
	if kind == Kind.CIRCLE_OUTSIDE:
		line = lines[int(lines.size() * rng.randf_range(0.65, 0.85))]
	elif kind == Kind.CIRCLE_INSIDE:
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
