class_name CapImpact
extends RefCounted
## Part 18 of the lecture: a line ends, and the ball bounces on the end. The ball's centre moves by
## `motion` in this frame; it touches where its distance from the end is the radius:
## |d + t m| = r, which is a t^2 + b t + c = 0 with a = m.m, b = 2 d.m, c = d.d - r^2.


## The impact of a ball that moves by [param motion] from [param old_position] with the point
## [param cap], the first of the two solutions. A ball that already overlaps and still approaches
## touches at time 0. The normal points from the cap to the ball.
static func with_point(
	old_position: Vec2, motion: Vec2, radius: float, cap: Vec2, feature: Impact.Feature
) -> Impact:
	var difference := old_position.minus(cap)
	var a := motion.dot(motion)
	var b := 2.0 * difference.dot(motion)
	var c := difference.dot(difference) - radius * radius
	if b >= 0.0:
		return Impact.miss(Impact.Outcome.MOVING_AWAY)
	if c <= 0.0:
		return Impact.at(0.0, old_position.copy(), difference.normalized(), feature)
	var discriminant := b * b - 4.0 * a * c
	# Below 0 the ball stays farther away than its radius; at 0 it only grazes the point.
	if discriminant <= 0.0:
		return Impact.miss(Impact.Outcome.PASSES_BESIDE)
	var time := (-b - sqrt(discriminant)) / (2.0 * a)
	if time > 1.0:
		return Impact.miss(Impact.Outcome.TOO_FAR)
	var position := old_position.plus(motion.scaled(time))
	return Impact.at(time, position, position.minus(cap).normalized(), feature)
