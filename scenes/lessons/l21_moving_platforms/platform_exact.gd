class_name PlatformExact
extends RefCounted
## The exact answers of the lesson on surfaces that move, to about 100 bits, for its readout.


## How far [param leaving] is from the exact v′, in px/s, for a ball with [param velocity] that
## meets the line of a wall along [param along], which moves with [param wall_velocity].
static func error_of_velocity(
	leaving: Vec2, velocity: Vec2, wall_velocity: Vec2, along: Vec2, bounciness: float
) -> float:
	var normal_x := DoubleDouble.from_float(-along.y)
	var normal_y := DoubleDouble.from_float(along.x)
	var seen_x := DoubleDouble.sum_of(velocity.x, -wall_velocity.x)
	var seen_y := DoubleDouble.sum_of(velocity.y, -wall_velocity.y)
	var size := normal_x.times(normal_x).plus(normal_y.times(normal_y))
	var push := seen_x.times(normal_x).plus(seen_y.times(normal_y))
	push = push.times(DoubleDouble.sum_of(1.0, bounciness)).divided(size)
	var exact_x := DoubleDouble.from_float(velocity.x).minus(push.times(normal_x))
	var exact_y := DoubleDouble.from_float(velocity.y).minus(push.times(normal_y))
	return Vec2.new(exact_x.error_of(leaving.x), exact_y.error_of(leaving.y)).length()


## How far [param rolling], in px/s, is from v - u / 3 on a level, for a disc with [param speed] on
## a surface with [param surface_speed].
static func error_of_rolling(rolling: float, speed: float, surface_speed: float) -> float:
	var slip := DoubleDouble.sum_of(speed, -surface_speed)
	var third := slip.divided(DoubleDouble.from_float(3.0))
	return DoubleDouble.from_float(speed).minus(third).error_of(rolling)


## How far [param seconds] is from the quotient [param way] / [param speed].
static func error_of_quotient(seconds: float, way: float, speed: float) -> float:
	var exact := DoubleDouble.from_float(way).divided(DoubleDouble.from_float(speed))
	return exact.error_of(seconds)
