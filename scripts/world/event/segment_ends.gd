class_name SegmentEnds
extends RefCounted
## Which segments end at a point, and where they lead from there. Lines that end at one point are
## one surface there.

## What is this near is at one place, in pixels, or level, in radians.
const SEAM := 1e-9


## How near counts as one place, in pixels: far from the origin rounding adds to
## [constant SEAM].
static func seam_at(x: float, y: float) -> float:
	return SEAM + SegmentScan.ROUNDING * (absf(x) + absf(y))


## Those of [param places] that end at (x, y), in pixels. A dot has no line to go on along, and is
## left out.
static func places_at(
	segments: SegmentScan, places: PackedInt32Array, x: float, y: float
) -> PackedInt32Array:
	var found: PackedInt32Array = []
	for place in places:
		if is_dot(segments, place):
			continue
		if (
			is_end_at(segments, place, Impact.Feature.START, x, y)
			or is_end_at(segments, place, Impact.Feature.END, x, y)
		):
			found.append(place)
	return found


## The direction of a segment away from its end at the point (x, y).
static func direction_from(segments: SegmentScan, place: int, x: float, y: float) -> Vec2:
	var along := Vec2.new(segments.normal_y(place), -segments.normal_x(place))
	return along if is_end_at(segments, place, Impact.Feature.START, x, y) else along.negated()


## Whether a segment is so short that both its ends are one point.
static func is_dot(segments: SegmentScan, place: int) -> bool:
	var x := segments.end_x(place, Impact.Feature.END)
	var y := segments.end_y(place, Impact.Feature.END)
	return is_end_at(segments, place, Impact.Feature.START, x, y)


## Whether that end of a segment is at (x, y), in pixels.
static func is_end_at(
	segments: SegmentScan, place: int, feature: Impact.Feature, x: float, y: float
) -> bool:
	var dx := segments.end_x(place, feature) - x
	var dy := segments.end_y(place, feature) - y
	var seam := seam_at(x, y)
	return dx * dx + dy * dy <= seam * seam
