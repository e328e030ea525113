class_name TimedShotRounding
extends RefCounted
## How far rounding alone may move the right shot of the lesson on the moment to fire.


## eps times the condition of the right shot of [param model], in pixels, over all its numbers:
## places, velocities, turns, the moment and the flight.
static func of(model: TimedShotModel) -> float:
	var shot := model.shot()
	var start := model.muzzle
	var bullet := model.bullet
	var target := model.target
	var velocity := model.velocity
	var numbers: PackedFloat64Array = [start.x, start.y, shot.fire, shot.flight]
	var off := _off_line
	match model.kind:
		TimedShotModel.Kind.LINE:
			numbers.append_array([target.x, target.y, velocity.x, velocity.y, bullet.x, bullet.y])
		TimedShotModel.Kind.CIRCLE:
			numbers.append_array([model.centre.x, model.centre.y, model.circle_radius()])
			numbers.append_array([model.phase(), Vec2.deg_to_rad(model.circling)])
			numbers.append_array([bullet.x, bullet.y])
			off = _off_circle
		TimedShotModel.Kind.TURNING:
			numbers.append_array([target.x, target.y, velocity.x, velocity.y, bullet.length()])
			numbers.append_array([bullet.angle_radians(), Vec2.deg_to_rad(model.turning)])
			off = _off_turning
	return ShotCondition.EPSILON * ShotCondition.of(numbers, off)


# By how much the shot misses with these numbers, which begin with muzzle, fire and flight.
static func _off_line(n: PackedFloat64Array) -> Vec2:
	var hit := n[2] + n[3]
	return Vec2.new(n[0] + n[8] * n[3] - n[4] - n[6] * hit, n[1] + n[9] * n[3] - n[5] - n[7] * hit)


static func _off_circle(n: PackedFloat64Array) -> Vec2:
	var angle := n[7] + n[8] * (n[2] + n[3])
	return Vec2.new(
		n[0] + n[9] * n[3] - n[4] - n[6] * cos(angle),
		n[1] + n[10] * n[3] - n[5] - n[6] * sin(angle)
	)


static func _off_turning(n: PackedFloat64Array) -> Vec2:
	var hit := n[2] + n[3]
	var angle := n[9] + n[10] * n[2]
	return Vec2.new(
		n[0] + n[8] * cos(angle) * n[3] - n[4] - n[6] * hit,
		n[1] + n[8] * sin(angle) * n[3] - n[5] - n[7] * hit
	)
