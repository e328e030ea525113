class_name EarliestImpact
extends RefCounted
## Of all impacts in a frame the earliest is the one that happens: the others may never.


## The first impact of a ball that moves by [param motion] with any of the segments;
## [member Impact.segment_index] says with which. Without any, a miss.
static func among(
	old_position: Vec2, motion: Vec2, radius: float, segments: Array[LineSegment]
) -> Impact:
	var earliest := Impact.miss(Impact.Outcome.TOO_FAR)
	for i in segments.size():
		var impact := SegmentImpact.with_segment(old_position, motion, radius, segments[i])
		if impact.hit and (not earliest.hit or impact.time < earliest.time):
			earliest = impact
			earliest.segment_index = i
	return earliest
