class_name OwnLineEnds
extends OwnPicture
## Where the ball is at the moment of the student's impact, in the field with round caps.


func _init() -> void:
	board_path = ^"%RoundCaps/%Board"


func questions(state: Dictionary) -> Array[OwnQuestion]:
	var model := LineEndsModel.new()
	model.from_dictionary(state)
	var asked := pair(model.start) + pair(model.motion)
	asked.append(model.radius)
	asked += pair(model.segment.start) + pair(model.segment.end)
	var ball := func(answer: PackedFloat64Array) -> OwnMark:
		return OwnMark.ball(model.start.plus(model.motion.scaled(answer[0])), model.radius)
	return [OwnQuestion.new("segment_impact", asked, "t", model.start, ball).told_by(no_impact)]
