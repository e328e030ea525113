class_name MyImpact
extends RefCounted
## When a moving ball touches a line within one frame.

## What both methods give back when there is no impact in this frame.
const NO_IMPACT := INF


## Exercise 8: the fraction of the frame, 0 to 1, after which the ball touches the line.
## [param old] and [param new] are its signed distances before and after the frame.
## [constant NO_IMPACT] if the fraction is not within 0 to 1.
static func time_of_impact(old: float, new: float, radius: float) -> float:
	return NO_IMPACT


## Exercise 11: the same for a ball that moves by [param motion] from [param position], with a line
## that ends at [param start] and [param end]. Both sides count, and so do the ends: the ball
## bounces off them. Only what the ball comes nearer to can be hit. [constant NO_IMPACT] if there is
## none.
static func segment_impact(
	position: MyVec2, motion: MyVec2, radius: float, start: MyVec2, end: MyVec2
) -> float:
	var along := end.minus(start)
	var away := position.minus(start)
	var normal := along.normal()
	if away.dot(normal) < 0.0:
		normal = normal.scaled(-1.0)
	var old := away.dot(normal)
	var approach := -motion.dot(normal)
	if approach > 0.0:
		var t := (old - radius) / approach
		var share := away.plus(motion.scaled(t)).dot(along) / along.dot(along)
		if t >= 0.0 and t <= 1.0 and share >= 0.0 and share <= 1.0:
			return t
	return minf(_cap(position, motion, radius, start), _cap(position, motion, radius, end))


static func _cap(position: MyVec2, motion: MyVec2, radius: float, point: MyVec2) -> float:
	var d := position.minus(point)
	var a := motion.dot(motion)
	var b := 2.0 * d.dot(motion)
	var c := d.dot(d) - radius * radius
	var discriminant := b * b - 4.0 * a * c
	if b >= 0.0 or discriminant < 0.0:
		return NO_IMPACT
	var t := (-b - discriminant * discriminant) / (2.0 * a)
	return t if t >= 0.0 and t <= 1.0 else NO_IMPACT
