class_name NormalsTexts
extends RefCounted
## The sentences of the lesson on normals, step by step.


## One sentence a step, translated.
static func sentences(model: NormalsModel) -> PackedStringArray:
	var turn := clockwise_text(model)
	return [
		_translate("A line has a direction: v = end − start. Drag its ends, or all of it."),
		_translate("The normal is (−y, x): v turned by +90°, %s on screen.") % turn,
		_translate("(y, −x) is the opposite normal. A line has two; code must stay with one."),
		_translate("Divide n by its length: the unit normal n̂ has length 1. Normal is not unit!"),
		_translate("1 pixel cannot be seen: a line's normal is drawn k times as long."),
	]


## The way in which +90 degrees turns on the screen, as one word.
static func clockwise_text(model: NormalsModel) -> String:
	if model.is_y_up:
		return _translate("counter-clockwise")
	return _translate("clockwise")


static func _translate(sentence: String) -> String:
	return TranslationServer.translate(sentence)
