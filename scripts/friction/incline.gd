class_name Incline
extends RefCounted
## A straight line or a belt on which gravity presses a ball: how the ball slides and rolls on it,
## in closed form, until it comes to an end or to a time. There is no rolling resistance.
##
## Along the line, from start to end, gravity pulls with G, and it presses with N > 0. The slip u is
## how fast the ball's lowest point rubs along the line or belt. Friction µ N works against it, and
## the slip changes by G - 3 µ N sign(u). When it has come to 0, the ball rolls if friction can hold
## it, 3 µ N >= abs(G): that is µ >= tan(angle) / 3, for then only two thirds of G move the ball.

## The smallest radius of a ball, in pixels.
const SMALLEST := 1e-70
## No number may be larger than this, in pixels, seconds and radians: else a product could be too
## large for a double.
const LARGEST := 1e70

## The part of gravity along the line, in px/s²; below 0 where it pulls to the start.
var pull := 0.0
## The part of gravity that presses the ball on the line, in px/s²; above 0.
var pressure := 0.0
## The line's length in pixels.
var length := 0.0
## From start to end; length 1.
var direction: Vec2
## 1.0 where a ball that rolls from start to end turns clockwise on screen, else -1.0.
var side := 1.0
## How fast the surface moves from start to end, in px/s; 0 for a line at rest.
var belt: float

var _segment: LineSegment
var _gravity: Vec2
var _friction: float


## The line [param segment] under [param gravity], in px/s², with the friction µ. The surface moves
## with [param belt_speed] px/s from start to end; 0 is a line at rest. The ball lies on the side
## from which gravity presses.
func _init(segment: LineSegment, gravity: Vec2, friction: float, belt_speed: float = 0.0) -> void:
	_segment = segment.copy()
	_gravity = gravity.copy()
	_friction = friction
	belt = belt_speed
	length = segment.length()
	var along := segment.along()
	direction = along.normalized()
	var across := along.cross(gravity)
	if length > 0.0:
		pull = along.dot(gravity) / length
		pressure = absf(across) / length
	side = 1.0 if across > 0.0 else -1.0


## "" if this can be used; otherwise one sentence with the value and what is allowed. Gravity along
## the line presses nothing on it, and so has no answer here.
func problem() -> String:
	for wrong: String in [
		_segment.problem(LARGEST),
		FreeFlight.problem_of_gravity(_gravity, LARGEST),
		Friction.problem_of(_friction),
		_problem_of_number("The speed of a belt", belt, "px/s"),
	]:
		if wrong:
			return wrong
	if not pressure > 0.0:
		return "Gravity must press on the line, but %s is along it." % _gravity
	return ""


## Whether a ball that does not slip goes on to roll.
func can_hold() -> bool:
	return Friction.YIELD * _friction * pressure >= absf(pull)


## How fast the lowest point of a ball rubs along the line, in px/s. [param speed] is that of the
## centre, from start to end.
func slip(radius: float, speed: float, spin: float) -> float:
	return speed - side * radius * spin - belt


## Where a ball is and how it moves when it comes to an end of the line, or after [param longest]
## seconds. It starts with its centre above the point [param distance] pixels from the start of the
## line, with [param speed] px/s from start to end, and [param spin]. What cannot be used is an
## error, and the ball stays as it was.
func run(radius: float, distance: float, speed: float, spin: float, longest: float) -> InclineRun:
	var ball := InclineRun.new(distance, speed, spin)
	if not _can_run(radius, distance, speed, spin, longest):
		return ball
	var first := phase(radius, slip(radius, speed, spin))
	if first.rolls:
		_begin_to_roll(ball)
	if not _goes_on(ball, first, longest):
		var last := phase(radius, 0.0)
		ball.regime = InclineRun.Regime.SLIPS_BACK
		if last.rolls:
			_begin_to_roll(ball)
		_goes_on(ball, last, longest)
	var fast := ball.leaves != InclineRun.End.NONE and ball.speed * ball.speed > pressure * radius
	ball.flies = fast
	return ball


