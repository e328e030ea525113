class_name LineEndsModel
extends LessonModel
## One shot at five kinds of line: the ball's motion in one frame, and what each kind does to it.
##
## Lengths are in pixels.

## The kinds of line. One-sided: the centre must start on the side to which the normal points.
enum Field {
	INFINITE_ONE_SIDED, INFINITE_TWO_SIDED, SEGMENT_ONE_SIDED, SEGMENT_TWO_SIDED, ROUND_CAPS
}

## What becomes of the ball.
enum Result {
	BOUNCES,
	BOUNCES_IN_THE_AIR,
	BOUNCES_ON_THE_END,
	PASSES_THROUGH,
	CUTS_THROUGH_THE_END,
	DRIVES_IN_LENGTHWISE,
	PASSES_BESIDE,
	FALLS_SHORT,
	MOVES_AWAY,
	MOVES_ALONG,
	RESTS,
}

## No coordinate and no radius is larger than this.
const LARGEST := 1e6
## No line and no radius is smaller than this.
const SMALLEST := 1e-3

## The ball's centre at the beginning of the frame.
var start := Vec2.new(-6.0, -8.0)
## The motion of the whole frame without a bounce: the velocity in pixels per frame.
var motion := Vec2.new(6.0, 16.0)
## The ball's radius, [constant SMALLEST] to [constant LARGEST].
var radius := 5.0
## The line between its ends; an infinite line goes on through both.
var segment := LineSegment.new(Vec2.new(1.0, 3.0), Vec2.new(13.0, 8.0))
## The fraction of the frame that has passed, 0..1. In links its key is "time".
var fraction := 1.0
## The number of the mistake that flies a wrong ball beside the right one; 0 for none.
var mistake := 0


## The ball's centre at the end of the frame, if nothing were in its way.
func new_position() -> Vec2:
	return start.plus(motion)


## Puts the ball's centre at [param tail] and lets its motion end at [param head]. "" or one
## sentence; then nothing has changed.
func set_shot(tail: Vec2, head: Vec2) -> String:
	return attempt(
		func() -> void:
			start = tail.copy()
			motion = head.minus(tail)
	)


## Lays the line from one point to another. "" or one sentence; then nothing has changed.
func set_line(from: Vec2, to: Vec2) -> String:
	return attempt(func() -> void: segment = LineSegment.new(from, to))


func enter(name_in_line: String, value: float) -> String:
	var parts: Dictionary[String, RefCounted] = {
		"p": start, "v": motion, "a": segment.start, "b": segment.end
	}
	return attempt(
		func() -> void:
			if name_in_line == "r":
				radius = value
			else:
				parts[name_in_line[0]].set(name_in_line[1], value)
	)


## Makes the change [param edit] and takes it back if it leads to numbers that cannot be used. "" or
## one sentence on why.
func attempt(edit: Callable) -> String:
	var old := to_dictionary()
	edit.call()
	var refusal := problem()
	if refusal:
		from_dictionary(old)
	return refusal


## What a kind of line finds in this frame.
func impact_in(field: Field) -> Impact:
	match field:
		Field.INFINITE_ONE_SIDED:
			return _unless_behind(PointOfImpact.with_line(start, motion, radius, segment))
		Field.INFINITE_TWO_SIDED:
			var facing := SegmentImpact.facing_segment(start, segment)
			return PointOfImpact.with_line(start, motion, radius, facing)
		Field.SEGMENT_ONE_SIDED:
			return _unless_behind(SegmentImpact.with_line_part(start, motion, radius, segment))
		Field.SEGMENT_TWO_SIDED:
			return SegmentImpact.with_line_part(start, motion, radius, segment)
	return SegmentImpact.with_segment(start, motion, radius, segment)


## What becomes of the ball at a kind of line. The name of a miss says what a better line would have
## done.
func result_in(field: Field) -> Result:
	var impact := impact_in(field)
	if impact.hit:
		return _result_of_bounce(impact)
	if motion.length() == 0.0:
		return Result.RESTS
	var is_infinite := field in [Field.INFINITE_ONE_SIDED, Field.INFINITE_TWO_SIDED]
	var two_sided := Field.INFINITE_TWO_SIDED if is_infinite else Field.SEGMENT_TWO_SIDED
	if impact_in(two_sided).hit:
		return Result.PASSES_THROUGH
	if not is_infinite and impact_in(Field.ROUND_CAPS).hit:
		var is_along := impact_in(two_sided).outcome == Impact.Outcome.PARALLEL
		return Result.DRIVES_IN_LENGTHWISE if is_along else Result.CUTS_THROUGH_THE_END
	return _result_of_miss(impact_in(two_sided).outcome)


