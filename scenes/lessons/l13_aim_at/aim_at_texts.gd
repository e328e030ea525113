class_name AimAtTexts
extends RefCounted
## The sentences and the verdict of the lesson on aiming at a target.


## One sentence a step, translated.
static func sentences(model: AimAtModel, shots: AimShots) -> PackedStringArray:
	return [
		LabText.translate("The barrel turns on the hull: it points along γ = α + β. Drag both."),
		LabText.translate(
			"A shot that gravity pulls turns its sprite with v: its angle is atan2(vy, vx)."
		),
		_on_look(model),
		_on_nested(model),
		_on_turn(model),
		_on_early(model, shots),
		_on_fire(model),
	]


static func _has_no_direction(model: AimAtModel) -> bool:
	return model.shot_case() == AimAtModel.Case.NO_DIRECTION


static func _on_look(model: AimAtModel) -> String:
	if _has_no_direction(model):
		return LabText.translate("Hull and target are in one place: there is no direction.")
	return LabText.translate(
		"The hull sees the target at θ = atan2(y, x) of T − P. Drag the target."
	)


static func _on_nested(model: AimAtModel) -> String:
	if _has_no_direction(model):
		return LabText.translate("Without a direction there is no angle for the barrel.")
	return LabText.translate(
		"The hull has turned the barrel along by α. What is left for the barrel itself is θ − α."
	)


static func _on_turn(model: AimAtModel) -> String:
	if model.turn_degrees() == 0.0 or _has_no_direction(model):
		return LabText.translate("Nothing has to be turned.")
	return LabText.translate(
		"It turns the short way, by δ, and does half of what is left in each h seconds. Press Play."
	)


static func _on_early(model: AimAtModel, shots: AimShots) -> String:
	if _has_no_direction(model):
		return LabText.translate("Without a direction there is nothing to fire at.")
	if model.shot_case() == AimAtModel.Case.TOO_NEAR:
		return LabText.translate(
			"The target is nearer than the nozzle: the bullet starts behind it."
		)
	if shots.early.hits():
		return LabText.translate(
			"After t seconds of turning the barrel is near enough: it hits the disc."
		)
	return LabText.translate("It fires after t seconds, before the barrel is aligned, and misses.")


static func _on_fire(model: AimAtModel) -> String:
	match model.shot_case():
		AimAtModel.Case.NO_DIRECTION:
			return LabText.translate("Without a direction there is nothing to fire at.")
		AimAtModel.Case.TOO_NEAR:
			return LabText.translate(
				"The target is nearer than the nozzle: the bullet starts behind it."
			)
	return LabText.translate(
		"Aligned, it fires from the nozzle. ε × condition is how far rounding alone may move it."
	)


## What is asked before the barrel's own angle is shown, translated.
static func question_on_angle() -> String:
	return LabText.translate(
		"By how much must the barrel be turned on its hull to point at the target?"
	)


## The answers to [method question_on_angle], translated.
static func choices_on_angle(model: AimAtModel) -> PackedStringArray:
	var seen := model.target_degrees()
	return [
		Conventions.angle_text(Conventions.in_range(seen)),
		Conventions.angle_text(Conventions.in_range(model.wanted_degrees())),
		Conventions.angle_text(Conventions.in_range(AimAtModel.short(seen + model.hull_degrees)))
	]


## The right one of [method choices_on_angle]; -1 where the hull has not turned, or where two are
## the same.
static func right_angle_choice(model: AimAtModel) -> int:
	var choices := choices_on_angle(model)
	var is_clear := choices[0] != choices[1] and choices[1] != choices[2]
	return 1 if is_clear and not _has_no_direction(model) else -1


## What is asked before the turn is shown, translated.
static func question_on_turn() -> String:
	return LabText.translate("Which way round is it shorter from the barrel to the target?")


## The answers to [method question_on_turn], translated.
static func choices_on_turn() -> PackedStringArray:
	return [LabText.translate("clockwise"), LabText.translate("counter-clockwise")]


