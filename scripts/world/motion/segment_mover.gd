class_name SegmentMover
extends RefCounted
## One segment of [MovingSegments] and its motion: where it is and how it moves at a time of the
## world.

## The motion that it was given.
var motion: MotionPieces
## The segment at the time 0 of its motion.
var given: LineSegment
## Which piece of its motion lasts, at the time of the last [method go_to].
var piece := 0
## The seconds of its motion then.
var seconds := 0.0
## How far it is from where it was at the time 0, in pixels; means nothing if it turns.
var way := Vec2.zero()
## Its velocity, in pixels per second; of one that turns, that of its pivot.
var velocity := Vec2.zero()

# The time 0 of its motion, in seconds of the world, as the sum of two numbers.
var _start: float
var _start_low: float


## A segment that begins this motion at a time of the world, which is the sum of two numbers.
func _init(segment: LineSegment, given_motion: MotionPieces, time: float, low: float) -> void:
	given = segment.copy()
	motion = given_motion
	_start = time
	_start_low = low


## Takes note of how it moves at this time of the world.
func go_to(time: float, low: float) -> void:
	seconds = (time - _start) + (low - _start_low)
	piece = motion.piece_at(seconds)
	velocity = motion.velocity_of(piece)
	way = motion.way_of(piece).plus(velocity.scaled(seconds - motion.piece_begin(piece)))


## For how many seconds it goes on as it does now.
func seconds_left() -> float:
	return maxf(motion.piece_end(piece) - seconds, 0.0)


## Where it is now.
func segment_now() -> LineSegment:
	if motion.turn != 0.0:
		return _turning_from_start().segment_at(seconds)
	return segment_after(way)


## Where it is when it has moved so far from where it was at the time 0, in pixels.
func segment_after(so_far: Vec2) -> LineSegment:
	return LineSegment.new(given.start.plus(so_far), given.end.plus(so_far))


## The segment that turns, from now on.
func turning() -> TurningSegment:
	var pivot_now := _turning_from_start().pivot_at(seconds)
	return TurningSegment.new(segment_now(), pivot_now, motion.turn, velocity)


## The velocity of the point of it that is here now, in pixels per second.
func velocity_at(point: Vec2) -> Vec2:
	if motion.turn != 0.0:
		var pivot_now := _turning_from_start().pivot_at(seconds)
		return _turning_from_start().velocity_at(point.minus(pivot_now))
	return velocity


func _turning_from_start() -> TurningSegment:
	return TurningSegment.new(given, motion.pivot, motion.turn, velocity)
