class_name PointOfImpactTexts
extends RefCounted
## The sentences and the verdict of the lesson on the point of impact.

## The steps, counted from 0.
enum Step { MOTION, RESET, DISTANCES, WAYS, FRACTION, IMPACT }


## One sentence a step, translated.
static func sentences(model: PointOfImpactModel) -> PackedStringArray:
	var found: PackedStringArray = [
		_on_motion(model),
		_on_reset(model),
		LabText.translate(
			"Measure along n̂: old and new are now distances from the line, below 0 behind it."
		),
		LabText.translate(
			"a = old − r is the way along n̂ to the contact, b = old − new that of the whole frame."
		),
		_on_fraction(model),
		_on_impact(model),
	]
	for step in found.size():
		if is_compared(model, step):
			found[step] = LabText.translate("Compare the t of the mistake with the right one.")
	return found


## Whether a mistake that is switched on is shown at [param step]: not before the right t is.
static func is_compared(model: PointOfImpactModel, step: int) -> bool:
	return model.mistake != 0 and step >= Step.FRACTION


## The step at which a mistake is compared, for who switches it on at [param step].
static func step_of_mistake(_mistake: int, step: int) -> int:
	return maxi(step, Step.FRACTION)


## What is asked before t is shown, translated.
static func question_on_case() -> String:
	return LabText.translate("When does the ball first touch the line, on its good side?")


## The answers to [method question_on_case], translated.
static func choices() -> PackedStringArray:
	return [
		LabText.translate("within the frame"),
		LabText.translate("at its start"),
		LabText.translate("not in this frame")
	]


## The right one of [method choices], counted from 0.
static func right_choice(model: PointOfImpactModel) -> int:
	match model.frame_case():
		PointOfImpactModel.Case.IN_FRAME:
			return 0
		PointOfImpactModel.Case.OVERLAPS_FROM_START:
			return 1
	return 2


## What is asked before the point of impact is shown, translated.
static func question_on_impact() -> String:
	return LabText.translate(
		"Where is the ball's centre when it first touches? Drag the “?” there, then step forward."
	)


## What was found, in two or three lines, translated.
static func verdict(model: PointOfImpactModel) -> PackedStringArray:
	var words := _case_words(model)
	if model.mistake != 0:
		words.append(_mistake_words(model))
	return words


static func _case_words(model: PointOfImpactModel) -> PackedStringArray:
	var t := NumberText.short(model.fraction())
	match model.frame_case():
		PointOfImpactModel.Case.IN_FRAME:
			return [LabText.translate("t = %s, within 0..1") % t, _moment_words(model.fraction())]
		PointOfImpactModel.Case.OVERLAPS_FROM_START:
			return [LabText.translate("t = %s, below 0") % t, _contact_at_once(model)]
		PointOfImpactModel.Case.TOO_FAR:
			return [
				LabText.translate("t = %s, above 1") % t,
				LabText.translate("no contact in this frame yet")
			]
		PointOfImpactModel.Case.MOVING_AWAY:
			return [
				LabText.translate("b is below 0"), LabText.translate("it moves away: no impact")
			]
		PointOfImpactModel.Case.LEAVING:
			return [
				LabText.translate("b is below 0"),
				LabText.translate("it is on its way out: no impact")
			]
	if model.motion().length() == 0.0:
		return [LabText.translate("v = 0: no t"), LabText.translate("it does not move")]
	return [LabText.translate("b = 0: no t"), LabText.translate("it moves along the line")]


static func _moment_words(fraction: float) -> String:
	if fraction == 0.0:
		return LabText.translate("it touches at the start of the frame, in old")
	if fraction == 1.0:
		return LabText.translate("it touches at the end of the frame, in new")
	return LabText.translate("it touches in this frame")


static func _contact_at_once(model: PointOfImpactModel) -> String:
	if model.old_distance() < 0.0:
		return LabText.translate("behind the line already: contact at once")
	return LabText.translate("too close already: contact at once")


static func _mistake_words(model: PointOfImpactModel) -> String:
	var wrong := model.fraction_with_mistake()
	if not model.position_with_mistake().is_finite():
		return LabText.translate("the mistake divides by 0: the ball is lost")
	if not model.shows_mistake():
		return LabText.translate("the mistake changes nothing here")
	if wrong == model.fraction():
		return LabText.translate("the mistake takes t = %s all the same") % NumberText.short(wrong)
	return LabText.translate("the mistake says t = %s") % NumberText.short(wrong)


static func _on_motion(model: PointOfImpactModel) -> String:
	if model.motion().length() == 0.0:
		return LabText.translate("Old and new are the same point: the ball does not move.")
	return (
		LabText
		. translate(
			"One frame moves the ball by v, from old to new. Drag the ghost: t is its share of the frame."
		)
	)


static func _on_reset(model: PointOfImpactModel) -> String:
	if model.is_reset():
		return (
			LabText
			. translate(
				"The line has one good side, that of n̂. Position reset: back along n̂ until the ball touches."
			)
		)
	return LabText.translate("Position reset: new does not overlap the line, so nothing is moved.")


static func _on_fraction(model: PointOfImpactModel) -> String:
	match model.frame_case():
		PointOfImpactModel.Case.IN_FRAME:
			return (
				LabText
				. translate(
					"t = a / b: 0 is the start of the frame, 1 its end. Only within 0..1 it touches in this frame."
				)
			)
		PointOfImpactModel.Case.OVERLAPS_FROM_START:
			return LabText.translate("t is below 0: the contact lies before this frame.")
		PointOfImpactModel.Case.TOO_FAR:
			return LabText.translate("t is above 1: the contact lies after this frame.")
		PointOfImpactModel.Case.PARALLEL:
			return LabText.translate("b is 0: there is nothing to divide by, so there is no t.")
	return LabText.translate("b is below 0: the ball moves away, and t does not count.")


static func _on_impact(model: PointOfImpactModel) -> String:
	match model.frame_case():
		PointOfImpactModel.Case.IN_FRAME:
			return _on_way(model)
		PointOfImpactModel.Case.OVERLAPS_FROM_START:
			return LabText.translate("The contact is at the start of the frame: t counts as 0.")
	if not model.is_reset():
		return LabText.translate("No impact in this frame: the ball may go to new.")
	if model.new_distance() < 0.0:
		return LabText.translate(
			"No impact in this frame, but new is behind the line: only the reset moves it out."
		)
	return LabText.translate(
		"No impact in this frame, but new is too close: only the reset moves it out."
	)


static func _on_way(model: PointOfImpactModel) -> String:
	if not model.is_reset():
		return LabText.translate("POI = old + t v is on the path.")
	if model.is_reset_at_impact():
		return LabText.translate("POI = old + t v. Here the reset leads to the same place.")
	return LabText.translate("POI = old + t v is on the path. The reset is not.")
