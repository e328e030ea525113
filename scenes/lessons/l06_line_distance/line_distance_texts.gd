class_name LineDistanceTexts
extends RefCounted
## The sentences and the verdict of the lesson on the distance from a line.

## The steps, counted from 0.
enum Step { DIFFERENCE, NORMAL, DISTANCE, GAP, SEGMENT, DETECTION }


## One sentence a step, translated.
static func sentences(model: LineDistanceModel) -> PackedStringArray:
	var found: PackedStringArray = [
		LabText.translate(
			"d leads from p, a point on the line, to the ball's centre c. Slide p: d changes."
		),
		(
			LabText
			. translate(
				"The unit normal n̂ is perpendicular to the line. It points to the good side: the balls' side."
			)
		),
		(
			LabText
			. translate(
				"d · n̂, the shadow of d on n̂, is the distance of c. Slide p: d changes, d · n̂ does not."
			)
		),
		LabText.translate("Subtract the radius, and you have the gap between ball and line."),
		_on_segment(model),
		_on_detection(model),
	]
	for step in found.size():
		if is_compared(model, step):
			found[step] = LabText.translate(
				"Compare the distance of the mistake with the right one."
			)
	return found


## Whether a mistake that is switched on is shown at [param step]: not before the right distance is,
## and not while the ball flies.
static func is_compared(model: LineDistanceModel, step: int) -> bool:
	return model.mistake != 0 and step >= Step.DISTANCE and step < Step.DETECTION


## The step at which a mistake is compared, for who switches it on at [param step].
static func step_of_mistake(_mistake: int, step: int) -> int:
	return step if step >= Step.DISTANCE and step < Step.DETECTION else Step.DISTANCE


## What is asked before the distance is shown, translated.
static func question_on_foot() -> String:
	return LabText.translate(
		"Which point on the line is nearest to c? Drag the “?” there, then step forward."
	)


## What is asked before the gap is shown, translated.
static func question_on_gap() -> String:
	return LabText.translate("Is the ball free, too close to the line, or behind it?")


## The answers to [method question_on_gap], translated.
static func choices() -> PackedStringArray:
	return [LabText.translate("free"), LabText.translate("too close"), LabText.translate("behind")]


## The right one of [method choices], counted from 0; -1 for a ball that just touches: none is.
static func right_choice(model: LineDistanceModel) -> int:
	if model.is_touching():
		return -1
	if model.is_behind():
		return 2
	return 1 if model.is_overlapping() else 0


## The word above the ball, translated.
static func ball_word(model: LineDistanceModel) -> String:
	var choice := right_choice(model)
	return LabText.translate("touching") if choice < 0 else choices()[choice]


## The number of the gap; what rounding alone leaves of it is 0.
static func gap_text(model: LineDistanceModel) -> String:
	return "0" if model.is_touching() else NumberText.short(model.gap())


## What was found at [param step], in two or three lines, translated.
static func verdict(model: LineDistanceModel, step: int) -> PackedStringArray:
	if step == Step.DETECTION:
		return _detection_words(model)
	var words: PackedStringArray = [_gap_words(model), _side_words(model, step)]
	if model.mistake != 0:
		words.append(_mistake_words(model))
	return words


## The tests of the last step, translated, in the order of [enum DiscreteDetection.Rule].
static func rules() -> PackedStringArray:
	return [
		LabText.translate("red where d · n̂ < r"),
		LabText.translate("red only in front: 0 ≤ d · n̂ < r"),
		LabText.translate("red on both sides: |d · n̂| < r"),
	]


static func _detection_words(model: LineDistanceModel) -> PackedStringArray:
	var seen := model.detection().red_count(model.frame)
	var words: PackedStringArray = [
		LabText.translate("red in %d of %d frames") % [seen, model.frame + 1]
	]
	if model.detection().is_never_seen():
		words.append(LabText.translate("it passes between two frames"))
	return words


static func _on_detection(model: LineDistanceModel) -> String:
	if model.detection().is_never_seen():
		return (
			LabText
			. translate(
				"Discrete detection looks once a frame: a ball this fast jumps over the line and is never seen."
			)
		)
	match model.rule:
		DiscreteDetection.Rule.ONLY_ABOVE:
			return (
				LabText
				. translate(
					"Discrete detection looks once a frame: red only in front of the line, closer than r."
				)
			)
		DiscreteDetection.Rule.BOTH_SIDES:
			return (
				LabText
				. translate(
					"Discrete detection looks once a frame: red on both sides of the line, closer than r."
				)
			)
	return LabText.translate(
		"Discrete detection looks once a frame: red where d · n̂ < r, far behind the line, too."
	)


static func _gap_words(model: LineDistanceModel) -> String:
	var gap := gap_text(model)
	if model.is_behind():
		return LabText.translate("Behind the line: gap %s px") % gap
	if model.is_touching():
		return LabText.translate("It just touches the line: gap 0 px")
	if model.is_overlapping():
		return LabText.translate("Too close: gap %s px") % gap
	return LabText.translate("Free: gap %s px") % gap


static func _side_words(model: LineDistanceModel, step: int) -> String:
	if model.is_beside_end() and step < Step.SEGMENT:
		return LabText.translate("measured to the line without ends")
	if model.is_beside_end():
		var gap := NumberText.short(model.segment_distance() - model.ball.radius)
		return LabText.translate("but the gap to the segment is %s px") % gap
	if model.is_behind():
		return LabText.translate("d · n̂ is negative on this side")
	if model.is_on_line():
		return LabText.translate("its centre is on the line")
	return LabText.translate("on the good side, where n̂ points")


static func _mistake_words(model: LineDistanceModel) -> String:
	var wrong := model.distance_with_mistake()
	if not is_finite(wrong):
		return LabText.translate("the mistake has no answer: this line is vertical")
	var gap := NumberText.short(wrong - model.ball.radius)
	return LabText.translate("the mistake says: gap %s px") % gap


static func _on_segment(model: LineDistanceModel) -> String:
	if model.is_beside_end():
		return LabText.translate(
			"Past an end, the segment is farther away than the line without ends."
		)
	if model.is_behind():
		return LabText.translate(
			"The distance to the segment has no sign: it does not tell the sides apart."
		)
	return LabText.translate(
		"A segment has ends. Here its distance is the same. Drag the ball past an end."
	)
