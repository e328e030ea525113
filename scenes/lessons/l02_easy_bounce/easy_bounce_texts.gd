class_name EasyBounceTexts
## The sentences and formula lines of the lesson on the easy bounce, step by step.

## The steps: what a program does in one frame, and all of it.
enum Step { MOVE, DETECT, PUT_BACK, FLIP, BOUNCE }


## One sentence a step, translated.
static func sentences(model: EasyBounceModel) -> PackedStringArray:
	if model.tilt_degrees != 0.0:
		return _sentences_for_tilted()
	return _sentences_for_wall() if model.is_wall else _sentences_for_floor()


## The formula lines of [param step] for the ball [param moved].
static func lines(model: EasyBounceModel, moved: Ball, step: int) -> PackedStringArray:
	var found: PackedStringArray = [
		"{p} = ( {px} , {py} )     {v} = ( {vx} , {vy} )",
		"r = {r}     " + _translate("tilt") + " = {tilt}°     " + _translate("frame") + " {frame}",
	]
	var wanted: Array[int] = [step]
	if step == Step.BOUNCE:
		wanted = [Step.DETECT, Step.PUT_BACK, Step.FLIP]
	for one in wanted:
		found.append_array(_easy_lines(model, moved, one))
		if step != Step.BOUNCE and model.tilt_degrees != 0.0:
			found.append_array(_right_lines(one))
	return found


## Whether a distance means a hit, in words.
static func hit_text(is_hit: bool) -> String:
	return _translate("< r: hit") if is_hit else "≥ r"


## Whether the velocity matters in [param step]; where it does not, it only crosses the drawing.
static func needs_velocity(step: int) -> bool:
	return step != Step.DETECT and step != Step.PUT_BACK


static func _sentences_for_floor() -> PackedStringArray:
	return [
		_translate("Move: in each frame the ball moves by v, here into the floor."),
		_translate("Detect: y alone tells. If floor − y is less than r, it is a hit."),
		_translate("Put back: only y changes, until the ball just touches the floor."),
		_translate("Flip: y of v changes its sign, x stays."),
		_translate("Right on a level floor. Play it, then tilt the line at one of its ends!"),
	]


static func _sentences_for_wall() -> PackedStringArray:
	return [
		_translate("Move: in each frame the ball moves by v, here into the wall."),
		_translate("Detect: x alone tells. If wall − x is less than r, it is a hit."),
		_translate("Put back: only x changes, until the ball just touches the wall."),
		_translate("Flip: x of v changes its sign, y stays."),
		_translate("Right on an upright wall. Play it, then tilt the line at one of its ends!"),
	]


static func _sentences_for_tilted() -> PackedStringArray:
	return [
		_translate("Move: in each frame the ball moves by v, here into a tilted line."),
		_translate("Wrong distance: the shortest one counts, along the perpendicular."),
		_translate("Put back the wrong way: it has to be along the normal."),
		_translate("Flipped the wrong way: the velocity is reflected at the line."),
		_translate("The easy ball goes astray. Play both, or go frame by frame."),
	]


static func _easy_lines(model: EasyBounceModel, moved: Ball, step: int) -> PackedStringArray:
	var line_name := _translate("wall") if model.is_wall else _translate("floor")
	var axis := "x" if model.is_wall else "y"
	match step:
		Step.DETECT:
			var place := "{p_axis}"
			return [
				"{easy} %s − %s = {line_at} − %s = {straight} {easy_hit}" % [line_name, axis, place]
			]
		Step.PUT_BACK when model.easy_detects(moved):
			return ["{easy} %s = %s − r = {line_at} − {radius} = {back}" % [axis, line_name]]
		Step.PUT_BACK:
			return ["{easy} " + _translate("no hit: it stays where it is")]
		Step.FLIP:
			return ["{easy} v = {v_easy}"]
	return []


static func _right_lines(step: int) -> PackedStringArray:
	match step:
		Step.DETECT:
			return ["{right} (P − L) · {n} = {shortest} {right_hit}"]
		Step.PUT_BACK:
			return ["{right} P + {depth} {n} = {p_right}"]
		Step.FLIP:
			return ["{right} v − 2 (v · {n}) {n} = {v_right}"]
	return []


static func _translate(sentence: String) -> String:
	return TranslationServer.translate(sentence)
