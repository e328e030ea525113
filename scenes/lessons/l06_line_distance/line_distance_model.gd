class_name LineDistanceModel
extends LessonModel
## A ball and a line without ends: how far one is from the other, measured from any point of the
## line.

# What a distance may be off by, as a share of the places that it is computed from.
const _ROUNDING := 4e-15
const _LINE: PackedFloat64Array = [200.0, 150.0, -200.0, -150.0]
## Presets by their titles (source text): what each changes in the model's state.
const PRESETS: Dictionary[String, Dictionary] = {
	"Free": {line = _LINE, ball = [120.0, -35.0, 30.0], from_share = 0.7},
	"Too close": {line = _LINE, ball = [75.0, 25.0, 30.0], from_share = 0.8},
	"Behind": {line = _LINE, ball = [24.0, 93.0, 30.0], from_share = 0.8},
	"Past the end": {line = _LINE, ball = [263.0, 166.0, 30.0], from_share = 0.6},
	"p far away": {line = _LINE, ball = [120.0, -35.0, 30.0], from_share = -0.4},
	"Slow ball":
	{
		line = _LINE,
		ball = [120.0, -35.0, 30.0],
		speed = 35.0,
		rule = DiscreteDetection.Rule.BOTH_SIDES,
	},
	"Fast ball":
	{
		line = _LINE,
		ball = [120.0, -35.0, 30.0],
		speed = 140.0,
		rule = DiscreteDetection.Rule.BOTH_SIDES,
	},
}

## The line; its ends only say where it is drawn, and where [method segment_distance] ends.
var line := LineSegment.new(Vec2.new(200.0, 150.0), Vec2.new(-200.0, -150.0))
## The ball, at rest in all steps but the last.
var ball := Ball.new(Vec2.new(120.0, -35.0), 30.0)
## Where on the line the difference vector begins: 0 is its start, 1 its end, others lie beyond.
var from_share := 0.7
## How far the ball of the last step moves in a frame, straight at the line, in pixels.
var speed := 35.0
## Where its test calls it red.
var rule := DiscreteDetection.Rule.BELOW_RADIUS
## The frame up to which its flight is shown; larger numbers show all of it. Not part of the state.
var frame := DiscreteDetection.MOST_FRAMES:
	get:
		return mini(frame, detection().last_frame())
	set(value):
		frame = maxi(value, 0)
## The mistake that is switched on, by its number in [LineDistanceMistakes]; 0 for none.
var mistake := 0


## The point of the line from which the difference vector leads to the ball.
func from() -> Vec2:
	return line.start.lerped(line.end, from_share)


## The difference vector d: the ball's centre less [method from].
func difference() -> Vec2:
	# By way of the nearer end, not of the rounded point: next to an end that would be all that is
	# left.
	if from_share > 0.5:
		return ball.position.minus(line.end).minus(line.along().scaled(from_share - 1.0))
	return ball.position.minus(line.start).minus(line.along().scaled(from_share))


## The distance of the centre as measured from [method from]: d . n, in pixels; negative behind the
## line.
func distance() -> float:
	return difference().dot(line.normal())


## The same distance as [LineDistance] measures it: from the start of the line.
func distance_from_start() -> float:
	return LineDistance.signed_distance(ball.position, line)


## The flight of the last step, from the distance that the steps before it have found. Distances
## that only rounding keeps from 0 or the radius are that.
func detection() -> DiscreteDetection:
	var start := distance()
	for exact: float in [0.0, ball.radius]:
		start = exact if absf(start - exact) <= _rounding() else start
	return DiscreteDetection.new(start, ball.radius, speed, rule)


## Where the ball of the last step is in the frame [param number].
func position_at(number: int) -> Vec2:
	return ball.position.minus(line.normal().scaled(number * speed))


## Pixels between the ball's rim and the line; negative where they overlap.
func gap() -> float:
	return LineDistance.gap(ball, line)


## Whether the ball is closer than its radius, or behind the line.
func is_overlapping() -> bool:
	return gap() < -_rounding()


## Whether the ball's rim is on the line, but for what rounding leaves of the gap.
func is_touching() -> bool:
	return absf(gap()) <= _rounding()


## Whether the ball's centre is behind the line, where the normal does not point.
func is_behind() -> bool:
	return distance_from_start() < -_rounding()


## Whether the ball's centre is on the line, but for what rounding leaves of its distance.
func is_on_line() -> bool:
	return absf(distance_from_start()) <= _rounding()


## Whether the ball's centre is on the drawn line, but for what rounding leaves of its distance.
func is_on_segment() -> bool:
	return segment_distance() <= _rounding()


## Whether p is where the ball's centre is, so that only rounding is left of d.
func is_p_at_ball() -> bool:
	return difference().length() <= _rounding()


## Where the perpendicular from the ball's centre meets the line.
func foot() -> Vec2:
	return line.start.lerped(line.end, line.share_of(ball.position))


