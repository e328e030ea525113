class_name BallisticAimCode
extends RefCounted
## The lines of GDScript that compute what each step of the lesson on aiming under gravity shows.


## The lines of [param step]; none where there is nothing to aim at.
static func lines(model: BallisticAimModel, step: BallisticAimModel.Step) -> PackedStringArray:
	if model.target.length() == 0.0:
		return []
	match step:
		BallisticAimModel.Step.STRAIGHT:
			return ["var t := target.length() / speed"]
		BallisticAimModel.Step.DROP:
			return ["var t := target.length() / speed", "var fall := gravity.scaled(0.5 * t * t)"]
		BallisticAimModel.Step.LEAST:
			if model.is_fixed():
				return ["var least := BallisticAim.least_speed(shooter, target, gravity)"]
	return _aim_lines(model, step)


static func _aim_lines(model: BallisticAimModel, step: BallisticAimModel.Step) -> PackedStringArray:
	var shots := "BallisticAim.at_fixed(shooter, target, gravity, speed)"
	if not model.is_fixed():
		shots = "BallisticAim.at_moving(shooter, moving, gravity, speed, 60.0)"
	if not model.has_shot() or step < BallisticAimModel.Step.ARCS:
		return ["var count := %s.size()" % shots]
	var aim := "%s[%d]" % [shots, model.arc_flown()]
	return ["var t := %s.time" % aim, "var d := %s.direction" % aim]


## The values of the names in the lines.
static func inputs(model: BallisticAimModel) -> Dictionary[String, Variant]:
	return {
		"BallisticAim": BallisticAim,
		"shooter": Vec2.zero(),
		"target": model.target,
		"moving": model.aim_target(),
		"gravity": model.pull(),
		"speed": model.speed,
	}
