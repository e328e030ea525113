class_name LeadTargetTexts
extends RefCounted
## The sentences and the verdict of the lesson on leading a target.


## One sentence a step, translated.
static func sentences(model: LeadTargetModel, shots: LeadShots) -> PackedStringArray:
	return [
		_on_now(model, shots),
		_on_relative(model),
		LabText.translate(
			"After t seconds the bullet is somewhere on a circle of radius s t. Press Play."
		),
		_on_time(model),
		_on_aim(model),
		_on_fire(model, shots),
	]


static func _on_now(model: LeadTargetModel, shots: LeadShots) -> String:
	if model.shot_case() == LeadTargetModel.Case.TOUCHES:
		return LabText.translate("The target touches the shooter already: every shot hits.")
	if shots.at_present.touches():
		return LabText.translate(
			"Here a shot at where the target is now hits. Drag v: when does it not?"
		)
	return LabText.translate("A shot at where the target is now misses it. Press Play and see.")


static func _on_relative(model: LeadTargetModel) -> String:
	if model.own.length() == 0.0:
		return LabText.translate(
			"P leads from the shooter to the target. The shooter stands still, so V is v."
		)
	return LabText.translate(
		"The bullet takes u along: seen from the shooter, the target moves with V = v − u."
	)


static func _on_time(model: LeadTargetModel) -> String:
	match model.shot_case():
		LeadTargetModel.Case.TOUCHES:
			return LabText.translate("They touch already: t is 0.")
		LeadTargetModel.Case.HITS_TWICE:
			return (
				LabText
				. translate(
					"The target comes by: |P + V t| = R + s t holds at two moments. The earlier one counts."
				)
			)
		LeadTargetModel.Case.HITS:
			return _on_one_hit(model.equation())
		LeadTargetModel.Case.GETS_AWAY:
			return LabText.translate(
				"Distance and reach never meet from 0 on: the target is faster and gets away."
			)
	return LabText.translate(
		"Distance and reach never meet: the target is as fast as the bullet and comes no nearer."
	)


static func _on_one_hit(equation: LeadEquation) -> String:
	if equation.a == 0.0:
		return (
			LabText
			. translate(
				"The target is as fast as the bullet: a is 0, and there is one root. Do not divide by a."
			)
		)
	if equation.a > 0.0:
		return LabText.translate("Distance and reach touch at one moment only: a grazing shot.")
	return LabText.translate(
		"Squared, |P + V t| = R + s t has two roots. The one below 0 is no hit: it is past."
	)


static func _on_aim(model: LeadTargetModel) -> String:
	if not model.can_hit():
		return LabText.translate("No direction hits, so there is nothing to aim at.")
	if model.shot_case() == LeadTargetModel.Case.TOUCHES:
		return LabText.translate("They touch already: aim straight at the target.")
	if model.own.length() == 0.0:
		return LabText.translate("Aim along P + V t, at where the target will be.")
	return LabText.translate("Aim along P + V t. On the ground the bullet flies with u + s d.")


static func _on_fire(model: LeadTargetModel, shots: LeadShots) -> String:
	if not model.can_hit():
		return LabText.translate("Nothing is fired, because nothing would hit.")
	if model.shot_case() == LeadTargetModel.Case.TOUCHES:
		return LabText.translate("They touch already: no shot has to fly.")
	if not shots.right.is_right:
		return LabText.translate("The hit is too late to be flown here.")
	return LabText.translate(
		"Press Play: the shot flies. ε × condition is how far rounding alone may move it."
	)


## What is asked before the circle of reach is shown, translated.
static func question_on_reach() -> String:
	return LabText.translate("Can a bullet of this speed hit the target at all?")


## The answers to [method question_on_reach], translated.
static func choices() -> PackedStringArray:
	return [
		LabText.translate("there is one moment"),
		LabText.translate("there are two moments"),
		LabText.translate("the target gets away")
	]


## The right one of [method choices], counted from 0; -1 where both touch already.
static func right_choice(model: LeadTargetModel) -> int:
	match model.shot_case():
		LeadTargetModel.Case.TOUCHES:
			return -1
		LeadTargetModel.Case.HITS:
			return 0
		LeadTargetModel.Case.HITS_TWICE:
			return 1
	return 2


## What is asked before the moment of the hit is shown, translated.
static func question_on_place(model: LeadTargetModel) -> String:
	if model.own.length() == 0.0:
		return LabText.translate(
			"Where is the target when it is hit? Drag the “?” there, then step forward."
		)
	return LabText.translate(
		"Where does the shooter see the target when it is hit? Drag the “?”, then step forward."
	)


## Whether the mistake that is switched on is shown at [param step]: not before the right direction.
static func is_compared(model: LeadTargetModel, step: int) -> bool:
	return model.mistake != 0 and step >= LeadTargetModel.Step.AIM


## The step at which a mistake is compared, for who switches it on at [param step].
static func step_of_mistake(_mistake: int, step: int) -> int:
	return step if step >= LeadTargetModel.Step.AIM else LeadTargetModel.Step.FIRE


## What was found at [param step], in a few lines, translated.
static func verdict(model: LeadTargetModel, shots: LeadShots, step: int) -> PackedStringArray:
	var words := _case_words(model)
	var is_flown := step == LeadTargetModel.Step.FIRE and shots.right.moment > 0.0
	# On a small board the card has to be short.
	if is_flown and is_compared(model, step):
		words.clear()
	if is_flown:
		words.append(ShotText.of_right(shots.right.miss, shots.right.from_rounding()))
	if is_compared(model, step):
		words.append(_mistake_words(model, shots.wrong))
	return words


static func _case_words(model: LeadTargetModel) -> PackedStringArray:
	match model.shot_case():
		LeadTargetModel.Case.TOUCHES:
			return [LabText.translate("they touch already: t = 0")]
		LeadTargetModel.Case.HITS:
			return [
				LabText.translate("it hits after t = %s s") % NumberText.short(model.aim().time)
			]
		LeadTargetModel.Case.HITS_TWICE:
			var times := model.equation().times()
			return [
				LabText.translate("it hits after t = %s s") % NumberText.short(times[0]),
				LabText.translate("or later, after %s s") % NumberText.short(times[1])
			]
		LeadTargetModel.Case.GETS_AWAY:
			return [
				LabText.translate("no hit: the target is faster"),
				LabText.translate("than the bullet and gets away")
			]
	return [
		LabText.translate("no hit: the target is as fast"),
		LabText.translate("as the bullet and comes no nearer")
	]


static func _mistake_words(model: LeadTargetModel, wrong: LeadShot) -> String:
	if not wrong.is_fired():
		return LabText.translate("the mistake finds no direction")
	if not model.shows_mistake():
		return LabText.translate("the mistake changes nothing here")
	if wrong.touches():
		return LabText.translate("the mistake hits all the same")
	return LabText.translate("the mistake %s") % ShotText.of_wrong(wrong.miss)
