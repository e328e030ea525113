class_name Surroundings
extends RefCounted
## What acts on a ball: the lines, gravity, and the bounciness of the lines.
##
## Values that are out of range are refused: each `set_` method returns "", or one sentence with the
## value and what is allowed; then nothing has changed.

## The largest size of coordinates, speeds and gravity, in pixels, px/s and px/s².
const LARGEST := 1e6
## A ball passes a joint of two lines where the next one rises by no more than this, in pixels.
const FLUSH := 1e-9

## Read it; change it by [method set_segments].
var segments: Array[LineSegment] = []
## Pixels per second squared, any direction. Read it; change it by [method set_gravity].
var gravity := Vec2.new()
## The coefficient of restitution C, 0..1. Read it; change it by [method set_bounciness].
var bounciness := 1.0
## The number of changes so far. Whoever has computed something from the surroundings compares it.
var changes := 0

var _boxes := SegmentBoxes.new([])


## Replaces all segments by copies of these.
func set_segments(new_segments: Array[LineSegment]) -> String:
	var copies: Array[LineSegment] = []
	for segment in new_segments:
		var problem := segment.problem(LARGEST)
		if problem:
			return problem
		copies.append(segment.copy())
	segments = copies
	_boxes = SegmentBoxes.new(segments)
	changes += 1
	return ""


## Sets gravity.
func set_gravity(new_gravity: Vec2) -> String:
	var problem := FreeFlight.problem_of_gravity(new_gravity, LARGEST)
	if problem:
		return problem
	gravity = new_gravity.copy()
	changes += 1
	return ""


## Sets the bounciness.
func set_bounciness(new_bounciness: float) -> String:
	var problem := Bounce.problem_of_bounciness(new_bounciness)
	if problem:
		return problem
	bounciness = new_bounciness
	changes += 1
	return ""


## Surroundings that share nothing with these.
func copy() -> Surroundings:
	var other := Surroundings.new()
	for segment in segments:
		other.segments.append(segment.copy())
	other._boxes = SegmentBoxes.new(other.segments)
	other.gravity = gravity.copy()
	other.bounciness = bounciness
	return other


## The first impact of a ball that moves by [param motion]; [member Impact.segment_index] is an
## index into [member segments]. The segments with the indices [param skipped] are left out.
func first_impact(ball: Ball, motion: Vec2, skipped: PackedInt32Array = []) -> Impact:
	var near := near_segments(ball.position, motion, ball.radius, skipped)
	if near.is_empty():
		return Impact.miss(Impact.Outcome.TOO_FAR)
	var candidates: Array[LineSegment] = []
	for index in near:
		candidates.append(segments[index])
	var impact := SegmentImpact.with_segments(ball.position, motion, ball.radius, candidates)
	if impact.hit:
		impact.segment_index = near[impact.segment_index]
	return impact


## The indices of the segments that a ball may touch while it moves by [param motion], in order,
## without the indices [param skipped].
func near_segments(
	position: Vec2, motion: Vec2, radius: float, skipped: PackedInt32Array = []
) -> PackedInt32Array:
	var near := _boxes.near(position, motion, radius)
	for index in skipped:
		near.erase(index)
	return near


## The indices of the segments near a ball that do not rise above the line through [param point]
## with the unit normal [param normal], towards the ball. A ball that touches the point and moves
## along the line can meet none of them.
func segments_below(ball: Ball, point: Vec2, normal: Vec2) -> PackedInt32Array:
	var found: PackedInt32Array = []
	for index in near_segments(ball.position, Vec2.new(), ball.radius):
		var segment := segments[index]
		var height := maxf(
			segment.start.minus(point).dot(normal), segment.end.minus(point).dot(normal)
		)
		if height <= FLUSH:
			found.append(index)
	return found


## The largest g . x of all ends of lines, from which heights are measured. 0 without lines.
func deepest() -> float:
	var found := -INF
	for segment in segments:
		found = maxf(found, maxf(gravity.dot(segment.start), gravity.dot(segment.end)))
	return found if segments else 0.0
