class_name CapImpact
extends RefCounted
## Part 18 of the lecture: a line has ends, and the ball bounces off an end. The ball's centre moves
## by the motion m in this frame. It touches the end where its distance from the end is the radius:
## |d + t m| = r, which is a t^2 + b t + c = 0 with a = m.m, b = 2 d.m, c = d.d - r^2.


## The impact of a ball that moves by [param motion] from [param old_position], in pixels, with the
## point [param cap]: the smaller of the two solutions t. A ball that overlaps the point already and
## approaches it touches at the fraction 0. The normal points from the cap to the ball.
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
	# Below 0 the ball stays farther away than its radius. At 0 it only grazes the point.
	if discriminant <= 0.0:
		return Impact.miss(Impact.Outcome.PASSES_BESIDE)
	var fraction := (-b - sqrt(discriminant)) / (2.0 * a)
	if fraction > 1.0:
		return Impact.miss(Impact.Outcome.TOO_FAR)
	var position := old_position.plus(motion.scaled(fraction))
	return Impact.at(fraction, position, position.minus(cap).normalized(), feature)
