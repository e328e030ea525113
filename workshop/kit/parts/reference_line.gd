class_name WorkshopReferenceLine
extends RefCounted
## Right answers to the exercises about a ball and an infinite line, by the lab's own code.


## See exercise 5.
static func distance_to_line(point: Vec2, start: Vec2, end: Vec2) -> float:
	return LineDistance.signed_distance(point, LineSegment.new(start, end))


## See exercise 6.
static func is_touching(distance: float, radius: float) -> bool:
	return distance < radius


## See exercise 7.
static func position_reset(position: Vec2, normal: Vec2, distance: float, radius: float) -> Vec2:
	return position.plus(normal.scaled(radius - distance))
