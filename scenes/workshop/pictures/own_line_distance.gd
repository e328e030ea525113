class_name OwnLineDistance
extends OwnPicture
## The distance of the ball as a length along the normal, and a ring round the ball: filled where it
## is said to touch.

# The ring is so many times as large as the ball.
const _RING := 1.15


func questions(state: Dictionary) -> Array[OwnQuestion]:
	var model := LineDistanceModel.new()
	model.from_dictionary(state)
	var ball := model.ball
	var normal := model.line.normal()
	var way := func(answer: PackedFloat64Array) -> OwnMark:
		return OwnMark.length(ball.position, ball.position.minus(normal.scaled(answer[0])))
	var ring := func(answer: PackedFloat64Array) -> OwnMark:
		return OwnMark.ball(ball.position, _RING * ball.radius, answer[0] == 1.0)
	var line := pair(model.line.start) + pair(model.line.end)
	var place := ball.position
	var of_ball: PackedFloat64Array = [model.distance_from_start(), ball.radius]
	return [
		OwnQuestion.new("distance_to_line", pair(ball.position) + line, "d · n̂", place, way),
		OwnQuestion.new("is_touching", of_ball, "", place, ring).told_by(_touching),
	]


static func _touching(answer: PackedFloat64Array) -> String:
	return LabText.translate("touches") if answer[0] == 1.0 else LabText.translate("is free")
