class_name PointOfImpactTexts
extends RefCounted
## The sentences and the verdict of the lesson on the point of impact.


## One sentence a step, translated.
static func sentences(model: PointOfImpactModel) -> PackedStringArray:
	return [
		LabText.translate("One frame moves the ball by v from old to new. Drag both."),
		LabText.translate(
			"Position reset: back along n̂ until it just touches. But was it ever there?"
		),
		LabText.translate(
			"Along n̂: a = old − r is the way to the contact, b = old − new all of it."
		),
		LabText.translate(
			"t = a / b is the share of the frame until the contact. It must be in 0..1."
		),
		_last_sentence(model),
	]


## What was found, in two or three lines, translated.
static func verdict(model: PointOfImpactModel) -> PackedStringArray:
	var words := _case_words(model.frame_case())
	words[0] = (
		words[0] % NumberText.short(model.fraction()) if words[0].contains("%s") else words[0]
	)
	if model.mistake != 0:
		words.append(_mistake_words(model))
	return words


static func _case_words(frame_case: PointOfImpactModel.Case) -> PackedStringArray:
	match frame_case:
		PointOfImpactModel.Case.IN_FRAME:
			return [
				LabText.translate("t = %s, within 0..1"),
				LabText.translate("it touches in this frame")
			]
		PointOfImpactModel.Case.OVERLAPS_FROM_START:
			return [
				LabText.translate("t = %s, below 0"),
				LabText.translate("too close already: contact at once")
			]
		PointOfImpactModel.Case.TOO_FAR:
			return [
				LabText.translate("t = %s, above 1"),
				LabText.translate("no contact in this frame yet")
			]
		PointOfImpactModel.Case.MOVING_AWAY:
			return [
				LabText.translate("t = %s, b below 0"),
				LabText.translate("it moves away: never an impact")
			]
		PointOfImpactModel.Case.LEAVING:
			return [
				LabText.translate("t = %s, but b below 0"),
				LabText.translate("on its way out: no impact")
			]
	return [
		LabText.translate("b = 0: nothing to divide by"),
		LabText.translate("it moves along the line")
	]


static func _mistake_words(model: PointOfImpactModel) -> String:
	var wrong := model.fraction_with_mistake()
	if not model.position_with_mistake().is_finite():
		return LabText.translate("the mistake says t = %s: ball lost") % NumberText.short(wrong)
	if not model.shows_mistake():
		return LabText.translate("the mistake changes nothing here")
	if wrong == model.fraction():
		return LabText.translate("the mistake takes this t all the same")
	return LabText.translate("the mistake says t = %s") % NumberText.short(wrong)


static func _last_sentence(model: PointOfImpactModel) -> String:
	if model.frame_case() == PointOfImpactModel.Case.IN_FRAME:
		var off := NumberText.short(model.error_of(model.reset_position()), 3)
		return (
			LabText.translate("POI = old + t v is on the path. The reset is %s px beside it.") % off
		)
	if model.frame_case() == PointOfImpactModel.Case.OVERLAPS_FROM_START:
		return LabText.translate("It overlaps before it moves: the frame begins with the contact.")
	return LabText.translate("No impact in this frame: the ball may go to new.")
