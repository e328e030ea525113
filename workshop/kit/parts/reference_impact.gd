class_name WorkshopReferenceImpact
extends RefCounted
## Right answers to the exercises about the time of an impact, by the lab's own code.


## See exercise 8.
static func time_of_impact(old: float, new: float, radius: float) -> float:
	var fraction := PointOfImpact.fraction(old, new, radius)
	return fraction if fraction >= 0.0 and fraction <= 1.0 else INF


## See exercise 11.
static func segment_impact(
	position: Vec2, motion: Vec2, radius: float, start: Vec2, end: Vec2
) -> float:
	var impact := SegmentImpact.with_segment(position, motion, radius, LineSegment.new(start, end))
	return impact.fraction if impact.hit else INF
