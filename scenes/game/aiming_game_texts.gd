class_name AimingGameTexts
extends RefCounted
## What the game says.

# A miss is told with so many digits.
const _MISS_DIGITS := 2
# For so many seconds; then the helpers have the word.
const _MISS_SECONDS := 2.5


## The level and the score, translated.
static func score(model: AimingGameModel) -> String:
	var shots: int = model.shots_in.get(model.level_number, 0)
	var sentence := LabText.translate("Level %d of %d · shots: %d")
	return sentence % [model.level_number, model.level_count(), shots]


## What has just happened, or what the helpers cannot do, translated; else "".
static func news(model: AimingGameModel) -> String:
	if model.is_won():
		return _on_hit(model)
	var plan := model.plan()
	if model.missed and (not plan or model.seconds_since_miss() < _MISS_SECONDS):
		var apart := model.missed.nearest - GameLevel.reach()
		var miss := NumberText.short(maxf(apart, 0.01), _MISS_DIGITS)
		return LabText.translate("Missed by %s px.") % miss
	if not plan or model.shot:
		return ""
	return _on_flaw(plan) if plan.hit else _on_refusal(plan)


## What the large button says, translated.
static func button(model: AimingGameModel) -> String:
	if not model.is_won():
		return LabText.translate("Fire")
	return (
		LabText.translate("Play again") if model.is_complete() else LabText.translate("Next level")
	)


static func _on_hit(model: AimingGameModel) -> String:
	if model.is_complete():
		var sentence := LabText.translate("All %d levels hit with %d shots! Now without Aim?")
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


static func _on_flaw(plan: GameAim) -> String:
	match plan.flaw:
		GameAim.Flaw.FALLS:
			return LabText.translate("The bullet falls on its way.")
		GameAim.Flaw.MOVES_ON:
			return LabText.translate("The target moves on while the bullet flies.")
		GameAim.Flaw.TURNS:
			return LabText.translate("Wait: the target turns round before.")
		GameAim.Flaw.BLOCKED:
			return LabText.translate("A wall is in the way.")
	return ""
