class_name ExactIncline
extends RefCounted
## The exact moment at which a ball comes to the end of a falling or level line, to about 100 bits,
## for readouts. The ball begins at the start of the line and does not turn yet. Everything given is
## taken as exact.

var _length: DoubleDouble
# The parts of gravity along the line and onto it.
var _pull: DoubleDouble
var _pressure: DoubleDouble
var _friction: DoubleDouble
var _speed: DoubleDouble


## The line [param segment], which leads to the right and does not climb; its length is above 0.
## [param gravity] is in px/s², downwards, [param friction] µ is 0 or more, [param speed], in px/s
## along the line, too.
func _init(segment: LineSegment, gravity: float, friction: float, speed: float) -> void:
	var width := DoubleDouble.sum_of(segment.end.x, -segment.start.x)
	var height := DoubleDouble.sum_of(segment.end.y, -segment.start.y)
	var strength := DoubleDouble.from_float(gravity)
	_length = width.times(width).plus(height.times(height)).square_root()
	_pull = strength.times(height).divided(_length)
	_pressure = strength.times(width).divided(_length)
	_friction = DoubleDouble.from_float(friction)
	_speed = DoubleDouble.from_float(speed)


## How late [param seconds] is for the end, in seconds, for a ball that [param rolls] before it is
## there, or slips all the way. Only for a ball that comes to the end.
func error_of(seconds: float, rolls: bool) -> float:
	var slips := _pull.minus(_friction.times(_pressure))
	if not rolls:
		return _time_for(_length, _speed, slips).error_of(seconds)
	var two_thirds := _times(_pull, 2.0).divided(DoubleDouble.from_float(3.0))
	if _speed.high == 0.0:
		return _time_for(_length, _speed, two_thirds).error_of(seconds)
	var fades := _times(_friction.times(_pressure), 3.0).minus(_pull)
	var change := _speed.divided(fades)
	var then := _speed.plus(slips.times(change))
	var way := _times(_speed.plus(then).times(change), 0.5)
	var rest := _time_for(_length.minus(way), then, two_thirds)
	return change.plus(rest).error_of(seconds)


# way = speed t + acceleration t² / 2, without a difference of nearly equal numbers.
static func _time_for(
	way: DoubleDouble, speed: DoubleDouble, acceleration: DoubleDouble
) -> DoubleDouble:
	var square := speed.times(speed).plus(_times(acceleration.times(way), 2.0))
	return _times(way, 2.0).divided(speed.plus(square.square_root()))


static func _times(number: DoubleDouble, factor: float) -> DoubleDouble:
	return number.times(DoubleDouble.from_float(factor))
