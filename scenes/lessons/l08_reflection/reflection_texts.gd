class_name ReflectionTexts
extends RefCounted
## The sentences and the verdict of the lesson on reflection, step by step.


## One sentence a step, translated.
static func sentences(model: ReflectionModel) -> PackedStringArray:
	if model.refusal():
		var refusals: PackedStringArray = []
		refusals.resize(ReflectionModel.Step.size())
		refusals.fill(
			LabText.translate("n is not of length 1: reflect refuses it, and v stays as it was.")
		)
		return refusals
	return [
		LabText.translate("A ball with velocity v meets a line with the unit normal n."),
		LabText.translate("Along n, v has the part (v · n) n: the shadow of v on n."),
		LabText.translate("Subtract it once: nothing goes into the line. The ball slides."),
		LabText.translate("Subtract it twice: the law of reflection. Both angles are equal."),
		LabText.translate("Subtract it (1 + C) times: C says how much of it comes back."),
	]


## Two lines for the card on the board: the angles to the normal, and what is left of the energy.
static func verdict(model: ReflectionModel, step: ReflectionModel.Step) -> PackedStringArray:
	var leaving := model.velocity_after(model.times_subtracted(step))
	if step < ReflectionModel.Step.SLIDE:
		var angle := NumberText.short(model.angle_in_degrees())
		return [
			LabText.translate("comes in at %s° to the normal") % angle,
			LabText.translate("nothing subtracted: it flies through"),
		]
	var energy := LabText.translate("keeps %s %% of its energy")
	return [
		_angles(model, leaving),
		energy % NumberText.short(model.energy_share(leaving) * 100.0, 3),
	]


## The sign that the card carries: whether the angles are equal.
static func verdict_sign(model: ReflectionModel, step: ReflectionModel.Step) -> String:
	if step < ReflectionModel.Step.SLIDE:
		return "→"
	return "=" if model.has_equal_angles(model.times_subtracted(step)) else "≠"


static func _angles(model: ReflectionModel, leaving: Vec2) -> String:
	var angle_in := NumberText.short(model.angle_in_degrees())
	if leaving.length() == 0.0:
		return LabText.translate("in %s° to the normal, and it stops") % angle_in
	var angle_out := NumberText.short(model.angle_out_degrees(leaving))
	return LabText.translate("in %s°, out %s° to the normal") % [angle_in, angle_out]
