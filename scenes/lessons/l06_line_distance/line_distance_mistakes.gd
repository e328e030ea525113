class_name LineDistanceMistakes
extends RefCounted
## The wrong distances of the bug gallery. The right one is [LineDistance].

## The normal is not brought to length 1.
const NOT_UNIT := 10
## The normal points to the other side.
const WRONG_SIGN := 9
## The distance is measured straight up instead of along the perpendicular.
const STRAIGHT_UP := -2


## What the mistake with this number takes for the signed distance of [param point] from
## [param line], in pixels; the right one for 0. Infinite or NaN straight up from a vertical line.
static func distance(number: int, point: Vec2, line: LineSegment) -> float:
	match number:
		NOT_UNIT:
			var along := line.along()
			return LineDistance.difference(point, line).dot(Vec2.new(-along.y, along.x))
		WRONG_SIGN:
			return LineDistance.difference(point, line).dot(line.normal().negated())
		STRAIGHT_UP:
			return point_straight_below(point, line).y - point.y
	return LineDistance.signed_distance(point, line)


## The point of the line that has the same x as [param point]; not finite for a vertical line.
static func point_straight_below(point: Vec2, line: LineSegment) -> Vec2:
	var along := line.along()
	return Vec2.new(point.x, line.start.y + (point.x - line.start.x) * along.y / along.x)


## What the gallery shows.
static func infos() -> Array[MistakeInfo]:
	return [
		MistakeInfo.new(
			STRAIGHT_UP,
			LabText.translate("distance measured vertically"),
			LabText.translate(
				"From a tilted line, the vertical way is longer: the hit is seen too late."
			),
			"test_line_distance.test_straight_up_is_longer",
			LabText.translate("The test compares both distances from a tilted line.")
		),
		MistakeInfo.new(
			WRONG_SIGN,
			LabText.translate("normal with the wrong sign"),
			LabText.translate("(y, −x) is the normal of the other side."),
			"test_line_distance.test_the_good_side_is_kept",
			LabText.translate(
				"The test puts a ball on the good side and wants a positive distance."
			)
		),
		MistakeInfo.new(
			NOT_UNIT,
			LabText.translate("normal not unit"),
			LabText.translate(
				"Not divided by the line's length: the distance is that many times too large."
			),
			"test_line_distance.test_the_normal_is_unit",
			LabText.translate("The test wants a normal of length 1.")
		),
	]
