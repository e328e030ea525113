class_name ExactTimedShot
extends RefCounted
## When a fixed barrel fires at a target on a line, to about 100 bits: the exact answer for
## readouts. All numbers that are given are taken as exact.
##
## With P from the muzzle to the target, W the bullet's velocity and v the target's, the flight is
## P × v / (W × v), and the moment to fire P × (W - v) / (W × v).

var _fire := DoubleDouble.from_float(0.0)
var _flight := DoubleDouble.from_float(0.0)


## A bullet from [param muzzle] with the velocity [param bullet], and a target at [param target] at
## time 0 with [param velocity]. Pixels and px/s, each 0 or between 1e-140 and 1e140 in size. The
## two velocities must not be parallel: that is an error.
func _init(muzzle: Vec2, bullet: Vec2, target: Vec2, velocity: Vec2) -> void:
	var way_x := DoubleDouble.sum_of(target.x, -muzzle.x)
	var way_y := DoubleDouble.sum_of(target.y, -muzzle.y)
	var across := _cross(
		DoubleDouble.from_float(bullet.x), DoubleDouble.from_float(bullet.y), velocity
	)
	if across.high == 0.0:
		push_error("The ways of bullet %s and target %s are parallel." % [bullet, velocity])
		return
	_flight = _cross(way_x, way_y, velocity).divided(across)
	var whole := _cross(way_x, way_y, bullet).minus(_cross(way_x, way_y, velocity))
	_fire = whole.divided(across)


## The error of [param seconds], taken as the moment to fire: above 0 if it is too late.
func error_of_fire(seconds: float) -> float:
	return _fire.error_of(seconds)


## The error of [param seconds], taken as the flight: above 0 if it is too long.
func error_of_flight(seconds: float) -> float:
	return _flight.error_of(seconds)


static func _cross(x: DoubleDouble, y: DoubleDouble, other: Vec2) -> DoubleDouble:
	var ahead := x.times(DoubleDouble.from_float(other.y))
	return ahead.minus(y.times(DoubleDouble.from_float(other.x)))
