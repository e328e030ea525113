class_name SegmentImpact
extends RefCounted
## Part 18 of the lecture as a whole: the impact with a segment that has two sides and round caps at
## its ends.


## The first impact of a ball that moves by [param motion] from [param old_position], in pixels,
## with the segment. A ball that overlaps the segment already touches at the fraction 0 if it
## approaches the nearest point of the segment. If it moves away from that point, there is no
## impact.
static func with_segment(
	old_position: Vec2, motion: Vec2, radius: float, segment: LineSegment
) -> Impact:
	var flat := with_line_part(old_position, motion, radius, segment)
	if flat.hit:
		return flat
	var cap := with_caps(old_position, motion, radius, segment)
	if not cap.hit:
		return flat
	var nearest := segment.closest_point(old_position)
	if old_position.distance_to(nearest) > radius:
		return cap
	# The ball overlaps the segment already: only the nearest point counts. Inside the circle about
	# an end, the ball may still be nearer to the line between the ends.
	var is_start := nearest.distance_to(segment.start) == 0.0
	var feature := Impact.Feature.START if is_start else Impact.Feature.END
	return CapImpact.with_point(old_position, motion, radius, nearest, feature)


## The first impact of a ball that moves by [param motion] from [param old_position], in pixels,
## with any of the segments; [member Impact.segment_index] is the index of that segment. A miss if
## the ball touches none of them. Only the first impact is certain to happen: the bounce changes the
## path, so the ball may never reach the others.
static func with_segments(
	old_position: Vec2, motion: Vec2, radius: float, segments: Array[LineSegment]
) -> Impact:
	var earliest := Impact.miss(Impact.Outcome.TOO_FAR)
	for i in segments.size():
		var impact := with_segment(old_position, motion, radius, segments[i])
		if impact.hit and (not earliest.hit or impact.fraction < earliest.fraction):
			earliest = impact
			earliest.segment_index = i
	return earliest


## The first impact with one of the two round caps, as if the line between them were not there.
static func with_caps(
	old_position: Vec2, motion: Vec2, radius: float, segment: LineSegment
) -> Impact:
	var start := CapImpact.with_point(
		old_position, motion, radius, segment.start, Impact.Feature.START
	)
	var end := CapImpact.with_point(old_position, motion, radius, segment.end, Impact.Feature.END)
	if start.hit and (not end.hit or start.fraction <= end.fraction):
		return start
	return end


## The impact with the line between the ends, without caps, on the side on which the ball is.
static func with_line_part(
	old_position: Vec2, motion: Vec2, radius: float, segment: LineSegment
) -> Impact:
	var facing := facing_segment(old_position, segment)
	var impact := PointOfImpact.with_line(old_position, motion, radius, facing)
	# Whether the ball is beside the line is tested at the point of impact, not after the frame.
	if impact.hit and not is_beside_line(impact.position, facing):
		return Impact.miss(Impact.Outcome.PASSES_BESIDE)
	return impact


## The same segment with its ends swapped if needed, so that its normal points to the side on which
## [param point] is.
static func facing_segment(point: Vec2, segment: LineSegment) -> LineSegment:
	if LineDistance.signed_distance(point, segment) < 0.0:
		return LineSegment.new(segment.end, segment.start)
	return segment


## Whether the perpendicular from [param point] meets the line between the two ends.
static func is_beside_line(point: Vec2, segment: LineSegment) -> bool:
	var share := segment.share_of(point)
	return share >= 0.0 and share <= 1.0
