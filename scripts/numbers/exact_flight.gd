class_name ExactFlight
extends RefCounted
## A piece of an [ExactPath]: from the start or an impact straight on to the next impact.

## When it begins, in seconds since the start of the path.
var start: DoubleDouble
## The ball's centre then, in pixels.
var position: ExactVector
## Pixels per second, all the way.
var velocity: ExactVector
## What the ball has just bounced off: the place of the segment in the list; -1 in the first flight.
var segment_index: int


## A flight that begins with all this and has no end of its own.
func _init(
	at_time: DoubleDouble, at_position: ExactVector, with_velocity: ExactVector, off_segment: int
) -> void:
	start = at_time
	position = at_position
	velocity = with_velocity
	segment_index = off_segment


## The centre at [param time], in seconds since the start of the path, with all its digits; before
## and after the flight it is the line made longer.
func position_at(time: float) -> ExactVector:
	return after(DoubleDouble.from_float(time).minus(start))


## The centre [param seconds] after the flight has begun.
func after(seconds: DoubleDouble) -> ExactVector:
	return position.plus(velocity.scaled(seconds))
