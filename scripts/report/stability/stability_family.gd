@abstract class_name StabilityFamily
extends RefCounted
## Stiff and extreme cases of one kind, and what their trials share.

## The first sentence with which a world refused what a trial needs; "" if none did.
var refusal := ""

## New cases of this kind.
@abstract func cases() -> Array[StabilityCase]


# Keeps the answer of a world that must not refuse, "" or a sentence.
func _need(problem: String) -> void:
	if refusal == "":
		refusal = problem


# A case whose trial is a method of this family, possibly with bound arguments. The lambda keeps the
# family alive as long as the case; a Callable of the method alone would not.
func _case(title: String, criterion: String, trial: Callable) -> StabilityCase:
	return StabilityCase.new(
		title, criterion, func(is_quick: bool) -> StabilityResult: return _tried(trial, is_quick)
	)


# A trial whose world refused something has failed, and the refusal is its figure.
func _tried(trial: Callable, is_quick: bool) -> StabilityResult:
	refusal = ""
	var result: StabilityResult = trial.call(is_quick)
	return StabilityResult.new(refusal, false) if refusal else result


# A new world with these segments and balls.
func _world(segments: Array[LineSegment], balls: Array[Ball]) -> EventWorld:
	var world := EventWorld.new()
	_need(world.set_segments(segments))
	_need(world.set_balls(balls))
	return world


func _segment(from_x: float, from_y: float, to_x: float, to_y: float) -> LineSegment:
	return LineSegment.new(Vec2.new(from_x, from_y), Vec2.new(to_x, to_y))


# The closed polygon through these points.
func _polygon(corners: Array[Vec2]) -> Array[LineSegment]:
	var sides: Array[LineSegment] = []
	for index in corners.size():
		sides.append(LineSegment.new(corners[index], corners[(index + 1) % corners.size()]))
	return sides


func _rectangle(low: Vec2, high: Vec2) -> Array[LineSegment]:
	return _polygon([low, Vec2.new(high.x, low.y), high, Vec2.new(low.x, high.y)])


func _ball(x: float, y: float, velocity_x: float, velocity_y: float, radius: float) -> Ball:
	return Ball.new(Vec2.new(x, y), radius, Vec2.new(velocity_x, velocity_y))


# Passed if [param value] is a number and at most [param bound].
func _at_most(value: float, bound: float, unit: String = "") -> StabilityResult:
	var figure := NumberText.size(value) + (" " + unit if unit else "")
	return StabilityResult.new(figure, value <= bound)


# Passed if the count is the one wanted.
func _counted(count: int, wanted: int) -> StabilityResult:
	return StabilityResult.new(str(count), count == wanted)
