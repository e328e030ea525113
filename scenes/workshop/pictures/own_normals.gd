class_name OwnNormals
extends OwnPicture
## The unit vector and the unit normal of the lesson's line: both from where the line begins.


func questions(state: Dictionary) -> Array[OwnQuestion]:
	var model := NormalsModel.new()
	model.from_dictionary(state)
	var start := model.start
	var arrow := func(answer: PackedFloat64Array) -> OwnMark:
		return OwnMark.arrow(start, start.plus(vector(answer)))
	return [
		OwnQuestion.new("normalized", pair(model.v()), "v̂", start, arrow),
		OwnQuestion.new("normal", pair(model.v()), "n̂", start, arrow),
	]
