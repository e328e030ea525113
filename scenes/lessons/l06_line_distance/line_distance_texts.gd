class_name LineDistanceTexts
extends RefCounted
## The sentences and the verdict of the lesson on the distance from a line.


## One sentence a step, translated.
static func sentences(model: LineDistanceModel) -> PackedStringArray:
	return [
		LabText.translate("d leads from a point p of the line to the ball's centre c. Slide p."),
		LabText.translate(
			"The unit normal n̂ is perpendicular to the line. Its side is the good one."
		),
		LabText.translate(
			"The shadow of d on n̂ is the distance of c. Slide p: d changes, this stays."
		),
		LabText.translate("Less the radius: the gap. Below 0 is too close, or behind the line."),
		_beside_end(model),
	]


## The word above the ball, translated.
static func ball_word(model: LineDistanceModel) -> String:
	if model.is_behind():
		return LabText.translate("behind")
	return LabText.translate("too close") if model.is_overlapping() else LabText.translate("free")


## What was found, in two or three lines, translated.
static func verdict(model: LineDistanceModel) -> PackedStringArray:
	var words: PackedStringArray = [_gap_words(model.gap(), model.is_behind()), _side_words(model)]
	if model.mistake != 0:
		var wrong := NumberText.short(model.distance_with_mistake() - model.ball.radius)
		words.append(LabText.translate("the mistake says: a gap of %s px") % wrong)
	return words


static func _gap_words(gap: float, is_behind: bool) -> String:
	if is_behind:
		return LabText.translate("Behind the line: %s px too far") % NumberText.short(-gap)
	if gap < 0.0:
		return LabText.translate("Too close by %s px") % NumberText.short(-gap)
	return LabText.translate("Free: a gap of %s px") % NumberText.short(gap)


static func _side_words(model: LineDistanceModel) -> String:
	if model.is_beside_end():
		var gap := NumberText.short(model.segment_distance() - model.ball.radius)
		return LabText.translate("beside the end: gap to the segment %s px") % gap
	if model.is_behind():
		return LabText.translate("the distance is negative here")
	return LabText.translate("on the good side, where n̂ points")


static func _beside_end(model: LineDistanceModel) -> String:
	if model.is_beside_end():
		return LabText.translate(
			"Beside the end both distances differ: the endless line is nearer."
		)
	return LabText.translate("Here both distances agree. Drag the ball past an end of the line.")
