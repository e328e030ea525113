class_name LineSegment
extends RefCounted
## A straight line between two points. Some functions take it as the infinite line through both
## points, and say so.

## A segment must be at least this long to be used, in pixels: the square of a shorter length could
## not be held by a number.
const SHORTEST := 1e-150

## The first point, in pixels.
var start: Vec2
## The second point, in pixels.
var end: Vec2


## The segment between two points. Both are copied, so that nothing is shared.
func _init(from: Vec2, to: Vec2) -> void:
	start = from.copy()
	end = to.copy()


## A segment that shares nothing with this one.
func copy() -> LineSegment:
	return LineSegment.new(start, end)


## The vector from start to end, in pixels.
func along() -> Vec2:
	return end.minus(start)


## Length in pixels.
func length() -> float:
	return start.distance_to(end)


## The unit normal: +90 degrees from [method along], clockwise on screen. It does not depend on
## where the segment is. Zero for a segment of length 0.
func normal() -> Vec2:
	return along().normal()


## The point of the segment that is nearest to [param point]: the foot of the perpendicular, or an
## end.
func closest_point(point: Vec2) -> Vec2:
	return start.lerped(end, clampf(share_of(point), 0.0, 1.0))


## Where the perpendicular from [param point] meets the infinite line: 0 at the start, 1 at the end,
## below 0 or above 1 beyond them. 0 for a segment of length 0.
func share_of(point: Vec2) -> float:
	var size := length()
	return point.minus(start).scalar_projection(along()) / size if size > 0.0 else 0.0


## The distance between the nearest points of both segments, in pixels: 0 where they cross.
func distance_to(other: LineSegment) -> float:
	if _separates(other) and other._separates(self):
		return 0.0
	var nearest := INF
	for point: Vec2 in [other.start, other.end]:
		nearest = minf(nearest, closest_point(point).distance_to(point))
	for point: Vec2 in [start, end]:
		nearest = minf(nearest, other.closest_point(point).distance_to(point))
	return nearest


## "" if this segment can be used; otherwise one sentence with the value and what is allowed. Its
## ends must be finite, at least [constant SHORTEST] apart, and within
## -[param largest]..[param largest] px.
func problem(largest: float = INF) -> String:
	if not (start.is_finite() and end.is_finite()):
		return "A segment's ends must be finite, not %s and %s." % [start, end]
	if length() == 0.0:
		return "A segment must be longer than 0: both its ends are %s." % start
	if length() < SHORTEST:
		var size := String.num_scientific(length())
		return "A segment must be at least 1e-150 px long, not %s px." % size
	if not (start.is_within(largest) and end.is_within(largest)):
		var limit := String.num_scientific(largest)
		var values := [limit, limit, start, end]
		return "A segment's ends must be within -%s..%s px, not %s and %s." % values
	return ""


# Whether the ends of the other segment are on different sides of this line.
func _separates(other: LineSegment) -> bool:
	var one := along().cross(other.start.minus(start))
	var two := along().cross(other.end.minus(start))
	return (one < 0.0) != (two < 0.0)