## Where the ball's rim is nearest to the line: the radius closer than its centre.
func rim() -> Vec2:
	return ball.position.minus(line.normal().scaled(ball.radius))


## Whether the foot of the perpendicular lies beyond an end of the drawn line.
func is_beside_end() -> bool:
	return not SegmentImpact.is_beside_line(ball.position, line)


## The point of the drawn line that is nearest to the ball's centre.
func nearest() -> Vec2:
	return line.closest_point(ball.position)


## Pixels from the ball's centre to the drawn line with its ends; never negative.
func segment_distance() -> float:
	return ball.position.distance_to(nearest())


## The distance as the mistake that is switched on has it; the right one where none is.
func distance_with_mistake() -> float:
	return LineDistanceMistakes.distance(mistake, ball.position, line)


## Where the ball would have to be for [method distance_with_mistake] to be right.
func position_with_mistake() -> Vec2:
	return foot().plus(line.normal().scaled(distance_with_mistake()))


## The points that the board has to show: the ends of the line, p, what is drawn between it and the
## ball, and the ball as far as half its radius.
func points_to_show() -> Array[Vec2]:
	var corner := from().plus(ball.position.minus(foot()))
	var half := Vec2.new(ball.radius / 2.0, ball.radius / 2.0)
	return [
		line.start,
		line.end,
		from(),
		corner,
		ball.position.minus(half),
		ball.position.plus(half),
	]


## Slides the start of the difference vector to the point of the line nearest to [param point].
func slide_to(point: Vec2) -> void:
	from_share = line.share_of(point)


## Takes a typed number by its name in the formula. "" if it could be taken; else one sentence with
## the value and what is allowed, and nothing changes.
func enter(name_in_line: String, value: float) -> String:
	var start := line.start.copy()
	var end := line.end.copy()
	match name_in_line:
		"sx":
			start.x = value
		"sy":
			start.y = value
		"ex":
			end.x = value
		"ey":
			end.y = value
		"cx":
			ball.position.x = value
		"cy":
			ball.position.y = value
		"share":
			from_share = value
		"r":
			return resize_ball(value)
		"speed":
			return set_speed(value)
	return move_line(start, end)


## Moves the line's ends. "" if it could be moved; else a sentence, and the line stays.
func move_line(start: Vec2, end: Vec2) -> String:
	var moved := LineSegment.new(start, end)
	var problem := moved.problem()
	if problem == "":
		line = moved
	return problem


## Changes the radius. "" if it could be changed; else a sentence, and the radius stays.
func resize_ball(radius: float) -> String:
	var resized := Ball.new(ball.position, radius)
	var problem := resized.problem()
	if problem == "":
		ball = resized
	return problem


## Changes the speed. "" if it could be changed; else a sentence, and the speed stays.
func set_speed(pixels: float) -> String:
	if not (pixels > 0.0 and pixels <= DiscreteDetection.LARGEST_SPEED):
		var sentence := LabText.translate("The speed must be above 0 and at most 1e6, not %s.")
		return sentence % NumberText.short(pixels)
	speed = pixels
	return ""


## Chooses the test by its place in [enum DiscreteDetection.Rule].
func set_rule(place: int) -> void:
	rule = place as DiscreteDetection.Rule


func to_dictionary() -> Dictionary:
	return {
		"line": PackedFloat64Array([line.start.x, line.start.y, line.end.x, line.end.y]),
		"ball": PackedFloat64Array([ball.position.x, ball.position.y, ball.radius]),
		"from_share": from_share,
		"speed": speed,
		"rule": rule,
		"mistake": mistake,
	}


func problem_in(stored: Dictionary) -> String:
	var model := LineDistanceModel.new()
	model.from_dictionary(stored)
	return (
		StateCheck
		. first(
			[
				model.line.problem(),
				model.ball.problem(),
				model.set_speed(model.speed),
				_problem_of_rule(model.rule),
				StateCheck.mistake(model.mistake, LineDistanceMistakes.infos()),
			]
		)
	)


static func _problem_of_rule(place: int) -> String:
	var largest := DiscreteDetection.Rule.size() - 1
	return StateCheck.within("rule", place, 0.0, largest)


func from_dictionary(stored: Dictionary) -> void:
	var ends: PackedFloat64Array = stored["line"]
	var centre_and_radius: PackedFloat64Array = stored["ball"]
	line = LineSegment.new(Vec2.new(ends[0], ends[1]), Vec2.new(ends[2], ends[3]))
	ball = Ball.new(Vec2.new(centre_and_radius[0], centre_and_radius[1]), centre_and_radius[2])
	from_share = stored["from_share"]
	speed = stored["speed"]
	rule = stored["rule"]
	mistake = stored["mistake"]


func _rounding() -> float:
	return _ROUNDING * (line.start.length() + ball.position.length() + ball.radius)
