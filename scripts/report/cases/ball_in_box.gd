class_name BallInBox
extends RefCounted
## One elastic ball in a rectangular box without gravity, and its exact position at any time.
##
## Unfolded at each bounce, the path is straight: each coordinate of the centre is x0 + v t, folded
## back into the box. It is computed with 106 bits, so that the answer is right to 1e-20 px.

## Upper left corner, in pixels.
const LEFT := -300.0
## See [constant LEFT].
const TOP := -200.0
## Lower right corner, in pixels.
const RIGHT := 300.0
## See [constant RIGHT].
const BOTTOM := 200.0
## The ball's radius, in pixels.
const RADIUS := 10.0
## The start of the ball's centre, in pixels.
const START_X := -176.625
## See [constant START_X].
const START_Y := -112.375

# In radians on screen. The path has no symmetry, meets no corner and does not graze a wall.
const _DIRECTION := 0.7


## The ball at its start, with a speed in pixels per second.
static func ball(speed: float) -> Ball:
	var velocity := Vec2.unit_radians(_DIRECTION).scaled(speed)
	return Ball.new(Vec2.new(START_X, START_Y), RADIUS, velocity)


## The walls, clockwise from the upper left corner.
static func walls() -> Array[LineSegment]:
	var corners: Array[Vec2] = [
		Vec2.new(LEFT, TOP), Vec2.new(RIGHT, TOP), Vec2.new(RIGHT, BOTTOM), Vec2.new(LEFT, BOTTOM)
	]
	var found: Array[LineSegment] = []
	for i in corners.size():
		found.append(LineSegment.new(corners[i], corners[(i + 1) % corners.size()]))
	return found


## The distance in pixels between [param position] and the exact position of the [method ball] after
## [param seconds]; [constant Measurement.NO_ANSWER] if the position is outside the box.
static func error_of(position: Vec2, speed: float, seconds: float) -> float:
	if not (_is_inside(position.x, LEFT, RIGHT) and _is_inside(position.y, TOP, BOTTOM)):
		return Measurement.NO_ANSWER
	var velocity := ball(speed).velocity
	var x := folded(START_X, velocity.x, seconds, LEFT + RADIUS, RIGHT - RADIUS)
	var y := folded(START_Y, velocity.y, seconds, TOP + RADIUS, BOTTOM - RADIUS)
	return Vec2.new(x.error_of(position.x), y.error_of(position.y)).length()


## The position after [param seconds] of a point that moves to and fro between [param low] and
## [param high], with [param start] between them.
static func folded(
	start: float, velocity: float, seconds: float, low: float, high: float
) -> DoubleDouble:
	var room := DoubleDouble.sum_of(high, -low)
	var there_and_back := room.plus(room)
	var way := DoubleDouble.product_of(velocity, seconds).plus(DoubleDouble.sum_of(start, -low))
	var rounds := floorf(way.to_float() / there_and_back.to_float())
	way = way.minus(there_and_back.times(DoubleDouble.from_float(rounds)))
	if way.minus(room).to_float() > 0.0:
		way = there_and_back.minus(way)
	return way.plus(DoubleDouble.from_float(low))


# The engine's bodies keep a margin to a wall or sink into it. So a ball is outside only if its
# centre is beyond the wall.
static func _is_inside(value: float, low: float, high: float) -> bool:
	return value > low and value < high
