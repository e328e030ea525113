class_name ExactFrictionBounce
extends RefCounted
## The bounce with friction to about 100 bits: the exact answer for readouts. A disc bounces off a
## line, or off an equal disc that rests and does not turn.
##
## All numbers are taken as exact. They must be 0 or have a magnitude between 1e-30 and 1e30.

var _ball: Ball
# Components of the unit tangent.
var _tangent_x: DoubleDouble
var _tangent_y: DoubleDouble
# The impulses along the normal and along the tangent, per mass.
var _push: DoubleDouble
var _grip: DoubleDouble


## The bounce of [param ball] on a surface along [param along], of any length above 0: the ball is
## on the side of the normal (y, -x) of this direction, and approaches. [param bounciness] C is
## 0..1, [param friction] µ is 0 or more.
func _init(ball: Ball, along: Vec2, bounciness: float, friction: float) -> void:
	_ball = ball
	var length := ExactProjection.dot(along, along).square_root()
	_tangent_x = DoubleDouble.from_float(along.x).divided(length)
	_tangent_y = DoubleDouble.from_float(along.y).divided(length)
	var normal := Vec2.new(along.y, -along.x)
	var closing := ExactProjection.dot(ball.velocity, normal).divided(length)
	_push = DoubleDouble.sum_of(1.0, bounciness).times(closing).negated()
	var along_speed := ExactProjection.dot(ball.velocity, along).divided(length)
	var slip := along_speed.minus(DoubleDouble.product_of(ball.radius, ball.spin))
	_grip = _grip_against(slip, DoubleDouble.from_float(friction).times(_push))


## The distance of [param value] from the exact velocity after a bounce off a line, in px/s.
func error_of(value: Vec2) -> float:
	var change := _change()
	return _distance(value, _sum(_ball.velocity.x, change[0]), _sum(_ball.velocity.y, change[1]))


## The error of [param value] as the spin after that, in rad/s.
func error_of_spin(value: float) -> float:
	return _sum(_ball.spin, _turn(-2.0)).error_of(value)


## The distance of [param value] from the exact velocity that an equal disc gets, in px/s.
func error_of_other(value: Vec2) -> float:
	var half := DoubleDouble.from_float(-0.5)
	var change := _change()
	return _distance(value, change[0].times(half), change[1].times(half))


## The error of [param value] as the spin that it gets, in rad/s.
func error_of_other_spin(value: float) -> float:
	return _turn(-1.0).error_of(value)


# A third of the slip where the surfaces stick, else all that friction can be.
static func _grip_against(slip: DoubleDouble, limit: DoubleDouble) -> DoubleDouble:
	var third := slip.divided(DoubleDouble.from_float(3.0))
	var size := third if third.high >= 0.0 else third.negated()
	if not limit.is_less_than(size):
		return third.negated()
	return limit.negated() if slip.high > 0.0 else limit


# The change of the velocity by the whole impulse, as x and y.
func _change() -> Array[DoubleDouble]:
	return [
		_push.times(_tangent_y).plus(_grip.times(_tangent_x)),
		_grip.times(_tangent_y).minus(_push.times(_tangent_x)),
	]


# So many times grip / r.
func _turn(factor: float) -> DoubleDouble:
	var times := _grip.times(DoubleDouble.from_float(factor))
	return times.divided(DoubleDouble.from_float(_ball.radius))


static func _sum(value: float, change: DoubleDouble) -> DoubleDouble:
	return DoubleDouble.from_float(value).plus(change)


static func _distance(value: Vec2, x: DoubleDouble, y: DoubleDouble) -> float:
	return Vec2.new(x.error_of(value.x), y.error_of(value.y)).length()
