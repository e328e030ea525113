class_name TimedShotCode
extends RefCounted
## The lines of GDScript that compute what each step of the lesson on the moment to fire shows.

const _LINE := "TimedAim.at_line(muzzle, bullet, none, target, velocity)"
const _CIRCLE := "TimedAim.at_circle(muzzle, bullet, none, centre, rho, phase, turn)"
const _TURNING := "barrel.first()"


## The lines of [param step]; none where nothing is computed, or where the solver refuses.
static func lines(model: TimedShotModel, step: TimedShotModel.Step) -> PackedStringArray:
	if step == TimedShotModel.Step.WATCH:
		return []
	if step == TimedShotModel.Step.CROSS:
		return _crossing_lines(model)
	if model.kind == TimedShotModel.Kind.TURNING and not model.has_shot():
		return []
	var found: PackedStringArray = []
	if model.kind == TimedShotModel.Kind.CIRCLE:
		found = [
			"var rho := target.distance_to(centre)",
			"var phase := target.minus(centre).angle_radians()",
		]
	var shot: String = [_LINE, _CIRCLE, _TURNING][model.kind]
	if not model.has_shot():
		found.append("var hits := %s.hit" % shot)
		return found
	found.append("var fire := %s.fire" % shot)
	found.append("var flight := %s.flight" % shot)
	if step == TimedShotModel.Step.WINDOW and model.kind == TimedShotModel.Kind.LINE:
		found.append("var half := TimedAim.window(bullet, velocity, radius)")
	return found


static func _crossing_lines(model: TimedShotModel) -> PackedStringArray:
	if model.kind != TimedShotModel.Kind.LINE or model.flight() <= 0.0:
		return []
	return [
		"var n := Vec2.new(-velocity.y, velocity.x)",
		"var f := target.minus(muzzle).dot(n) / bullet.dot(n)",
		"var x := muzzle.plus(bullet.scaled(f))",
	]


## The values of the names in the lines.
static func inputs(model: TimedShotModel) -> Dictionary[String, Variant]:
	return {
		"TimedAim": TimedAim,
		"barrel": model.barrel(),
		"muzzle": model.muzzle,
		"bullet": model.bullet,
		"target": model.target,
		"velocity": model.velocity,
		"centre": model.centre,
		"none": Vec2.zero(),
		"turn": Vec2.deg_to_rad(model.circling),
		"radius": model.radius,
	}
