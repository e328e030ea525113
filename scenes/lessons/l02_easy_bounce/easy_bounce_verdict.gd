class_name EasyBounceVerdict
extends VerdictCard
## Says whether the shown step of the easy program is right for the ball as it is, and how far
## off it is.


## Shows the words for the ball [param moved] of [param model] at [param step] of
## [EasyBounceTexts].
func show_model(model: EasyBounceModel, moved: Ball, step: int) -> void:
	var words := _words_for(model, moved, step)
	if model.tilt_degrees == 0.0:
		show_verdict("✓", Palette.Role.RIGHT, words)
	else:
		show_verdict("✗", Palette.Role.WRONG, words)
	_keep_from_line(model)


# Moves to the corner into which neither the line nor the balls reach.
func _keep_from_line(model: EasyBounceModel) -> void:
	var corner := Control.PRESET_BOTTOM_RIGHT
	if model.is_wall and model.tilt_degrees < 0.0:
		corner = Control.PRESET_TOP_RIGHT
	elif not model.is_wall and model.tilt_degrees > 0.0:
		corner = Control.PRESET_BOTTOM_LEFT
	stand_in(corner)


func _words_for(model: EasyBounceModel, moved: Ball, step: int) -> PackedStringArray:
	if model.tilt_degrees == 0.0:
		return [tr("The easy way is right:"), tr("error 0 in all three steps")]
	match step:
		EasyBounceTexts.Step.DETECT:
			return _two(
				tr("Straight is not shortest:"), tr("%s px too far"), model.distance_error(moved)
			)
		EasyBounceTexts.Step.PUT_BACK:
			return _put_back_words(model, moved)
		EasyBounceTexts.Step.FLIP:
			return _two(
				tr("Flipped is not reflected:"),
				tr("%s px per frame off"),
				model.velocity_error(moved)
			)
	return [tr("A tilted line:"), tr("each of the three steps is wrong")]


func _put_back_words(model: EasyBounceModel, moved: Ball) -> PackedStringArray:
	var easy := model.easy_result(moved)
	var overlap := -LineDistance.gap(easy, model.line())
	var first := tr("Put back %s px off") % NumberText.short(model.position_error(moved), 3)
	if overlap > 1e-9:
		return [first, tr("and still %s px deep") % NumberText.short(overlap, 3)]
	return [first, ""]


func _two(first: String, second: String, number: float) -> PackedStringArray:
	return [first, second % NumberText.short(number, 3)]
