class_name LineDistance
extends RefCounted
## The distance of a ball from an infinite line, part 11 of the lecture: the difference vector from
## any point of the line, projected on the unit normal, minus the radius.


## The vector from the start of the line to [param point]. Any other point of the line would do.
static func difference(point: Vec2, line: LineSegment) -> Vec2:
	return point.minus(line.start)


## Distance in pixels of [param point] from the line, along the perpendicular: positive on the side
## to which the normal points, negative on the other.
static func signed_distance(point: Vec2, line: LineSegment) -> float:
	return difference(point, line).dot(line.normal())


## Pixels between the ball's edge and the line on the line's good side; negative if they overlap.
static func gap(ball: Ball, line: LineSegment) -> float:
	return signed_distance(ball.position, line) - ball.radius


## Whether the ball is closer to the line than its radius, or behind it.
static func is_overlapping(ball: Ball, line: LineSegment) -> bool:
	return gap(ball, line) < 0.0
