class_name AimAtCode
extends RefCounted
## The lines of GDScript that compute what each step of the lesson on aiming at a target shows.


## The lines of [param step]; none where there is no direction.
static func lines(model: AimAtModel, step: int) -> PackedStringArray:
	match step:
		AimAtModel.Step.CURRENT:
			return [
				"var d := Vec2.unit_degrees(hull_degrees + barrel_degrees)",
				"var nozzle := hull.plus(d.scaled(length))",
			]
		AimAtModel.Step.SPRITE:
			return [
				"var d := Vec2.unit_degrees(hull_degrees + barrel_degrees)",
				"var v := d.scaled(speed).plus(gravity.scaled(t))",
				"var rotation := v.angle_degrees()",
			]
	if model.shot_case() == AimAtModel.Case.NO_DIRECTION:
		return []
	match step:
		AimAtModel.Step.LOOK:
			return ["var theta := rad_to_deg(Turn.toward(hull, target))"]
		AimAtModel.Step.NESTED:
			return ["var own := rad_to_deg(Turn.on_mount(theta, deg_to_rad(hull_degrees)))"]
		AimAtModel.Step.TURN:
			return ["var turn := rad_to_deg(Turn.shortest(gamma, theta))"]
		AimAtModel.Step.EARLY:
			return ["var now := rad_to_deg(Turn.eased(gamma, theta, half_life, fire))"]
	return ["var d := target.minus(hull).normalized()", "var nozzle := hull.plus(d.scaled(length))"]


## The values of the names in the lines.
static func inputs(model: AimAtModel) -> Dictionary[String, Variant]:
	return {
		"Turn": Turn,
		"hull": model.hull,
		"target": model.target,
		"hull_degrees": model.hull_degrees,
		"barrel_degrees": model.barrel_degrees,
		"length": model.length,
		"speed": model.speed,
		"gravity": Vec2.new(0.0, AimAtModel.GRAVITY),
		"t": AimAtModel.POSES[1],
		"theta": Turn.toward(model.hull, model.target),
		"gamma": Vec2.deg_to_rad(model.current_degrees()),
		"half_life": model.half_life,
		"fire": model.fire,
	}
