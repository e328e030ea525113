class_name FramewiseTiming
extends RefCounted
## Looks frame by frame whether it is time to fire: the first frame counts in which something has
## passed the barrel since the frame before.

# Seconds.
const _LONGEST := 60.0
# Radians. What is farther away has gone round the other way.
const _NEAR := 1.0


## Fires when the direction to aim at passes the barrel; for a target on a circle, when the target
## passes where it should be for the bullet to meet it.
static func ahead(question: TimedQuestion, rate: int) -> TimedShot:
	if question.circle_radius:
		return _first(_behind_on_circle.bind(question), rate)
	return _first(_lead_from_barrel.bind(question), rate)


## Fires when the target itself passes before the barrel: as if the bullet took no time.
static func in_front(question: TimedQuestion, rate: int) -> TimedShot:
	return _first(_target_from_barrel.bind(question), rate)


static func _first(angle_at: Callable, rate: int) -> TimedShot:
	var before: float = angle_at.call(0.0)
	for frame in range(1, roundi(_LONGEST * rate) + 1):
		var angle: float = angle_at.call(float(frame) / rate)
		if (before < 0.0) != (angle < 0.0) and absf(angle) < _NEAR and absf(before) < _NEAR:
			return TimedShot.at(float(frame) / rate, 0.0)
		before = angle
	return TimedShot.miss(TimedShot.Outcome.NOT_IN_TIME)


static func _lead_from_barrel(time: float, question: TimedQuestion) -> float:
	var place := question.target.position_after(time)
	var target := AimTarget.new(place, question.target.velocity)
	var aim := LeadAim.first(question.muzzle, target, question.speed)
	return _from_barrel(time, aim.direction, question) if aim.hit else PI


static func _target_from_barrel(time: float, question: TimedQuestion) -> float:
	var place := question.target.position_after(time)
	if question.circle_radius:
		var angle := question.phase + question.circle_turn * time
		place.add(Vec2.unit_radians(angle).scaled(question.circle_radius))
	return _from_barrel(time, place.minus(question.muzzle), question)


static func _from_barrel(time: float, direction: Vec2, question: TimedQuestion) -> float:
	return Turn.shortest(question.angle + question.turn * time, direction.angle_radians())


# By how much the target, when the bullet comes to the circle, is before or behind the bullet: at
# the crossing where it is nearer.
static func _behind_on_circle(time: float, question: TimedQuestion) -> float:
	var from := question.muzzle.minus(question.target.position)
	var outside := from.length_squared() - question.circle_radius ** 2
	var best := PI
	for flight in Quadratic.roots(
		question.bullet.length_squared(), 2.0 * from.dot(question.bullet), outside
	):
		if flight > 0.0:
			var there := from.plus(question.bullet.scaled(flight)).angle_radians()
			var angle := question.phase + question.circle_turn * (time + flight)
			var ahead_by := Turn.shortest(there, angle)
			best = ahead_by if absf(ahead_by) < absf(best) else best
	return best
