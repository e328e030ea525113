class_name PulledMeeting
extends RefCounted
## When two balls meet of which one is pulled as seen from the other, because one of them lies or
## slides on something.

# Shorter by some last places.
const _JUST_CLEAR := 1.0 - 1.0 / 2.0 ** 46

## Seconds until they meet; means something only after [method is_found] has found it.
var time := INF

var _finder := AcceleratedImpactFinder.new()
var _x := 0.0
var _y := 0.0
var _velocity_x := 0.0
var _velocity_y := 0.0
var _pull_x := 0.0
var _pull_y := 0.0


## The flight of one ball as seen from the other: place in pixels, velocity in px/s and pull in
## px/s^2.
func set_flight(
	x: float, y: float, velocity_x: float, velocity_y: float, pull_x: float, pull_y: float
) -> void:
	_x = x
	_y = y
	_velocity_x = velocity_x
	_velocity_y = velocity_y
	_pull_x = pull_x
	_pull_y = pull_y


## Whether they meet within [param horizon] seconds; they touch where their centres are
## [param reach] pixels apart.
func is_found(reach: float, horizon: float) -> bool:
	var distance := sqrt(_x * _x + _y * _y)
	# The same rule as for a ball that lies on a cap: SegmentScan._lies_on.
	if absf(distance - reach) <= SegmentScan.TOUCH:
		var away := (_velocity_x * _x + _velocity_y * _y) / distance
		var around := (_velocity_x * _y - _velocity_y * _x) / distance
		var inwards := -(_pull_x * _x + _pull_y * _y) / distance - around * around / distance
		if inwards > 0.0 and away * away <= 2.0 * inwards * SegmentScan.TOUCH:
			time = 2.0 * maxf(away, 0.0) / inwards
			return true
		if away > 0.0:
			# They touch and part: taken as just clear of each other, so that rounding cannot find
			# this touch again.
			reach = distance * _JUST_CLEAR
	_finder.set_flight(_x, _y, _velocity_x, _velocity_y, _pull_x, _pull_y, reach)
	if not _finder.with_point(0.0, 0.0, horizon):
		return false
	time = _finder.time
	return true
