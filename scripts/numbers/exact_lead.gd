class_name ExactLead
extends RefCounted
## The moment at which a bullet that is aimed ahead touches its target, to about 100 bits: the exact
## answer for readouts.
##
## All numbers that are given are taken as exact. After t seconds the bullet touches where
## q(t) = |P + V t|² - (R + s t)² is 0. Newton's method in [DoubleDouble] starts at a moment that is
## nearly right.

# Each one doubles the digits: two are enough, and two more for a start with few of them.
const _ITERATIONS := 4

var _way_x: DoubleDouble
var _way_y: DoubleDouble
var _velocity_x: DoubleDouble
var _velocity_y: DoubleDouble
var _speed: DoubleDouble
var _radius: DoubleDouble


## A bullet from [param shooter] with [param shooter_velocity], which has [param speed] relative to
## it, and a target at [param target] with [param velocity]; both together have the radius
## [param radius]. Pixels and pixels per second, each 0 or between 1e-70 and 1e70 in size.
func _init(
	shooter: Vec2,
	shooter_velocity: Vec2,
	target: Vec2,
	velocity: Vec2,
	speed: float,
	radius: float
) -> void:
	_way_x = DoubleDouble.sum_of(target.x, -shooter.x)
	_way_y = DoubleDouble.sum_of(target.y, -shooter.y)
	_velocity_x = DoubleDouble.sum_of(velocity.x, -shooter_velocity.x)
	_velocity_y = DoubleDouble.sum_of(velocity.y, -shooter_velocity.y)
	_speed = DoubleDouble.from_float(speed)
	_radius = DoubleDouble.from_float(radius)


## The error of [param time], in seconds, as the root of q that is next to [param near]: above 0 if
## it is too late. Where both roots are one, as for a bullet that only grazes, it has half of the
## digits.
func error_of(time: float, near: float) -> float:
	return root_near(near).error_of(time)


## The root of q that is next to [param near], in seconds.
func root_near(near: float) -> DoubleDouble:
	var root := DoubleDouble.from_float(near)
	for iteration: int in _ITERATIONS:
		var x := _way_x.plus(_velocity_x.times(root))
		var y := _way_y.plus(_velocity_y.times(root))
		var reach := _radius.plus(_speed.times(root))
		var value := x.times(x).plus(y.times(y)).minus(reach.times(reach))
		var growth := x.times(_velocity_x).plus(y.times(_velocity_y)).minus(reach.times(_speed))
		if growth.high == 0.0:
			break
		root = root.minus(value.divided(growth.times(DoubleDouble.from_float(2.0))))
	return root
