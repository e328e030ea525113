class_name ExactLineDistance
extends RefCounted
## The distance of a point from an infinite line to about 100 bits: the exact answer for readouts.
##
## The coordinates are taken as exact. Their differences must be 0 or have a magnitude between 1e-90
## and 1e140.


## Signed distance in pixels of [param point] from [param line], along the perpendicular: the
## determinant of the line's vector and the difference vector, divided by the line's length. The
## line must be longer than 0.
static func signed_distance(point: Vec2, line: LineSegment) -> DoubleDouble:
	var along_x := _difference(line.end.x, line.start.x)
	var along_y := _difference(line.end.y, line.start.y)
	var to_x := _difference(point.x, line.start.x)
	var to_y := _difference(point.y, line.start.y)
	var determinant := along_x.times(to_y).minus(along_y.times(to_x))
	var squared := along_x.times(along_x).plus(along_y.times(along_y))
	return determinant.divided(squared.square_root())


## The error of [param value] as the signed distance, in pixels; negative if it is too small.
static func error_of(value: float, point: Vec2, line: LineSegment) -> float:
	return signed_distance(point, line).error_of(value)


static func _difference(one: float, other: float) -> DoubleDouble:
	return DoubleDouble.sum_of(one, -other)
