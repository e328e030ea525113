class_name BallisticAimTexts
extends RefCounted
## The sentences and the verdict of the lesson on aiming under gravity, step by step.

## What is behind a symbol of the aims that hit, the earliest first.
const SUBSCRIPTS: PackedStringArray = ["₁", "₂", "₃", "₄"]


## One sentence a step, translated.
static func sentences(model: BallisticAimModel) -> PackedStringArray:
	if model.target.length() == 0.0:
		var found: PackedStringArray = []
		found.resize(BallisticAimModel.Step.size())
		found.fill(
			LabText.translate("Shooter and target are in one place: there is nothing to aim at.")
		)
		return found
	return [
		_on_straight(model),
		_on_drop(model),
		_on_times(model),
		_on_arcs(model),
		_on_least(model),
		_on_fire(model),
	]


## What is asked before the times are shown, translated.
static func question_on_count() -> String:
	return LabText.translate("With this speed, in how many directions can you shoot and hit?")


## The answers to [method question_on_count], translated.
static func choices() -> PackedStringArray:
	return [
		LabText.translate("in none"),
		LabText.translate("in one"),
		LabText.translate("in two"),
		LabText.translate("in more than two")
	]


## The right one of [method choices], counted from 0; below 0 where there is nothing to ask.
static func right_choice(model: BallisticAimModel) -> int:
	return mini(model.shots().size(), 3) if model.target.length() > 0.0 else -1


## What is asked before the arcs are shown, translated.
static func question_on_aim() -> String:
	return LabText.translate(
		"To which point do you aim for the first hit? Drag the “?” there, then step forward."
	)


## The names of the aims that hit, translated, for the list from which one is picked.
static func arcs(model: BallisticAimModel) -> PackedStringArray:
	if model.is_fixed():
		return [LabText.translate("flat arc"), LabText.translate("high arc")]
	var found: PackedStringArray = []
	for i in BallisticAimModel.MOST_AIMS:
		found.append(LabText.translate("aim %d") % (i + 1))
	return found


## Two or three lines for the card on the board, translated.
static func verdict(model: BallisticAimModel, step: BallisticAimModel.Step) -> PackedStringArray:
	var words: PackedStringArray = [_count(model)]
	if step == BallisticAimModel.Step.FIRE and model.has_shot():
		words = [ShotText.of_right(model.miss().distance, model.rounding())]
	if model.mistake != 0 and BallisticAimModel.is_of_arcs(step):
		words.append(_on_mistake(model))
	return words


## The sign that the card carries: how many aims hit; a cross where a mistake says something else.
static func verdict_sign(model: BallisticAimModel, step: BallisticAimModel.Step) -> String:
	if model.compares(step):
		return "✗"
	return str(model.shots().size())


static func _count(model: BallisticAimModel) -> String:
	match model.shots().size():
		0:
			return _reason(model)
		1:
			return LabText.translate("one aim hits")
	return LabText.translate("%d aims hit") % model.shots().size()


static func _reason(model: BallisticAimModel) -> String:
	match model.reason():
		BallisticAimModel.Reason.SAME_PLACE:
			return LabText.translate("no direction: both are in one place")
		BallisticAimModel.Reason.TOO_SLOW:
			return (
				LabText.translate("out of reach: s must be at least %s")
				% NumberText.short(model.least_speed())
			)
		BallisticAimModel.Reason.OUTRUN:
			return LabText.translate("the target is faster than the bullet and gets away")
	return LabText.translate("out of reach: no aim hits within 60 s")


static func _on_mistake(model: BallisticAimModel) -> String:
	if not model.mistake_shows():
		return LabText.translate("the mistake changes nothing here")
	if model.mistake == BallisticAimMistakes.NOT_TESTED:
		return LabText.translate("the mistake takes the root of w < 0: NaN, the bullet is lost")
	if not model.wrong_shot().hit:
		return _on_no_aim(model)
	return (
		LabText.translate("the mistake misses by %s px")
		% NumberText.short(model.wrong_shot().miss.distance, 3)
	)


static func _on_no_aim(model: BallisticAimModel) -> String:
	if not model.says_half():
		return LabText.translate("the mistake finds no aim")
	var halved := BallisticAimMistakes.halved_time(model.shot().time)
	var times := [NumberText.short(halved), NumberText.short(model.shot().time)]
	return LabText.translate("the mistake says t = %s, not %s, and finds no aim") % times


static func _on_straight(model: BallisticAimModel) -> String:
	if model.gravity == 0.0:
		return LabText.translate("Without gravity the bullet flies straight on. Press Play.")
	if model.is_upright():
		return LabText.translate("Straight up or down the bullet stays on the line. Press Play.")
	if model.is_fixed():
		return LabText.translate(
			"Aimed straight at the target, the bullet falls and comes too low."
		)
	if model.own_velocity().length() == 0.0:
		return LabText.translate("The target starts to fall as the shot is fired. Press Play.")
	return LabText.translate("The target moves while the bullet flies and falls. Press Play.")


static func _on_drop(model: BallisticAimModel) -> String:
	if model.gravity == 0.0:
		return LabText.translate("g = 0: the bullet does not fall at all.")
	if model.falls:
		return LabText.translate("In t seconds the bullet falls g t² / 2, and so does the target.")
	if not model.is_fixed():
		return LabText.translate(
			"In t seconds the bullet falls g t² / 2, and the target moves by V t."
		)
	return LabText.translate("In t seconds it falls g t² / 2. So aim so far above the target.")


static func _on_times(model: BallisticAimModel) -> String:
	if model.is_fixed():
		return LabText.translate(
			"A higher aim takes longer, and falls more. It hits if |D| = s t: an equation for t²."
		)
	if model.bend().length() == 0.0:
		return LabText.translate(
			"D = P + V t is s t away when it hits: an equation for t, as if g = 0."
		)
	return LabText.translate(
		"D(t) is s t away when it hits: an equation of degree four, with up to four t."
	)


static func _on_arcs(model: BallisticAimModel) -> String:
	match model.shots().size():
		0:
			return LabText.translate("No direction hits. The card says why.")
		1:
			return LabText.translate("One direction hits: d = D / |D|.")
		2:
			if model.is_fixed():
				return (
					LabText
					. translate(
						"Two directions hit, d = D / |D|: the flat arc, and the high arc, which takes longer."
					)
				)
	return (
		LabText.translate("%d directions hit, d = D / |D|. Pick one of them in the list.")
		% (model.shots().size())
	)


static func _on_least(model: BallisticAimModel) -> String:
	if model.gravity == 0.0:
		return LabText.translate("Without gravity there is no edge: a bullet gets everywhere.")
	if not model.is_fixed():
		return LabText.translate(
			"What a bullet with speed s can reach is inside the dashed parabola."
		)
	if not model.has_least():
		return LabText.translate("Straight below, the bullet need only be dropped: s₀ = 0.")
	return LabText.translate(
		"s₀ is the least speed. Its aim halves the angle between P and straight up."
	)


static func _on_fire(model: BallisticAimModel) -> String:
	if not model.has_shot() and not model.mistake_shows():
		return LabText.translate("No aim hits, and nothing is fired.")
	if model.mistake_shows():
		return LabText.translate("Fire: press Play. What the mistake does is dashed.")
	return LabText.translate("Fire: press Play. It hits; what is left is rounding.")
