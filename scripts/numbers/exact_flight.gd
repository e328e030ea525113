class_name ExactFlight
extends RefCounted
## A straight piece of an [ExactPath]: from the start, or from an impact, to the next impact.

## The time at which it begins, in seconds since the start of the path.
var start: DoubleDouble
## The ball's centre at that time, in pixels.
var position: ExactVector
## The velocity during the whole flight, in pixels per second.
var velocity: ExactVector
## The index of the segment that the ball has just bounced off; -1 in the first flight.
var segment_index: int


## A flight that begins with these values. Its end is not stored.
func _init(
	at_time: DoubleDouble, at_position: ExactVector, with_velocity: ExactVector, off_segment: int
) -> void:
	start = at_time
	position = at_position
	velocity = with_velocity
	segment_index = off_segment


## The centre at [param time], in seconds since the start of the path, with all its digits. Before
## and after the flight it is on the extension of the line.
func position_at(time: float) -> ExactVector:
	return after(DoubleDouble.from_float(time).minus(start))


## The centre [param seconds] after the flight has begun.
func after(seconds: DoubleDouble) -> ExactVector:
	return position.plus(velocity.scaled(seconds))
