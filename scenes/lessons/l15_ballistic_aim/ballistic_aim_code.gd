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
	var found: PackedStringArray = []
	if model.is_fixed():
		found.append("var shots := BallisticAim.at_fixed(shooter, target, gravity, speed)")
	else:
		found = [
			"var moving := AimTarget.new(target, velocity, acceleration)",
			"var shots := BallisticAim.at_moving(shooter, moving, gravity, speed, 60.0)",
		]
	found.append("var count := shots.size()")
	if model.has_shot() and step >= BallisticAimModel.Step.ARCS:
		found.append("var t := shots[%d].time" % model.arc_flown())
		found.append("var d := shots[%d].direction" % model.arc_flown())
	return found


## The values of the names in the lines.
static func inputs(model: BallisticAimModel) -> Dictionary[String, Variant]:
	return {
		"BallisticAim": BallisticAim,
		"AimTarget": AimTarget,
		"shooter": Vec2.zero(),
		"target": model.target,
		"velocity": model.own_velocity(),
		"acceleration": model.aim_target().acceleration,
		"gravity": model.pull(),
		"speed": model.speed,
	}
