class_name EasyBounceTexts
extends RefCounted
## The sentences of the lesson on the easy bounce, step by step.

## The steps: what a program does in one frame, and all of it.
enum Step { MOVE, DETECT, PUT_BACK, FLIP, BOUNCE }


## One sentence a step, translated.
static func sentences(model: EasyBounceModel) -> PackedStringArray:
	if model.tilt_degrees != 0.0:
		return _sentences_for_tilted()
	return _sentences_for_wall() if model.is_wall else _sentences_for_floor()


## What is said behind a distance: whether it means a hit.
static func hit_text(is_hit: bool) -> String:
	return LabText.translate("< r: hit") if is_hit else "≥ r"


## Whether the velocity matters in [param step]; elsewhere its arrow would only be in the way.
static func needs_velocity(step: int) -> bool:
	return step != Step.DETECT and step != Step.PUT_BACK


static func _sentences_for_floor() -> PackedStringArray:
	return [
		LabText.translate("Move: in each frame the ball moves by v, here into the floor."),
		LabText.translate("Detect: y alone tells. If floor − y is less than r, it is a hit."),
		LabText.translate("Put back: only y changes, until the ball just touches the floor."),
		LabText.translate("Flip: y of v changes its sign, x stays."),
		LabText.translate(
			"Right on a level floor. Play it, then tilt the line at one of its ends!"
		),
	]


static func _sentences_for_wall() -> PackedStringArray:
	return [
		LabText.translate("Move: in each frame the ball moves by v, here into the wall."),
		LabText.translate("Detect: x alone tells. If wall − x is less than r, it is a hit."),
		LabText.translate("Put back: only x changes, until the ball just touches the wall."),
		LabText.translate("Flip: x of v changes its sign, y stays."),
		LabText.translate(
			"Right on an upright wall. Play it, then tilt the line at one of its ends!"
		),
	]


static func _sentences_for_tilted() -> PackedStringArray:
	return [
		LabText.translate("Move: in each frame the ball moves by v, here into a tilted line."),
		LabText.translate("Wrong distance: the shortest one counts, along the perpendicular."),
		LabText.translate("Put back the wrong way: it has to be along the normal."),
		LabText.translate("Flipped the wrong way: the velocity is reflected at the line."),
		LabText.translate("The easy ball goes astray. Play both, or go frame by frame."),
	]
