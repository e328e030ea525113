class_name PointOfImpactTexts
extends RefCounted
## The sentences and the verdict of the lesson on the point of impact.

## The steps, counted from 0.
enum Step { MOTION, RESET, WAYS, FRACTION, IMPACT }


## One sentence a step, translated.
static func sentences(model: PointOfImpactModel) -> PackedStringArray:
	var found: PackedStringArray = [
		(
			LabText
			. translate(
				"One frame moves the ball by v, from old to new. Drag the ghost: it shows what lies between."
			)
		),
		_on_reset(model),
		(
			LabText
			. translate(
				"Along n̂: a = old − r is the way to the contact, b = old − new the way of the whole frame."
			)
		),
		LabText.translate(
			"t = a / b is the share of the frame until the contact. It counts only within 0..1."
		),
		_on_impact(model),
	]
	if model.mistake != 0:
		for step in range(Step.RESET, Step.size()):
			found[step] = LabText.translate("Compare the t of the mistake with the right one.")
	return found


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
			return [
				LabText.translate("t = %s, within 0..1") % t,
				LabText.translate("it touches in this frame")
			]
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


static func _on_reset(model: PointOfImpactModel) -> String:
	if model.is_reset():
		return LabText.translate(
			"Position reset: back along n̂ until the ball just touches. But was it ever there?"
		)
	return LabText.translate("Position reset: new does not overlap the line, so nothing is moved.")


static func _on_impact(model: PointOfImpactModel) -> String:
	match model.frame_case():
		PointOfImpactModel.Case.IN_FRAME when model.is_reset():
			var off := NumberText.short(model.error_of(model.reset_position()), 3)
			var sentence := LabText.translate(
				"POI = old + t v is on the path. The reset is %s px beside it."
			)
			return sentence % off
		PointOfImpactModel.Case.IN_FRAME:
			return LabText.translate("POI = old + t v is on the path.")
		PointOfImpactModel.Case.OVERLAPS_FROM_START:
			return LabText.translate("The contact is at the start of the frame: t counts as 0.")
	if model.is_reset():
		return LabText.translate(
			"No impact in this frame, but new overlaps the line: only the reset moves it out."
		)
	return LabText.translate("No impact in this frame: the ball may go to new.")
