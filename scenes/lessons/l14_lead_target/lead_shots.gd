class_name LeadShots
extends RefCounted
## The shots of a state: the right one, that of the mistake which is switched on, and the one at
## where the target is now. Computed once for each change.

# Where nothing is fired, or all touches at once, the target moves on for some seconds.
const _END_WITHOUT_SHOT := 4.0

## The right one; not fired where there is none.
var right: LeadShot
## That of the mistake; not fired where none is switched on or it finds no direction.
var wrong: LeadShot
## That at where the target is now.
var at_present: LeadShot


## Those of [param model] as it is now.
func _init(model: LeadTargetModel) -> void:
	right = LeadShot.right(model)
	wrong = LeadShot.along(model, model.direction_with(model.mistake))
	at_present = LeadShot.along(model, model.way().normalized())


## The shot that is drawn as a wrong one at [param step] of the explanation.
func shown_wrong(step: int) -> LeadShot:
	return at_present if step == LeadTargetModel.Step.NOW else wrong


## Until when time runs at [param step], in seconds.
func end(step: int) -> float:
	var last := 0.0
	var shown: Array[LeadShot] = [shown_wrong(step)]
	if step > LeadTargetModel.Step.NOW:
		shown.append(right)
	for shot in shown:
		if shot.is_fired():
			last = maxf(last, shot.end())
	return last if last > 0.0 else _END_WITHOUT_SHOT
