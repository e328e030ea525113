class_name TimedShotTexts
extends RefCounted
## The sentences and the verdict of the lesson on the moment to fire, step by step.


## One sentence a step, translated.
static func sentences(model: TimedShotModel) -> PackedStringArray:
	return [
		_on_watch(model),
		_on_cross(model),
		_on_wait(model),
		_on_window(model),
		_on_fire(model),
	]


## The ways in which target and barrel move, translated.
static func kinds() -> PackedStringArray:
	return [
		LabText.translate("target on a line"),
		LabText.translate("target on a circle"),
		LabText.translate("barrel that turns")
	]


## What is asked before the right moment is shown, translated.
static func question_on_moment() -> String:
	return LabText.translate(
		"Where is the target when you must fire? Drag the “?” there, then step forward."
	)


## What is asked before the window is shown, translated.
static func question_on_window() -> String:
	return LabText.translate(
		"The target needs 2 R / |V| to pass a point. How long is the window in which a shot hits?"
	)


## The answers to [method question_on_window], translated.
static func choices() -> PackedStringArray:
	return [
		LabText.translate("shorter than that"),
		LabText.translate("as long as that"),
		LabText.translate("longer than that")
	]


## The right one of [method choices], counted from 0; below 0 where there is nothing to ask.
static func right_choice(model: TimedShotModel) -> int:
	if not model.has_shot() or model.kind != TimedShotModel.Kind.LINE or model.radius == 0.0:
		return -1
	var plain := model.plain_half_window()
	return 2 if model.half_window() - plain > 1e-9 * plain else 1


## Two or three lines for the card on the board, translated.
static func verdict(model: TimedShotModel, step: TimedShotModel.Step) -> PackedStringArray:
	if not model.has_shot():
		return [_reason(model)]
	var words: PackedStringArray = []
	match step:
		TimedShotModel.Step.WINDOW:
			words = [_on_span(model), _on_own_shot(model)]
		TimedShotModel.Step.FIRE:
			words = [ShotText.of_right(model.miss().distance, model.rounding())]
		_:
			var hit := model.shot().fire + model.shot().flight
			words = [
				LabText.translate("fire after %s s") % NumberText.short(model.shot().fire),
				LabText.translate("it hits after %s s") % NumberText.short(hit),
			]
	if is_compared(model, step):
		words.append(_on_mistake(model))
	return words


## The sign that the card carries: whether a moment hits; a cross where a mistake says another one.
static func verdict_sign(model: TimedShotModel, step: TimedShotModel.Step) -> String:
	if is_compared(model, step) and model.mistake_shows():
		return "✗"
	return "!" if model.has_shot() else "0"


## Whether the mistake that is switched on is shown at [param step].
static func is_compared(model: TimedShotModel, step: TimedShotModel.Step) -> bool:
	return model.mistake != 0 and step in _steps_of_mistake(model.mistake)


## The step at which a mistake is compared, for who switches it on at [param step].
static func step_of_mistake(mistake: int, step: int) -> int:
	var steps := _steps_of_mistake(mistake)
	return step if step in steps else steps[0]


# Those that the mistake is about.
static func _steps_of_mistake(mistake: int) -> PackedInt32Array:
	if mistake == TimedShotMistakes.BULLET_FORGOTTEN:
		return [TimedShotModel.Step.WINDOW]
	return [TimedShotModel.Step.WAIT, TimedShotModel.Step.FIRE]


static func _on_span(model: TimedShotModel) -> String:
	var span := model.window()
	return (
		LabText.translate("hits from %s s to %s s")
		% [NumberText.short(span[0]), NumberText.short(span[1])]
	)


static func _on_own_shot(model: TimedShotModel) -> String:
	var apart := model.miss_at(model.own_fire).distance
	if apart <= model.radius:
		return LabText.translate("your shot at %s s hits") % NumberText.short(model.own_fire)
	return (
		LabText.translate("your shot at %s s misses by %s px")
		% [NumberText.short(model.own_fire), NumberText.short(apart, 3)]
	)


static func _reason(model: TimedShotModel) -> String:
	match model.reason():
		TimedShotModel.Reason.RESTS:
			return LabText.translate("the target rests: the moment does not matter")
		TimedShotModel.Reason.PARALLEL:
			return LabText.translate("both ways are parallel: they meet never, or always")
		TimedShotModel.Reason.NO_CROSSING:
			return LabText.translate("the bullet does not cross the way of the target")
		TimedShotModel.Reason.TOO_LATE:
			return LabText.translate("too late: the target has passed before a bullet comes")
		TimedShotModel.Reason.TOO_SLOW:
			return LabText.translate("the bullet must be faster than the target")
		TimedShotModel.Reason.NEVER:
			return LabText.translate("within 60 s the barrel never points ahead as it should")
	return LabText.translate("it takes longer than 60 s")


static func _on_mistake(model: TimedShotModel) -> String:
	if not model.mistake_shows():
		return LabText.translate("the mistake changes nothing here")
	if model.mistake == TimedShotMistakes.BULLET_FORGOTTEN:
		return (
			LabText.translate("the mistake says ± %s s")
			% NumberText.short(model.plain_half_window())
		)
	var apart := model.miss_at(model.wrong_fire()).distance
	return (
		LabText.translate("fired after %s s it misses by %s px")
		% [NumberText.short(model.wrong_fire()), NumberText.short(apart, 3)]
	)


static func _on_watch(model: TimedShotModel) -> String:
	if model.kind == TimedShotModel.Kind.TURNING:
		return LabText.translate(
			"The barrel turns all the time. When do you fire? Drag the ring on the timeline."
		)
	return LabText.translate(
		"The barrel does not follow the target. When do you fire? Drag the ring on the timeline."
	)


static func _on_cross(model: TimedShotModel) -> String:
	if model.kind == TimedShotModel.Kind.TURNING:
		return LabText.translate(
			"Each moment has its own direction that hits. The barrel must have it when it fires."
		)
	if model.flight() > 0.0:
		return LabText.translate("They can only meet in X. The bullet needs f to come there.")
	if model.kind == TimedShotModel.Kind.CIRCLE:
		return LabText.translate("The bullet does not cross the circle.")
	if model.velocity.length() == 0.0:
		return LabText.translate("V = 0: the target rests.")
	if model.shot().outcome == TimedShot.Outcome.PARALLEL:
		return LabText.translate("Both ways are parallel: there is no X, and W · n is 0.")
	return LabText.translate("f is not above 0: both ways cross behind the barrel.")


static func _on_wait(model: TimedShotModel) -> String:
	if not model.has_shot():
		return LabText.translate("No moment hits. The card says why.")
	if model.kind == TimedShotModel.Kind.TURNING:
		return LabText.translate(
			"Fire when the barrel points to where they meet, not when it points to the target."
		)
	return LabText.translate("Fire f before the target is in X: the bullet has to fly there first.")


static func _on_window(model: TimedShotModel) -> String:
	if not model.has_shot():
		return LabText.translate("No moment hits, so there is no window.")
	return LabText.translate(
		"With R, the radii of both together, each moment in the colored window hits."
	)


static func _on_fire(model: TimedShotModel) -> String:
	if not model.has_shot():
		return LabText.translate("No moment hits, and nothing is fired.")
	if model.compares(TimedShotModel.Step.FIRE):
		return LabText.translate("Fire: press Play. What the mistake does is dashed.")
	return LabText.translate("Fire: press Play. It hits; what is left is rounding.")
