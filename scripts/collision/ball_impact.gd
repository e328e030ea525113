class_name BallImpact
extends RefCounted
## The exact impact of two balls in straight flight, and both velocities after it.
##
## Seen from the second ball, the first one flies straight towards a point, with the sum of both
## radii as its radius. [StraightImpactFinder] finds the time in plain doubles. In a grazing impact
## the error of its last bits makes the normal far less exact. So Newton's method for |d + v t|² =
## R² improves the time in [DoubleDouble], and the normal and the velocities are computed from it:
## all are right to the last bits. Slow: about 0.1 ms.

# Each step of Newton's method doubles the number of right digits: from 16, or 8 in the worst
# grazing impact, to more than the 32 digits of a DoubleDouble.
const _STEPS := 3

## Whether the balls meet.
var hit := false
## Seconds until the impact; 0 where they touch or overlap already and approach.
var time := 0.0
## From the second ball to the first; length 1.
var normal: Vec2
## The first ball's velocity after the impact.
var velocity_one: Vec2
## The second ball's velocity after the impact.
var velocity_other: Vec2

var _time: DoubleDouble
var _difference: Array[DoubleDouble]
var _relative: Array[DoubleDouble]


## The first impact of two balls, which are not changed; [param bounciness] C is 0..1. Without an
## impact [member hit] is false, and the other members have no meaning. Two centres at the same
## place have no normal, and so no impact.
static func between(one: Ball, other: Ball, bounciness: float = 1.0) -> BallImpact:
	var impact := BallImpact.new()
	var finder := StraightImpactFinder.new()
	var to_one := one.position.minus(other.position)
	var velocity := one.velocity.minus(other.velocity)
	impact.hit = finder.with_point(
		to_one.x, to_one.y, velocity.x, velocity.y, one.radius + other.radius, 0.0, 0.0
	)
	if impact.hit:
		impact._find_exact_time(one, other, finder.time)
		impact._bounce(one, other, bounciness)
	return impact


func _find_exact_time(one: Ball, other: Ball, near: float) -> void:
	_difference = _minus(one.position, other.position)
	_relative = _minus(one.velocity, other.velocity)
	_time = DoubleDouble.from_float(near)
	if near > 0.0:
		var reach := DoubleDouble.sum_of(one.radius, other.radius)
		for step in _STEPS:
			_improve_time(reach)
	time = _time.to_float()


# t - f / f' with f = |d + v t|² - R² and f' = 2 (d + v t) . v, which is below 0 at the impact.
func _improve_time(reach: DoubleDouble) -> void:
	var contact := _contact()
	var excess := _dot(contact, contact).minus(reach.times(reach))
	var slope := _dot(contact, _relative)
	if slope.high < 0.0:
		_time = _time.minus(excess.divided(slope.plus(slope)))


func _bounce(one: Ball, other: Ball, bounciness: float) -> void:
	var contact := _contact()
	var squared := _dot(contact, contact)
	var distance := squared.square_root()
	normal = Vec2.new(
		contact[0].divided(distance).to_float(), contact[1].divided(distance).to_float()
	)
	# (1 + C) (v . n) n is (1 + C) (v . d) d / d².
	var share := DoubleDouble.sum_of(1.0, bounciness).times(_dot(_relative, contact))
	share = share.divided(squared.times(DoubleDouble.sum_of(one.mass, other.mass)))
	velocity_one = _changed(one.velocity, contact, share, -other.mass)
	velocity_other = _changed(other.velocity, contact, share, one.mass)


static func _changed(
	velocity: Vec2, contact: Array[DoubleDouble], share: DoubleDouble, mass: float
) -> Vec2:
	var factor := share.times(DoubleDouble.from_float(mass))
	var x := DoubleDouble.from_float(velocity.x).plus(contact[0].times(factor))
	var y := DoubleDouble.from_float(velocity.y).plus(contact[1].times(factor))
	return Vec2.new(x.to_float(), y.to_float())


# The vector from the second centre to the first at the impact.
func _contact() -> Array[DoubleDouble]:
	return [
		_difference[0].plus(_relative[0].times(_time)),
		_difference[1].plus(_relative[1].times(_time)),
	]


static func _minus(one: Vec2, other: Vec2) -> Array[DoubleDouble]:
	return [DoubleDouble.sum_of(one.x, -other.x), DoubleDouble.sum_of(one.y, -other.y)]


static func _dot(one: Array[DoubleDouble], other: Array[DoubleDouble]) -> DoubleDouble:
	return one[0].times(other[0]).plus(one[1].times(other[1]))
