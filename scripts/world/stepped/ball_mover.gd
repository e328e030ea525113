@abstract class_name BallMover
extends RefCounted
## Moves one ball among lines for one frame: the assignment of the lecture, part 16. Each way of
## stepping is a class of its own.

## Pixels per second. A slower approach is no bounce: it is the rounding of a ball that lies on a
## line.
const SLOWEST_BOUNCE := 1e-6

## The sentence with which the latest [method move] refused to move its ball to the end of the
## frame; "" if it did not.
var refusal := ""

## Moves [param ball] for [param seconds] and returns its bounces in order.
@abstract func move(ball: Ball, seconds: float, surroundings: Surroundings) -> Array[BounceRecord]


## The mover for a copy of the world: this mover, unless it remembers something about the balls.
func for_copy() -> BallMover:
	return self


## Whether a ball is pushed out of a line that was changed, before it moves on: the rule of overlap
## of lines with ends, see [PushOut].
func pushes_out() -> bool:
	return true


## Moves the ball along its free flight, without looking for lines.
func fly(ball: Ball, seconds: float, gravity: Vec2) -> void:
	ball.position.add(FreeFlight.motion(ball.velocity, gravity, seconds))
	ball.velocity = FreeFlight.velocity_after(ball.velocity, gravity, seconds)


## Moves the ball if no line is near its way, which is so for most balls in most frames. Returns
## false if a line is near; then the ball has not moved.
func fly_clear(ball: Ball, seconds: float, surroundings: Surroundings) -> bool:
	# FreeFlight.motion and velocity_after are written out, because most balls do this in most
	# frames: with the calls, a step of fifty balls took 1.4 times as long.
	var position := ball.position
	var velocity := ball.velocity
	var gravity := surroundings.gravity
	var half_square := seconds * seconds / 2.0
	var across := velocity.x * seconds + gravity.x * half_square
	var down := velocity.y * seconds + gravity.y * half_square
	if surroundings.near_segments(position, Vec2.new(across, down), ball.radius):
		return false
	position.x += across
	position.y += down
	velocity.x += gravity.x * seconds
	velocity.y += gravity.y * seconds
	return true


## Puts the ball at the point of impact of a flight of [param seconds], with the velocity that it
## has there.
func fly_to(ball: Ball, impact: Impact, seconds: float, gravity: Vec2) -> void:
	var way := impact.position.minus(ball.position)
	ball.velocity = FreeFlight.velocity_at(ball.velocity, gravity, way, seconds * impact.fraction)
	ball.position = impact.position


## Bounces the ball, which is at the point of impact, off what it touches, and adds a record to
## [param bounces]. A ball that does not approach keeps its velocity. An approach slower than
## [constant SLOWEST_BOUNCE] adds no record.
func bounce(ball: Ball, impact: Impact, bounciness: float, bounces: Array[BounceRecord]) -> void:
	var before := ball.velocity.copy()
	Bounce.apply(ball.velocity, impact.normal, bounciness)
	if -before.dot(impact.normal) < SLOWEST_BOUNCE:
		return
	var record := BounceRecord.new()
	record.position = ball.position.copy()
	record.normal = impact.normal
	record.fraction = impact.fraction
	record.velocity_before = before
	record.velocity_after = ball.velocity.copy()
	bounces.append(record)
