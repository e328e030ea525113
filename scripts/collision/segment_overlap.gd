class_name SegmentOverlap
extends RefCounted
## Part 12 of the lecture for a line with ends: the ball is tested at one moment, the end of the
## frame. The test does not know where the ball came from, so a fast ball passes through the line.


## Whether a ball at [param position] overlaps the segment, on either side. If it does, the normal
## points from the nearest point of the segment to the ball, [member Impact.position] is where the
## ball just touches, and the fraction is 1. A centre on the line itself counts as being on the side
## to which the line's normal points.
static func with_segment(position: Vec2, radius: float, segment: LineSegment) -> Impact:
	var nearest := segment.closest_point(position)
	var normal := position.minus(nearest)
	var distance := normal.length()
	if distance >= radius:
		return Impact.miss(Impact.Outcome.TOO_FAR)
	if distance == 0.0:
		normal = segment.normal()
	normal.normalize()
	return Impact.at(1.0, nearest.plus(normal.scaled(radius)), normal, _feature(position, segment))


static func _feature(position: Vec2, segment: LineSegment) -> Impact.Feature:
	var share := segment.share_of(position)
	if share < 0.0:
		return Impact.Feature.START
	return Impact.Feature.END if share > 1.0 else Impact.Feature.LINE
