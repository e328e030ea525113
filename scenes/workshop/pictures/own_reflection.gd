class_name OwnReflection
extends OwnPicture
## The velocity after the bounce. Where the lesson refuses a normal that is not unit, there is
## nothing to compare with.


func questions(state: Dictionary) -> Array[OwnQuestion]:
	var model := ReflectionModel.new()
	model.from_dictionary(state)
	if model.refusal():
		return []
	var origin := Vec2.new()
	var arrow := func(answer: PackedFloat64Array) -> OwnMark:
		return OwnMark.arrow(origin, vector(answer))
	var asked := pair(model.velocity) + pair(model.used_normal())
	asked.append(model.bounciness)
	return [OwnQuestion.new("reflect", asked, LabText.translate("v out"), origin, arrow)]
