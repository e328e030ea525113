class_name NormalsTexts
extends RefCounted
## The sentences of the lesson on normals, step by step.


## One sentence a step, translated.
static func sentences(model: NormalsModel) -> PackedStringArray:
	var turn := clockwise_text(model)
	return [
		LabText.translate("A line has a direction: v = end − start. Drag its ends, or all of it."),
		LabText.translate("The normal is (−y, x): v turned by +90°, %s on screen.") % turn,
		LabText.translate(
			"(y, −x) is the opposite normal. A line has two; code must stay with one."
		),
		LabText.translate(
			"Divide n by its length: the unit normal n̂ has length 1. Normal is not unit!"
		),
		LabText.translate("1 pixel cannot be seen: a line's normal is drawn k times as long."),
	]


## The way in which +90 degrees turns on the screen, as one word.
static func clockwise_text(model: NormalsModel) -> String:
	if model.is_y_up:
		return LabText.translate("counter-clockwise")
	return LabText.translate("clockwise")
