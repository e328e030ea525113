class_name TriedDirections
extends RefCounted
## Looks for a shot over walls by trying: so many directions all around, each followed from bounce
## to bounce, and the one that comes nearest is the answer.

# How far a ball flies at most until its next bounce, in pixels.
const _FAR := 1e4


## The direction for [param question] among [param count].
static func best(question: BankQuestion, count: int) -> Vec2:
	var least := INF
	var found := Vec2.zero()
	for number in count:
		var direction := Vec2.unit_radians(TAU * number / count)
		var distance := _distance(question, direction)
		if distance < least:
			least = distance
			found = direction
	return found


# How near the ball comes to the target on its way after the last bounce.
static func _distance(question: BankQuestion, direction: Vec2) -> float:
	var place := question.start
	var velocity := direction
	for bounce in question.bounces + 1:
		var motion := velocity.scaled(_FAR)
		var impact := SegmentImpact.with_segments(place, motion, question.radius, question.walls)
		if bounce == question.bounces:
			var end := impact.position if impact.hit else place.plus(motion)
			var nearest := LineSegment.new(place, end).closest_point(question.target)
			return nearest.distance_to(question.target)
		if not impact.hit:
			break
		place = impact.position
		velocity = velocity.reflected(impact.normal, question.bounciness)
	return INF
