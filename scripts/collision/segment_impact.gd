class_name SegmentImpact
extends RefCounted
## Part 18 of the lecture put together: the impact with a segment that ends in round caps and works
## from both sides.


## The first impact of a ball that moves by [param motion] from [param old_position] with the
## segment. A ball that already overlaps touches at time 0 if it approaches the nearest point of the
## segment; else it moves away from all of it.
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
	# It overlaps already: only the nearest point is touched, wherever the circles of the ends lie.
	var is_start := nearest.distance_to(segment.start) == 0.0
	var feature := Impact.Feature.START if is_start else Impact.Feature.END
	return CapImpact.with_point(old_position, motion, radius, nearest, feature)


## The first impact with one of the two round ends, as if the line between them were not there.
static func with_caps(
	old_position: Vec2, motion: Vec2, radius: float, segment: LineSegment
) -> Impact:
	var start := CapImpact.with_point(
		old_position, motion, radius, segment.start, Impact.Feature.START
	)
	var end := CapImpact.with_point(old_position, motion, radius, segment.end, Impact.Feature.END)
	if start.hit and (not end.hit or start.time <= end.time):
		return start
	return end


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
