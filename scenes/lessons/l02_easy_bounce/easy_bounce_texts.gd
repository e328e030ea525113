class_name EasyBounceTexts
extends RefCounted
## The sentences of the lesson on the easy bounce, step by step.

## The steps: what a program does in one frame, and all of it.
enum Step { MOVE, DETECT, PUT_BACK, FLIP, BOUNCE }

# A double has no more.
const _MOST_DIGITS := 17


## One sentence a step, translated, for the ball [param moved] of [param model].
static func sentences(model: EasyBounceModel, moved: Ball) -> PackedStringArray:
	return [
		_move_sentence(model, moved),
		_detect_sentence(model),
		_put_back_sentence(model, moved),
		_flip_sentence(model, moved),
		_bounce_sentence(model),
	]


## How a distance compares with the radius, and whether that is a hit for the program, with as many
## digits as tell them apart.
static func hit_text(distance: float, radius: float, is_hit: bool) -> String:
	for digits in range(4, _MOST_DIGITS + 1):
		var texts := [NumberText.short(distance, digits), NumberText.short(radius, digits)]
		if texts[0] == texts[1]:
			continue
		if (distance < radius) != is_hit:
			return LabText.translate("%s ≈ r = %s: rounding decides") % texts
		if is_hit:
			return LabText.translate("%s < r = %s: hit") % texts
		return LabText.translate("%s > r = %s: no hit") % texts
	return LabText.translate("%s = r: it just touches") % NumberText.short(distance)


## Whether the velocity matters in [param step]; elsewhere its arrow would only be in the way.
static func needs_velocity(step: int) -> bool:
	return step != Step.DETECT and step != Step.PUT_BACK


static func _move_sentence(model: EasyBounceModel, moved: Ball) -> String:
	if not model.right_detects(moved):
		return LabText.translate(
			"Move: each frame adds v to P. Here the ball does not reach the line."
		)
	if model.shortest_distance(moved.position) <= -moved.radius:
		return LabText.translate("Move: each frame adds v to P. Now the ball is behind the line.")
	return LabText.translate("Move: each frame adds v to P. Now the ball overlaps the line.")


static func _detect_sentence(model: EasyBounceModel) -> String:
	if not model.is_level():
		return LabText.translate(
			"Detect: on a tilted line the shortest way counts, along the perpendicular."
		)
	if model.is_wall:
		return LabText.translate("Detect: x is enough. If wall − x is less than r, it is a hit.")
	return LabText.translate("Detect: y is enough. If floor − y is less than r, it is a hit.")


static func _put_back_sentence(model: EasyBounceModel, moved: Ball) -> String:
	if not model.right_detects(moved):
		return LabText.translate("Put back: only after a hit. Here the ball does not hit.")
	if not model.is_level():
		return LabText.translate(
			"Put back: along the normal n̂, until the ball just touches the line."
		)
	if model.is_wall:
		return LabText.translate("Put back: change only x, until the ball just touches the wall.")
	return LabText.translate("Put back: change only y, until the ball just touches the floor.")


static func _flip_sentence(model: EasyBounceModel, moved: Ball) -> String:
	if not model.right_detects(moved):
		return LabText.translate("Flip: only after a hit. Here the ball does not hit.")
	if not model.right_reflects(moved):
		return LabText.translate("Flip: only where v points into the line. Here v stays.")
	if not model.is_level():
		return LabText.translate("Flip: only the part of v along the normal n̂ changes its sign.")
	if model.is_wall:
		return LabText.translate("Flip: x of v changes its sign, y stays.")
	return LabText.translate("Flip: y of v changes its sign, x stays.")


static func _bounce_sentence(model: EasyBounceModel) -> String:
	if model.is_level():
		return LabText.translate("Play it, frame by frame. Then tilt the line at one of its ends!")
	if model.agrees():
		return LabText.translate("Here both programs do the same. Move the ball, or tilt the line.")
	return LabText.translate("Play it, frame by frame: the easy ball goes astray.")
