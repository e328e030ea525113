class_name WrongRun
extends RefCounted
## How a mistake lets the ball run: with one acceleration, and from some moment on with another. It
## never runs back: a ball that is slowed down stops.

## Its speed at the start, in px/s.
var first_speed: float
## Its acceleration from the start, in px/s².
var first: float
## When the other acceleration begins, in seconds; INF for never.
var change: float
## The other acceleration, in px/s².
var second: float


## Starts with [param speed] px/s.
func _init(
	speed: float, first_acceleration: float, change_after: float, second_acceleration: float
) -> void:
	first_speed = speed
	first = first_acceleration
	change = change_after
	second = second_acceleration


## A ball that rolls when its slip has come to 0, as a body does of which the slip takes
## [param yield_of_slip] times the friction [param grip], in px/s², under the pull [param pull];
## 3 for a disc, 3.5 for a solid sphere.
static func that_rolls(speed: float, pull: float, grip: float, yield_of_slip: float) -> WrongRun:
	var fades := yield_of_slip * grip - pull
	var slips := pull - grip
	if fades < 0.0 or fades == 0.0 and speed > 0.0:
		return WrongRun.new(speed, slips, INF, slips)
	var change_after := speed / fades if speed > 0.0 else 0.0
	return WrongRun.new(speed, slips, change_after, pull - pull / yield_of_slip)


## A ball that is slowed down by [param grip] as long as it moves.
static func that_stops(speed: float, pull: float, grip: float) -> WrongRun:
	var slows := pull - grip
	if slows >= 0.0:
		return WrongRun.new(speed, slows, INF, slows)
	return WrongRun.new(speed, slows, -speed / slows, 0.0)


## Pixels from the start after [param seconds].
func distance_after(seconds: float) -> float:
	var before := minf(seconds, change)
	var way := (first_speed + 0.5 * first * before) * before
	var rest := seconds - before
	if rest > 0.0:
		way += (_speed_at_change() + 0.5 * second * rest) * rest
	return way


## Seconds until it has come [param length] pixels far; INF for never.
func time_to(length: float) -> float:
	var before := FreeFlight.time_to_fall(length, -first_speed, -first)
	if before <= change:
		return before
	var left := length - distance_after(change)
	return change + FreeFlight.time_to_fall(left, -_speed_at_change(), -second)


## Whether it stands still from [member change] on.
func stops() -> bool:
	return change < INF and second == 0.0 and _speed_at_change() == 0.0


# What is slowed down to 0 has no speed left by rounding.
func _speed_at_change() -> float:
	var speed := first_speed + first * change
	return speed if speed > 1e-12 * first_speed else 0.0
