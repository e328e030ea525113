class_name LeadTargetCode
extends RefCounted
## The lines of GDScript that compute what each step of the lesson on leading a target shows.


## The lines of [param step]; none where there is nothing to compute.
static func lines(model: LeadTargetModel, step: int) -> PackedStringArray:
	match step:
		LeadTargetModel.Step.NOW:
			return ["var d := target.minus(shooter).normalized()"]
		LeadTargetModel.Step.RELATIVE:
			return ["var p := target.minus(shooter)", "var v := velocity.minus(own)"]
		LeadTargetModel.Step.REACH:
			return ["var reach_after_1_s := radius + speed * 1.0"]
	if not model.can_hit() or model.equation().touches_at_once():
		return []
	match step:
		LeadTargetModel.Step.TIME:
			return _lines_on_time(model.equation())
		LeadTargetModel.Step.AIM:
			return [
				"var d := p.plus(v.scaled(t)).normalized()",
				"var bullet := own.plus(d.scaled(speed))",
			]
	return [
		"var place := shooter.plus(bullet.scaled(t))",
		"var there := target.plus(velocity.scaled(t))",
	]


static func _lines_on_time(equation: LeadEquation) -> PackedStringArray:
	return [
		"var a := v.length_squared() - speed * speed",
		"var b := p.dot(v) - speed * radius",
		"var c := p.length_squared() - radius * radius",
		"var root := sqrt(maxf(b * b - a * c, 0.0))",
		"var t := -(b + root) / a" if equation.b > 0.0 else "var t := c / (root - b)",
	]


## The values of the names in the lines.
static func inputs(model: LeadTargetModel) -> Dictionary[String, Variant]:
	var aim := model.aim()
	var found: Dictionary[String, Variant] = {
		"shooter": model.shooter,
		"target": model.target,
		"velocity": model.velocity,
		"own": model.own,
		"speed": model.speed,
		"radius": model.radius,
		"p": model.way(),
		"v": model.relative_velocity(),
	}
	if aim.hit:
		found["t"] = aim.time
		found["bullet"] = model.own.plus(aim.direction.scaled(model.speed))
	return found
