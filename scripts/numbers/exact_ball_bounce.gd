class_name ExactBallBounce
extends RefCounted
## The bounce of two balls to about 100 bits: the exact answer for readouts.
##
## All numbers are taken as exact. They must be 0 or have a magnitude between 1e-70 and 1e70.


## The distance of [param value] from the exact velocity of ball [param one] after it has bounced
## off [param other]: v - (1 + C) m / M ((v - v of the other) · n) n with the other's mass m, the
## total mass M and the unit vector n along [param normal], which need not have length 1.
static func error_of(value: Vec2, one: Ball, other: Ball, normal: Vec2, bounciness: float) -> float:
	var change := _change(one, other, normal, bounciness)
	var error_of_x := _error_of(value.x, one.velocity.x, normal.x, change)
	var error_of_y := _error_of(value.y, one.velocity.y, normal.y, change)
	return Vec2.new(error_of_x, error_of_y).length()


# The factor of the normal.
static func _change(one: Ball, other: Ball, normal: Vec2, bounciness: float) -> DoubleDouble:
	var closing := ExactProjection.dot(one.velocity, normal).minus(
		ExactProjection.dot(other.velocity, normal)
	)
	var times := DoubleDouble.sum_of(1.0, bounciness).times(DoubleDouble.from_float(other.mass))
	var share := times.divided(DoubleDouble.sum_of(one.mass, other.mass))
	return share.times(closing).divided(ExactProjection.dot(normal, normal))


static func _error_of(
	value: float, component: float, normal_component: float, change: DoubleDouble
) -> float:
	var subtracted := change.times(DoubleDouble.from_float(normal_component))
	return DoubleDouble.from_float(component).minus(subtracted).error_of(value)
