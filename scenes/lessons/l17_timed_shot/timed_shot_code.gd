class_name TimedShotCode
extends RefCounted
## The lines of GDScript that compute what each step of the lesson on the moment to fire shows.


## The lines of [param step]; none where nothing is computed, or where the solver refuses.
static func lines(model: TimedShotModel, step: TimedShotModel.Step) -> PackedStringArray:
	if step == TimedShotModel.Step.WATCH:
		return []
	if step == TimedShotModel.Step.CROSS:
		return _crossing_lines(model)
	if model.kind == TimedShotModel.Kind.TURNING and not model.has_shot():
		return []
	var found := _solver_lines(model)
	if model.has_shot():
		found.append("var fire := shot.fire")
		found.append("var flight := shot.flight")
		if step == TimedShotModel.Step.WINDOW and model.kind == TimedShotModel.Kind.LINE:
			found.append("var half := TimedAim.window(bullet, velocity, radius)")
	else:
		found.append("var hits := shot.hit")
	return found


static func _crossing_lines(model: TimedShotModel) -> PackedStringArray:
	if model.kind != TimedShotModel.Kind.LINE or model.flight() <= 0.0:
		return []
	return [
		"var n := Vec2.new(-velocity.y, velocity.x)",
		"var f := target.minus(muzzle).dot(n) / bullet.dot(n)",
		"var x := muzzle.plus(bullet.scaled(f))",
	]


static func _solver_lines(model: TimedShotModel) -> PackedStringArray:
	match model.kind:
		TimedShotModel.Kind.CIRCLE:
			return [
				"var rho := target.distance_to(centre)",
				"var phase := target.minus(centre).angle_radians()",
				"var shot := TimedAim.at_circle(muzzle, bullet, none, centre, rho, phase, turn)",
			]
		TimedShotModel.Kind.TURNING:
			return [
				"var moving := AimTarget.new(target, velocity)",
				"var phi := bullet.angle_radians()",
				"var barrel := TurningBarrel.new(muzzle, phi, turn, bullet.length(), moving)",
				"var shot := barrel.first()",
			]
	return ["var shot := TimedAim.at_line(muzzle, bullet, none, target, velocity)"]


## The values of the names in the lines.
static func inputs(model: TimedShotModel) -> Dictionary[String, Variant]:
	var is_circle := model.kind == TimedShotModel.Kind.CIRCLE
	return {
		"TimedAim": TimedAim,
		"TurningBarrel": TurningBarrel,
		"AimTarget": AimTarget,
		"muzzle": model.muzzle,
		"bullet": model.bullet,
		"target": model.target,
		"velocity": model.velocity,
		"centre": model.centre,
		"none": Vec2.zero(),
		"turn": Vec2.deg_to_rad(model.circling if is_circle else model.turning),
		"radius": model.radius,
	}
