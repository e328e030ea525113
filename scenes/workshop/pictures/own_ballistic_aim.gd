class_name OwnBallisticAim
extends OwnPicture
## How the bullets fly that are shot in the student's directions: as long as the lab's own do.

# A way is drawn with so many pieces.
const _PIECES := 40


## His methods know of a target that rests and of a gravity above 0.
func questions(state: Dictionary) -> Array[OwnQuestion]:
	var model := BallisticAimModel.new()
	model.from_dictionary(state)
	if not model.is_fixed() or model.gravity == 0.0 or model.target.length() == 0.0:
		return []
	return [_arc(model, "flat_arc", 0), _arc(model, "high_arc", 1)]


static func _arc(model: BallisticAimModel, method: String, place: int) -> OwnQuestion:
	var asked := pair(model.target)
	asked.append_array([model.gravity, model.speed])
	var way := func(answer: PackedFloat64Array) -> OwnMark:
		return _way(model, vector(answer).normalized(), place)
	var symbol := "d" + BallisticAimTexts.SUBSCRIPTS[place]
	return OwnQuestion.new(method, asked, symbol, model.target, way).told_by(no_shot)


# Where the lab finds no shot it flies as long as one straight at the target.
static func _way(model: BallisticAimModel, towards: Vec2, place: int) -> OwnMark:
	if towards.length() == 0.0:
		return OwnMark.note(model.target)
	var seconds := model.end(BallisticAimModel.Step.STRAIGHT)
	if model.has_shot():
		seconds = model.shots()[mini(place, model.shots().size() - 1)].time
	var flown := model.bullet_after.bind(towards)
	return OwnMark.way(FlightPath.places_every(seconds / _PIECES, seconds, flown))