## How a ball goes on whose lowest point rubs along the line with [param rubs] px/s. Where nothing
## rubs, it rolls if friction can hold it: then a third of the pull goes into the spin. Else it
## slips down.
func phase(radius: float, rubs: float) -> InclinePhase:
	var found := InclinePhase.new()
	if rubs == 0.0 and can_hold():
		found.rolls = true
		found.acceleration = pull - pull / Friction.YIELD
		found.turning = side * found.acceleration / radius
		return found
	var way := signf(rubs if rubs != 0.0 else pull)
	found.acceleration = _slip_acceleration(way)
	found.turning = _slip_spin(way, radius)
	# How fast the slip becomes less.
	var fades := Friction.YIELD * _friction * pressure - pull * way
	if rubs != 0.0 and fades > 0.0:
		found.lasts = absf(rubs) / fades
	return found


## The same as a game computes it, in frames of [param frame] seconds: friction against the slip,
## then the way. Nothing ends a slip at 0: it changes its sign from frame to frame, so the ball
## trembles and never rolls, and its end is late or early by a frame.
func run_by_frames(
	radius: float, distance: float, speed: float, spin: float, longest: float, frame: float
) -> InclineRun:
	var ball := InclineRun.new(distance, speed, spin)
	if not (frame > 0.0 and frame < INF):
		push_error("Incline: A frame must take more than 0 s, not %s s." % frame)
		return ball
	if not _can_run(radius, distance, speed, spin, longest):
		return ball
	while ball.time < longest and ball.distance >= 0.0 and ball.distance <= length:
		var rubs := signf(slip(radius, ball.speed, ball.spin))
		ball.move(frame, _slip_acceleration(rubs), _slip_spin(rubs, radius))
	if ball.distance < 0.0:
		ball.leaves = InclineRun.End.START
	elif ball.distance > length:
		ball.leaves = InclineRun.End.END
	return ball


func _begin_to_roll(ball: InclineRun) -> void:
	ball.regime = InclineRun.Regime.ROLLS
	ball.roll_time = ball.time


# How the speed and the spin of a ball change that slips in this direction, 1.0 or -1.0.
func _slip_acceleration(way: float) -> float:
	return pull - _friction * pressure * way


func _slip_spin(way: float, radius: float) -> float:
	return side * way * _friction * pressure / (Disc.INERTIA * radius)


# Moves the ball for the time that this part of its way lasts. Whether the run is over then.
func _goes_on(ball: InclineRun, now: InclinePhase, longest: float) -> bool:
	var acceleration := now.acceleration
	var to_start := FreeFlight.time_to_fall(ball.distance, ball.speed, acceleration)
	var to_end := FreeFlight.time_to_fall(length - ball.distance, -ball.speed, -acceleration)
	var to_leave := minf(to_start, to_end)
	var left := longest - ball.time
	if to_leave <= minf(now.lasts, left):
		ball.move(to_leave, acceleration, now.turning)
		ball.leaves = InclineRun.End.START if to_start <= to_end else InclineRun.End.END
		ball.distance = 0.0 if to_start <= to_end else length
		return true
	ball.move(minf(now.lasts, left), acceleration, now.turning)
	return left <= now.lasts


func _can_run(radius: float, distance: float, speed: float, spin: float, longest: float) -> bool:
	for wrong: String in [
		problem(),
		_problem_of_number("The ball's speed", speed, "px/s"),
		_problem_of_number("The ball's spin", spin, "rad/s"),
		_problem_of_start(radius, distance, longest),
	]:
		if wrong:
			push_error("Incline: " + wrong)
			return false
	return true


func _problem_of_start(radius: float, distance: float, longest: float) -> String:
	var limit := String.num_scientific(LARGEST)
	if not (radius >= SMALLEST and radius <= LARGEST):
		var values := [String.num_scientific(SMALLEST), limit, radius]
		return "A ball's radius must be within %s..%s px, not %s." % values
	if not (distance >= 0.0 and distance <= length):
		return "The ball must be 0..%s px from the start of the line, not %s." % [length, distance]
	if not (longest >= 0.0 and longest <= LARGEST):
		return "A run must take 0..%s s, not %s s." % [limit, longest]
	return ""


static func _problem_of_number(what: String, number: float, unit: String) -> String:
	if absf(number) <= LARGEST:
		return ""
	var limit := String.num_scientific(LARGEST)
	return "%s must be within -%s..%s %s, not %s." % [what, limit, limit, unit, number]
