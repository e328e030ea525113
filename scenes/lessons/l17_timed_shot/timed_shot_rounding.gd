class_name TimedShotRounding
extends RefCounted
## How far rounding alone may move the right shot of the lesson on the moment to fire.


## For a target on a line, in pixels: eps times the condition over the [param numbers], which are
## the muzzle, the moment, the flight, the target, its velocity and the bullet's.
static func on_line(numbers: PackedFloat64Array) -> float:
	return ShotCondition.EPSILON * ShotCondition.of(numbers, _off_line)


## The same for a target on a circle: behind the flight come the centre, the radius, the angle, the
## turn and the bullet's velocity.
static func on_circle(numbers: PackedFloat64Array) -> float:
	return ShotCondition.EPSILON * ShotCondition.of(numbers, _off_circle)


## The same for a turning barrel: behind the flight come the target, its velocity, the bullet's
## speed, the barrel's angle and its turn.
static func of_turning(numbers: PackedFloat64Array) -> float:
	return ShotCondition.EPSILON * ShotCondition.of(numbers, _off_turning)


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
