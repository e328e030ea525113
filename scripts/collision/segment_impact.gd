class_name SegmentImpact
extends RefCounted
## Part 18 of the lecture put together: the impact with a segment that ends in round caps and works
## from both sides.


## The first impact of a ball that moves by [param motion] from [param old_position] with the
## segment.
static func with_segment(
	old_position: Vec2, motion: Vec2, radius: float, segment: LineSegment
) -> Impact:
	var flat := with_line_part(old_position, motion, radius, segment)
	if flat.hit:
		return flat
	var start := CapImpact.with_point(
		old_position, motion, radius, segment.start, Impact.Feature.START
	)
	var end := CapImpact.with_point(old_position, motion, radius, segment.end, Impact.Feature.END)
	if start.hit and (not end.hit or start.time <= end.time):
		return start
	return end if end.hit else flat


## The impact with the line between its ends, without caps, from the side on which the ball is.
static func with_line_part(
	old_position: Vec2, motion: Vec2, radius: float, segment: LineSegment
) -> Impact:
	var facing := facing_segment(old_position, segment)
	var impact := PointOfImpact.with_line(old_position, motion, radius, facing)
	# The end of a line is tested where the ball touches, not where it would be after the frame.
	if impact.hit and not is_beside_line(impact.position, facing):
		return Impact.miss(Impact.Outcome.PASSES_BESIDE)
	return impact


## The same segment, turned round if needed, so that its normal points to the side of [param point].
static func facing_segment(point: Vec2, segment: LineSegment) -> LineSegment:
	if LineDistance.signed_distance(point, segment) < 0.0:
		return LineSegment.new(segment.end, segment.start)
	return segment


## Whether the perpendicular from [param point] meets the line between its ends.
static func is_beside_line(point: Vec2, segment: LineSegment) -> bool:
	var share := segment.share_of(point)
	return share >= 0.0 and share <= 1.0
