class_name BallInBox
extends RefCounted
## One elastic ball in a rectangular box without gravity, and where it is exactly after any time.
##
## Unfolded at each bounce, the path is straight: each coordinate of the centre runs to and fro in
## its room by x0 + v t alone, folded back. That is computed with 106 bits, so the answer itself is
## right to 1e-20 px.

## Upper left corner, in pixels.
const LEFT := -300.0
## See [constant LEFT].
const TOP := -200.0
## Lower right corner, in pixels.
const RIGHT := 300.0
## See [constant RIGHT].
const BOTTOM := 200.0
## Pixels.
const RADIUS := 10.0
## Where the ball's centre begins, in pixels.
const START_X := -176.625
## See [constant START_X].
const START_Y := -112.375

# Radians on screen. No symmetry, no corner, no grazing.
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


## How far [param position] is from where a ball of [method ball] is exactly after [param seconds],
## in pixels; [constant Measurement.NO_ANSWER] where it has left the box.
static func error_of(position: Vec2, speed: float, seconds: float) -> float:
	if not (_is_inside(position.x, LEFT, RIGHT) and _is_inside(position.y, TOP, BOTTOM)):
		return Measurement.NO_ANSWER
	var velocity := ball(speed).velocity
	var x := folded(START_X, velocity.x, seconds, LEFT + RADIUS, RIGHT - RADIUS)
	var y := folded(START_Y, velocity.y, seconds, TOP + RADIUS, BOTTOM - RADIUS)
	return Vec2.new(x.error_of(position.x), y.error_of(position.y)).length()


## Where a point is after [param seconds] that runs to and fro between [param low] and [param high]
## from [param start] on, which lies between them.
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


# The engine's bodies stay off a wall by a margin or sink into it: outside is beyond the wall.
static func _is_inside(value: float, low: float, high: float) -> bool:
	return value > low and value < high