## Whether the ball bounces on the end of the segment with round caps.
func bounces_on_the_end() -> bool:
	return result_in(Field.ROUND_CAPS) == Result.BOUNCES_ON_THE_END


## The path of the ball at a kind of line, with its bounce.
func flight_in(field: Field) -> BallFlight:
	return BallFlight.new(start, motion, impact_in(field))


## The end of the line that the ball touches first; where it touches none, the one to which it comes
## closest.
func nearest_cap() -> Impact.Feature:
	var impact := impact_in(Field.ROUND_CAPS)
	if impact.hit and impact.feature != Impact.Feature.LINE:
		return impact.feature
	if _clearance_of(segment.start) <= _clearance_of(segment.end):
		return Impact.Feature.START
	return Impact.Feature.END


## Where the end named by [method nearest_cap] is.
func cap_point() -> Vec2:
	return segment.start if nearest_cap() == Impact.Feature.START else segment.end


## The quadratic for the end named by [method nearest_cap].
func cap_equation() -> CapEquation:
	return CapEquation.new(start, motion, radius, cap_point())


## The normal to the side of the line on which the ball begins.
func facing_normal() -> Vec2:
	return SegmentImpact.facing_segment(start, segment).normal()


## Points around all that a picture of a field must show: the line, and the ball at the beginning
## and at both ends of the frame, with and without the bounce.
func outline(field: Field) -> Array[Vec2]:
	var reach := Vec2.new(radius, radius)
	var found: Array[Vec2] = [segment.start, segment.end]
	var centres: Array[Vec2] = [start, new_position(), flight_in(field).position_at(1.0)]
	if field == Field.ROUND_CAPS:
		centres.append_array(found)
	for centre in centres:
		found.append(centre.plus(reach))
		found.append(centre.minus(reach))
	return found


## "" if all numbers can be used; else one sentence with the value and what is allowed.
func problem() -> String:
	for point: Vec2 in [start, motion, segment.start, segment.end]:
		if maxf(absf(point.x), absf(point.y)) > LARGEST:
			var sentence := LabText.translate("%s is too far out: coordinates go from -1e6 to 1e6.")
			return sentence % NumberText.pair(point.x, point.y)
	if not (radius >= SMALLEST and radius <= LARGEST):
		var sentence := LabText.translate("A radius of %s cannot be: it goes from 0.001 to 1e6.")
		return sentence % NumberText.short(radius)
	if segment.length() < SMALLEST:
		return LabText.translate("The line must be at least 0.001 long: its ends must differ.")
	return ""


func to_dictionary() -> Dictionary:
	return {
		"shot": PackedFloat64Array([start.x, start.y, motion.x, motion.y, radius]),
		"line":
		PackedFloat64Array([segment.start.x, segment.start.y, segment.end.x, segment.end.y]),
		"time": fraction,
		"mistake": mistake,
	}


func problem_in(stored: Dictionary) -> String:
	var model := LineEndsModel.new()
	model.from_dictionary(stored)
	return (
		StateCheck
		. first(
			[
				model.problem(),
				StateCheck.within("time", model.fraction, 0.0, 1.0),
				StateCheck.mistake(model.mistake, LineEndsMistakeTexts.infos()),
			]
		)
	)


func from_dictionary(stored: Dictionary) -> void:
	var shot: PackedFloat64Array = stored["shot"]
	var line: PackedFloat64Array = stored["line"]
	start.set_xy(shot[0], shot[1])
	motion.set_xy(shot[2], shot[3])
	radius = shot[4]
	segment = LineSegment.new(Vec2.new(line[0], line[1]), Vec2.new(line[2], line[3]))
	fraction = stored["time"]
	mistake = stored["mistake"]


# A one-sided line misses every ball that starts behind it.
func _unless_behind(impact: Impact) -> Impact:
	if LineDistance.signed_distance(start, segment) < 0.0:
		return Impact.miss(Impact.Outcome.MOVING_AWAY)
	return impact


func _result_of_bounce(impact: Impact) -> Result:
	if impact.feature != Impact.Feature.LINE:
		return Result.BOUNCES_ON_THE_END
	if SegmentImpact.is_beside_line(impact.position, segment):
		return Result.BOUNCES
	return Result.BOUNCES_IN_THE_AIR


func _result_of_miss(outcome: Impact.Outcome) -> Result:
	match outcome:
		Impact.Outcome.TOO_FAR:
			return Result.FALLS_SHORT
		Impact.Outcome.MOVING_AWAY:
			return Result.MOVES_AWAY
		Impact.Outcome.PARALLEL:
			return Result.MOVES_ALONG
	return Result.PASSES_BESIDE


# The smallest distance between the centre and a point in this frame without a bounce, in pixels.
func _clearance_of(point: Vec2) -> float:
	return LineSegment.new(start, new_position()).closest_point(point).distance_to(point)
