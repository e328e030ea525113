class_name LineDistanceTexts
extends RefCounted
## The sentences and the verdict of the lesson on the distance from a line.


## One sentence a step, translated.
static func sentences(model: LineDistanceModel) -> PackedStringArray:
	return [
		_translate("d leads from a point p of the line to the ball's centre c. Slide p."),
		_translate("The unit normal n̂ is perpendicular to the line. Its side is the good one."),
		_translate("The shadow of d on n̂ is the distance of c. Slide p: d changes, this stays."),
		_translate("Less the radius: the gap. Below 0 is too close, or behind the line."),
		_beside_end(model),
	]


## The word above the ball, translated.
static func ball_word(model: LineDistanceModel) -> String:
	if model.is_behind():
		return _translate("behind")
	return _translate("too close") if model.is_overlapping() else _translate("free")


## What was found, in two or three lines, translated.
static func verdict(model: LineDistanceModel) -> PackedStringArray:
	var words: PackedStringArray = [_gap_words(model.gap(), model.is_behind()), _side_words(model)]
	if model.mistake != 0:
		var wrong := NumberText.short(model.distance_with_mistake() - model.ball.radius)
		words.append(_translate("the mistake says: a gap of %s px") % wrong)
	return words


static func _gap_words(gap: float, is_behind: bool) -> String:
	if is_behind:
		return _translate("Behind the line: %s px too far") % NumberText.short(-gap)
	if gap < 0.0:
		return _translate("Too close by %s px") % NumberText.short(-gap)
	return _translate("Free: a gap of %s px") % NumberText.short(gap)


static func _side_words(model: LineDistanceModel) -> String:
	if model.is_beside_end():
		var gap := NumberText.short(model.segment_distance() - model.ball.radius)
		return _translate("beside the end: gap to the segment %s px") % gap
	if model.is_behind():
		return _translate("the distance is negative here")
	return _translate("on the good side, where n̂ points")


static func _beside_end(model: LineDistanceModel) -> String:
	if model.is_beside_end():
		return _translate("Beside the end both distances differ: the endless line is nearer.")
	return _translate("Here both distances agree. Drag the ball past an end of the line.")


static func _translate(sentence: String) -> String:
	return TranslationServer.translate(sentence)
