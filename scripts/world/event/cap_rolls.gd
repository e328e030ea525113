class_name CapRolls
extends RefCounted
## The ways of balls that gravity holds on the round end of a segment, its cap: each slides over it
## without friction until it flies off, comes onto the line, or is back where it started.
##
## [CapSlide] tells exactly where such a ball is at any time, on a circle that no constant
## acceleration follows. An [EventWorld] searches for impacts only along flights under a constant
## acceleration. So the way is cut into short pieces: each is a flight between two exact places, and
## stays so near to the circle that nobody sees the difference.
##
## The methods that move a ball leave its place, velocity and acceleration in the fields below.

## A piece is nowhere farther off the circle than this, in pixels.
const OFF_CIRCLE := 1e-8
## A ball that comes onto the line, or to the end of its way, within this time is there, in seconds.
const LINE_TIME := 1e-9

## x of the ball's centre, in pixels.
var x := 0.0
## y of the ball's centre.
var y := 0.0
## x of its velocity, in px/s.
var velocity_x := 0.0
## y of its velocity.
var velocity_y := 0.0
## x of the constant acceleration of the piece, in px/s².
var pull_x := 0.0
## y of the acceleration.
var pull_y := 0.0
## How long the piece takes, in seconds.
var piece_seconds := 0.0

## The way of each ball over a cap, null for one that was on none so far. A way never changes, so
## copies of this list may share it.
var slides: Array[CapSlide] = []

# When each way began, in seconds of the world, as the sum of two numbers.
var _start: PackedFloat64Array = []
var _start_low: PackedFloat64Array = []
# Seconds from then until the ball comes onto the line; INF if its way ends before.
var _line_time: PackedFloat64Array = []
# The velocity of the cap, in px/s.
var _drift_x: PackedFloat64Array = []
var _drift_y: PackedFloat64Array = []


## Makes room for this many balls.
func resize(count: int) -> void:
	slides.resize(count)
	for numbers: PackedFloat64Array in arrays():
		numbers.resize(count)


## All arrays that change while balls move, to be kept and put back, beside [member slides].
func arrays() -> Array[PackedFloat64Array]:
	return [_start, _start_low, _line_time, _drift_x, _drift_y]


## Begins the way [param slide] of a ball at this time of the world, over a cap that moves with this
## velocity, in px/s. Add the lines that end at the same point by [method end_at_line].
func begin(
	ball: int, slide: CapSlide, time: float, time_low: float, drift_x := 0.0, drift_y := 0.0
) -> void:
	slides[ball] = slide
	_start[ball] = time
	_start_low[ball] = time_low
	_line_time[ball] = INF
	_drift_x[ball] = drift_x
	_drift_y[ball] = drift_y


## The way of a ball ends where it comes onto a line as well: one that begins at the point about
## which the ball goes, and has this direction. The ball comes onto it where it moves in this
## direction.
func end_at_line(ball: int, along_x: float, along_y: float) -> void:
	var turn := slides[ball].turn
	var seconds := slides[ball].time_to_direction(turn * along_y, -turn * along_x)
	_line_time[ball] = minf(_line_time[ball], seconds)


## Seconds since a ball began its way, at this time of the world.
func seconds_since(ball: int, time: float, time_low: float) -> float:
	return (time - _start[ball]) + (time_low - _start_low[ball])


## Seconds from the beginning of a ball's way to its end, where it flies off, comes onto the line or
## is back.
func duration(ball: int) -> float:
	return minf(slides[ball].end_time, _line_time[ball])


## Whether the way of a ball leads back to where it began.
func leads_back(ball: int) -> bool:
	return slides[ball].ending == CapSlide.Ending.RETURNS


## Moves a ball to where it is this many seconds after it began its way.
func move_to(ball: int, seconds: float) -> void:
	_slide_to(ball, seconds)
	_drift(ball, seconds)


## Begins the piece that starts this many seconds after the ball began its way; the strength of
## gravity in px/s².
func begin_piece(ball: int, seconds: float, gravity: float, radius: float) -> void:
	_slide_to(ball, seconds)
	if slides[ball].ending == CapSlide.Ending.NEVER and velocity_x == 0.0 and velocity_y == 0.0:
		# It lies on the top for ever.
		piece_seconds = INF
		pull_x = 0.0
		pull_y = 0.0
		_drift(ball, seconds)
		return
	piece_seconds = minf(_longest_piece(gravity, radius), duration(ball) - seconds)
	var slide := slides[ball]
	slide.move_to(seconds + piece_seconds)
	pull_x = 2.0 * ((slide.position_x - x) / piece_seconds - velocity_x) / piece_seconds
	pull_y = 2.0 * ((slide.position_y - y) / piece_seconds - velocity_y) / piece_seconds
	_drift(ball, seconds)


# Where the ball is as seen from the cap.
func _slide_to(ball: int, seconds: float) -> void:
	var slide := slides[ball]
	slide.move_to(seconds)
	x = slide.position_x
	y = slide.position_y
	velocity_x = slide.velocity_x
	velocity_y = slide.velocity_y


# The cap moves on, and the ball with it.
func _drift(ball: int, seconds: float) -> void:
	if _drift_x[ball] != 0.0 or _drift_y[ball] != 0.0:
		x += _drift_x[ball] * seconds
		y += _drift_y[ball] * seconds
		velocity_x += _drift_x[ball]
		velocity_y += _drift_y[ball]


# A flight with the same start, velocity and end as the slide is off it by jerk t³ / 40 at most.
# The jerk grows with the speed, so the one at the end of the piece counts.
func _longest_piece(gravity: float, radius: float) -> float:
	var speed := sqrt(velocity_x * velocity_x + velocity_y * velocity_y)
	var seconds := 0.0
	for estimate in 2:
		var turning := (speed + gravity * seconds) / radius
		var jerk := (3.0 * gravity + radius * turning * turning) * turning
		seconds = pow(40.0 * OFF_CIRCLE / maxf(jerk, gravity * OFF_CIRCLE), 1.0 / 3.0)
	return seconds