## The right one of [method choices_on_turn]; -1 where there is no turn, or half a turn.
static func right_turn_choice(model: AimAtModel) -> int:
	var turn := model.turn_degrees()
	if _has_no_direction(model) or absf(turn) < 0.5 or absf(turn) > 179.5:
		return -1
	return 0 if turn > 0.0 else 1


## Whether the mistake that is switched on is shown at [param step].
static func is_compared(model: AimAtModel, step: int) -> bool:
	if model.mistake == AimAtMistakes.LONG_WAY:
		return step == AimAtModel.Step.TURN
	return model.mistake != 0 and step == AimAtModel.Step.FIRE


## The step at which a mistake is compared, for who switches it on at any step.
static func step_of_mistake(mistake: int, _step: int) -> int:
	return AimAtModel.Step.TURN if mistake == AimAtMistakes.LONG_WAY else AimAtModel.Step.FIRE


## What was found at [param step], in a few lines, translated.
static func verdict(model: AimAtModel, shots: AimShots, step: int) -> PackedStringArray:
	match model.shot_case():
		AimAtModel.Case.NO_DIRECTION:
			return [LabText.translate("no direction: hull and target are in one place")]
		AimAtModel.Case.TOO_NEAR when step >= AimAtModel.Step.EARLY:
			return [
				LabText.translate("the target is nearer than the nozzle"),
				LabText.translate("the bullet starts behind it")
			]
	var words := _words_of_step(model, shots, step)
	if is_compared(model, step):
		words.append(_mistake_words(model, shots))
	return words


static func _words_of_step(model: AimAtModel, shots: AimShots, step: int) -> PackedStringArray:
	match step:
		AimAtModel.Step.NESTED:
			return [LabText.translate("on the hull: %s") % _angle(model.wanted_degrees())]
		AimAtModel.Step.TURN:
			return [LabText.translate("the short way: %s") % _turn(model.turn_degrees())]
		AimAtModel.Step.EARLY:
			return _words_on_early(model, shots.early)
	var words: PackedStringArray = []
	# On a small board the card has to be short.
	if not is_compared(model, step):
		var flight := NumberText.short(shots.right.moment)
		words.append(LabText.translate("it hits %s s after the shot") % flight)
	words.append(ShotText.of_right(shots.right.miss, shots.right.from_rounding()))
	return words


static func _words_on_early(model: AimAtModel, early: AimShot) -> PackedStringArray:
	var left := Conventions.angle_text(absf(model.left_degrees(model.fire)), 3)
	var words: PackedStringArray = [LabText.translate("still %s off") % left]
	if early.hits():
		words.append(LabText.translate("it passes within R: it hits"))
	else:
		words.append(LabText.translate("it %s") % ShotText.of_wrong(early.miss))
	var wait := model.least_wait()
	if not early.hits() and is_finite(wait):
		words.append(LabText.translate("from t = %s s on it hits") % NumberText.short(wait, 3))
	return words


# The angle of a vector, as it is shown.
static func _angle(degrees: float) -> String:
	return Conventions.angle_text(Conventions.in_range(degrees))


static func _turn(degrees: float) -> String:
	if degrees == 0.0:
		return Conventions.angle_text(0.0)
	var way := LabText.translate("clockwise" if degrees > 0.0 else "counter-clockwise")
	return "%s %s" % [Conventions.angle_text(absf(degrees)), way]


static func _mistake_words(model: AimAtModel, shots: AimShots) -> String:
	if not model.shows_mistake():
		return LabText.translate("the mistake changes nothing here")
	if model.mistake == AimAtMistakes.LONG_WAY:
		return LabText.translate("the mistake: %s") % _turn(model.wrong_turn_degrees())
	if shots.wrong.hits():
		return LabText.translate("the mistake hits all the same")
	return LabText.translate("the mistake %s") % ShotText.of_wrong(shots.wrong.miss)
