class_name OwnPointOfImpact
extends OwnPicture
## Where the student puts the ball back to, and where it is at the fraction that he finds.


func questions(state: Dictionary) -> Array[OwnQuestion]:
	var model := PointOfImpactModel.new()
	model.from_dictionary(state)
	var found: Array[OwnQuestion] = [_impact(model)]
	# What does not overlap needs no reset.
	if model.is_reset():
		found.append(_reset(model))
	return found


func _reset(model: PointOfImpactModel) -> OwnQuestion:
	var asked := pair(model.new_position) + pair(model.line.normal())
	asked.append_array([model.new_distance(), model.radius])
	var ball := func(answer: PackedFloat64Array) -> OwnMark:
		return OwnMark.ball(vector(answer), model.radius)
	var symbol := LabText.translate("reset")
	return OwnQuestion.new("position_reset", asked, symbol, model.new_position, ball)


func _impact(model: PointOfImpactModel) -> OwnQuestion:
	var asked: PackedFloat64Array = [model.old_distance(), model.new_distance(), model.radius]
	var old := model.old_position
	var ball := func(answer: PackedFloat64Array) -> OwnMark:
		return OwnMark.ball(old.plus(model.motion().scaled(answer[0])), model.radius)
	return OwnQuestion.new("time_of_impact", asked, "t", old, ball).told_by(no_impact)
