class_name OwnLeadTarget
extends OwnPicture
## How far the target moves until the student's hit, and the student's shot, as far as it flies in
## one second.


## His methods know of no radius, and of nothing that touches already.
func questions(state: Dictionary) -> Array[OwnQuestion]:
	var model := LeadTargetModel.new()
	model.from_dictionary(state)
	if model.radius > 0.0 or model.shot_case() == LeadTargetModel.Case.TOUCHES:
		return []
	var asked := pair(model.way()) + pair(model.relative_velocity())
	asked.append(model.speed)
	var moved := func(answer: PackedFloat64Array) -> OwnMark: return _moved(model, answer[0])
	var shot := func(answer: PackedFloat64Array) -> OwnMark:
		var flown := vector(answer).scaled(model.speed)
		return OwnMark.arrow(model.shooter, model.shooter.plus(flown))
	return [
		OwnQuestion.new("lead_time", asked, "t", model.target, moved).told_by(no_shot),
		OwnQuestion.new("lead", asked, "d", model.shooter, shot).told_by(no_shot),
	]


# A shooter that moves sees it elsewhere than it is on the ground, and the lesson shows both in
# turn: there the words stand alone.
static func _moved(model: LeadTargetModel, seconds: float) -> OwnMark:
	if model.own.length() > 0.0:
		return OwnMark.note(model.target)
	return OwnMark.arrow(model.target, model.target_after(seconds, true))
