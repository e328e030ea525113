class_name Overlaps
extends RefCounted
## Where the balls of an [EventWorld] have to go that overlap something after a change: see
## [PushOut].


## Where a ball with its centre here is pushed to. [param sides] says on which side of a segment the
## ball belongs, where that is not the side of its centre.
static func place_outside(
	from: Vec2, radius: float, segments: SegmentScan, sides: Dictionary[int, float]
) -> Vec2:
	var push := PushOut.new(from, radius, SegmentEnds.seam_at(from.x, from.y))
	for place: int in sides:
		push.add_line(segments.segment(place), sides[place])
	for place in segments.places_within(from.x, from.y, 3.0 * radius):
		if not sides.has(place):
			push.add_line(segments.segment(place))
	if segments.corners:
		push.add_walls(segments.corners[0], segments.corners[1])
	return push.position()


## For each of these balls that touches the line of the old segment: on which side of the new one,
## which is to replace it, it belongs.
static func sides_of_touching(
	balls: Dictionary[int, Ball], old: LineSegment, moved: LineSegment
) -> Dictionary[int, float]:
	var sides: Dictionary[int, float] = {}
	for index: int in balls:
		var reach := balls[index].radius + BallSupport.REST_GAP
		var side := PushOut.side_touched(old, balls[index].position, reach)
		if side != 0.0:
			sides[index] = PushOut.side_after(side, old, moved)
	return sides
