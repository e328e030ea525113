class_name EarliestImpact
extends RefCounted
## Picks the earliest of several impacts in one frame. Only that one is certain to happen: the
## bounce changes the path, so the ball may never reach the others.


## The first impact of a ball that moves by [param motion] from [param old_position], in pixels,
## with any of the segments. [member Impact.segment_index] is the index of that segment. A miss if
## the ball touches none of them.
static func among(
	old_position: Vec2, motion: Vec2, radius: float, segments: Array[LineSegment]
) -> Impact:
	var earliest := Impact.miss(Impact.Outcome.TOO_FAR)
	for i in segments.size():
		var impact := SegmentImpact.with_segment(old_position, motion, radius, segments[i])
		if impact.hit and (not earliest.hit or impact.fraction < earliest.fraction):
			earliest = impact
			earliest.segment_index = i
	return earliest
