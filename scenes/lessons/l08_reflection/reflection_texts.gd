class_name ReflectionTexts
extends RefCounted
## The sentences and the verdict of the lesson on reflection, step by step.


## One sentence a step, translated.
static func sentences(model: ReflectionModel) -> PackedStringArray:
	if model.refusal():
		return _at_each_step(
			LabText.translate("n does not have length 1. reflect refuses it, and v stays as it is.")
		)
	if not model.velocity.length():
		return _at_each_step(LabText.translate("v = 0: the ball does not move."))
	var meet := LabText.translate(
		"A ball with velocity v meets a line. n̂ is the line's unit normal."
	)
	if model.is_along_line():
		var nothing := _at_each_step(
			LabText.translate("v · n̂ = 0: no part of v goes into the line. v stays as it is.")
		)
		nothing[0] = meet
		return nothing
	return [
		meet,
		_on_part(model),
		_on_slide(model),
		LabText.translate("Subtract it twice: the law of reflection. Both angles are equal."),
		LabText.translate(
			"Subtract it (1 + C) times. C is the coefficient of restitution (or reflection)."
		),
		_on_next_frame(model),
	]


static func _at_each_step(sentence: String) -> PackedStringArray:
	var found: PackedStringArray = []
	found.resize(ReflectionModel.Step.size())
	found.fill(sentence)
	return found


## What is asked before the ball slides, translated.
static func question_on_slide() -> String:
	return LabText.translate("What does the ball do if (v · n̂) n̂ is subtracted from v once?")


## The answers to [method question_on_slide], translated.
static func choices() -> PackedStringArray:
	return [
		LabText.translate("it bounces off"),
		LabText.translate("it slides along the line"),
		LabText.translate("it flies through")
	]


## What is asked before the reflection is shown, translated.
static func question_on_mirror() -> String:
	return LabText.translate(
		"The ball bounces and loses nothing. Where is the head of the new v? Drag the “?” there."
	)


## Two or three lines for the card on the board: the angles to the normal, what is left of the
## energy, and the answer of a mistake.
static func verdict(model: ReflectionModel, step: ReflectionModel.Step) -> PackedStringArray:
	var times := model.times_subtracted(step)
	var words: PackedStringArray = [_angles(model, times)]
	if model.velocity.length() > 0.0:
		var share := model.energy_share(model.velocity_after(times))
		var percent := 0.0 if model.stops_after(times) else share * 100.0
		var is_elastic := times == 2.0 and not model.is_along_line()
		words.append(
			(
				LabText.translate("elastic: it keeps all its energy")
				if is_elastic
				else LabText.translate("keeps %s %% of its energy") % NumberText.short(percent, 3)
			)
		)
	if model.mistake_shows():
		var wrong := model.velocity_with_mistake()
		words.append(LabText.translate("the mistake says: %s") % NumberText.pair(wrong.x, wrong.y))
	elif model.mistake != 0:
		words.append(LabText.translate("the mistake changes nothing here"))
	return words


## The sign that the card carries: whether the angles are equal; a cross where a mistake says
## something else.
static func verdict_sign(model: ReflectionModel, step: ReflectionModel.Step) -> String:
	if model.mistake_shows():
		return "✗"
	if not model.velocity.length():
		return "0"
	return "=" if model.has_equal_angles(model.times_subtracted(step)) else "≠"


static func _on_part(model: ReflectionModel) -> String:
	if model.velocity.dot(model.unit_normal()) < 0.0:
		return LabText.translate(
			"v · n̂ < 0: n̂ points to the ball's side. (v · n̂) n̂ is the part of v along n̂."
		)
	return LabText.translate(
		"v · n̂ > 0: n̂ points to the other side. (v · n̂) n̂ is the part of v along n̂."
	)


static func _on_slide(model: ReflectionModel) -> String:
	if model.stops_after(1.0):
		return LabText.translate("Subtract that part once: nothing is left of v. The ball stops.")
	return LabText.translate(
		"Subtract that part once: nothing goes into the line. The ball slides."
	)


static func _on_next_frame(model: ReflectionModel) -> String:
	if not model.leaves_line():
		return (
			LabText
			. translate(
				"It may overlap in the next frame, too. Reflect only if v · n̂ < 0: now it is 0, v stays."
			)
		)
	if model.faces_ball():
		return (
			LabText
			. translate(
				"It may overlap in the next frame, too. Reflect only if v · n̂ < 0: now it is above 0, v stays."
			)
		)
	return LabText.translate(
		"It may still overlap. Reflect only if v · (−n̂) < 0, −n̂ being on its side: v stays."
	)


static func _angles(model: ReflectionModel, times: float) -> String:
	if not model.velocity.length():
		return LabText.translate("v = 0: the ball does not move")
	if model.is_along_line():
		return LabText.translate("it moves along the line")
	var angle_in := Conventions.angle_text(model.angle_in_degrees())
	if model.stops_after(times):
		return LabText.translate("in %s from n̂, and it stops") % angle_in
	var angle_out := Conventions.angle_text(model.angle_out_degrees(model.velocity_after(times)))
	return LabText.translate("in %s, out %s from n̂") % [angle_in, angle_out]
