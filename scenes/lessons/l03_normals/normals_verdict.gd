class_name NormalsVerdict
extends VerdictCard
## Says which way +90 degrees turns on the screen, and what a change of the line did to its normal.
## It comes with the normal.

const _MOST_DIGITS := 17


## Shows the words for [param model] at [param step] of [NormalsTexts], and for what has changed
## since [param before]; null where nothing has.
func show_model(model: NormalsModel, before: NormalsModel, step: int) -> void:
	visible = step >= NormalsTexts.Step.NORMAL or model.mistake != 0
	if model.is_mistaken():
		show_verdict("✗", Palette.Role.WRONG, _mistake_words(model))
	elif not model.has_direction():
		show_verdict(
			"0", Palette.Role.QUIET, [tr("The zero vector"), tr("has no direction and no normal")]
		)
	elif model.mistake != 0:
		show_verdict("=", Palette.Role.QUIET, [tr("Here the mistake"), tr("does not show")])
	else:
		show_verdict("+", Palette.Role.RIGHT, [_turn_words(), _change_words(model, before)])


## Moves to the corner behind v, into which neither v nor a normal of [param model] points.
func stand_behind(model: NormalsModel) -> void:
	var v := model.v()
	var points_down := (v.y < 0.0) == Conventions.is_y_up()
	if v.x >= 0.0:
		stand_in(PRESET_TOP_LEFT if points_down else PRESET_BOTTOM_LEFT)
	else:
		stand_in(PRESET_TOP_RIGHT if points_down else PRESET_BOTTOM_RIGHT)


func _turn_words() -> String:
	return tr("+90° turns %s") % NormalsTexts.clockwise_text()


func _change_words(model: NormalsModel, before: NormalsModel) -> String:
	var change := NormalsModel.Change.NONE
	if before:
		change = model.change_since(before.start, before.v())
	match change:
		NormalsModel.Change.MOVED:
			return tr("moved: v and its normals stay")
		NormalsModel.Change.STRETCHED:
			return tr("same slope: n̂ stays")
		NormalsModel.Change.TURNED:
			var degrees := Conventions.in_range(model.turned_degrees(before.v()))
			return tr("turned by %s, and so is n") % Conventions.angle_text(degrees, 3)
	return tr("y points up") if Conventions.is_y_up() else tr("y points down")


func _mistake_words(model: NormalsModel) -> PackedStringArray:
	if model.mistake == NormalsMistakes.WRONG_NORMAL:
		return [_swapped_words(model.v()), tr("(y, −x): −90°, the other side")]
	var wrong := NormalsMistakes.wrong_unit(model.mistake, model.v())
	var right := model.unit()
	return [
		tr("wrong: %s") % NumberText.pair(wrong.x, wrong.y),
		tr("right: %s") % NumberText.pair(right.x, right.y),
	]


# With as many digits as tell the angle from 90 degrees; on an axis it can be right.
func _swapped_words(v: Vec2) -> String:
	var turned := Vec2.rad_to_deg(v.angle_to(NormalsMistakes.swapped(v)))
	var degrees := Conventions.in_range(turned)
	for digits in range(3, _MOST_DIGITS):
		var text := Conventions.angle_text(degrees, digits)
		if not text in _right_angles(digits):
			return tr("(y, x): %s from v, not +90°") % text
	return tr("(y, x): +90° by luck, as y is 0") if v.y == 0.0 else tr("(y, x): nearly +90°")


# As which a right angle can be written, with so many digits.
static func _right_angles(digits: int) -> PackedStringArray:
	return ["90°", "π/2", NumberText.short(PI / 2.0, digits) + " rad"]
