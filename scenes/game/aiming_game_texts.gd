class_name AimingGameTexts
extends RefCounted
## What the game says.

# A miss is told with so many digits.
const _MISS_DIGITS := 2


## The level and the score, translated.
static func score(model: AimingGameModel) -> String:
	var shots: int = model.shots_in.get(model.level_number, 0)
	var sentence := LabText.translate("Level %d of %d · shots: %d")
	return sentence % [model.level_number, model.level_count(), shots]


## What has just happened, or what the helpers cannot do, translated; else "".
static func news(model: AimingGameModel) -> String:
	if model.is_won():
		return _on_hit(model)
	if not is_nan(model.last_miss):
		var miss := NumberText.short(maxf(model.last_miss, 0.01), _MISS_DIGITS)
		return LabText.translate("Missed by %s px.") % miss
	var plan := model.plan()
	if plan and not plan.hit:
		return _on_refusal(plan)
	return ""


## What the large button says, translated.
static func button(model: AimingGameModel) -> String:
	if not model.is_won():
		return LabText.translate("Fire")
	if model.level_number < model.level_count():
		return LabText.translate("Next level")
	return LabText.translate("Play again")


static func _on_hit(model: AimingGameModel) -> String:
	if model.levels_hit.size() == model.level_count():
		var sentence := LabText.translate("All %d levels hit with %d shots!")
		return sentence % [model.level_count(), model.all_shots()]
	if model.shots_in.get(model.level_number, 0) == 1:
		return LabText.translate("Hit with the first shot!")
	return LabText.translate("Hit!")


static func _on_refusal(plan: GameAim) -> String:
	match plan.outcome:
		GameAim.Outcome.OUTRUN:
			return LabText.translate("The target is faster than the bullet and gets away.")
		GameAim.Outcome.NO_WAY:
			return LabText.translate("The helper finds no way with one or two bounces.")
	return LabText.translate("The helper finds no arc: out of reach.")
