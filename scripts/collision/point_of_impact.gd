class_name PointOfImpact
extends RefCounted
## Part 13 of the lecture: the fraction of a frame after which a ball touches an infinite line.
##
## Take the distance from the line before and after the frame. Then a = old - r is the way to the
## contact, b = old - new is the way of the whole frame, and t = a / b.


## The fraction t = a / b of the frame after which the distance is [param radius]. There is an
## impact in this frame only if t is in 0..1. Both distances must differ: if they are equal, the
## ball moves along the line, and the result is infinite or NaN.
static func fraction(old_distance: float, new_distance: float, radius: float) -> float:
	return (old_distance - radius) / (old_distance - new_distance)


## The impact of a ball that moves by [param motion] from [param old_position], in pixels, with the
## good side of the infinite line, to which its normal points. A ball that overlaps the line already
## and approaches it touches at the fraction 0.
static func with_line(old_position: Vec2, motion: Vec2, radius: float, line: LineSegment) -> Impact:
	var normal := line.normal()
	var old_distance := LineDistance.signed_distance(old_position, line)
	var approach := -motion.dot(normal)
	if approach == 0.0:
		return Impact.miss(Impact.Outcome.PARALLEL)
	if approach < 0.0:
		return Impact.miss(Impact.Outcome.MOVING_AWAY)
	# a / b as on the slide. Here b comes from the motion: old - new would lose its digits where
	# both distances are large.
	var fraction_of_frame := maxf((old_distance - radius) / approach, 0.0)
	if fraction_of_frame > 1.0:
		return Impact.miss(Impact.Outcome.TOO_FAR)
	var position := old_position.plus(motion.scaled(fraction_of_frame))
	return Impact.at(fraction_of_frame, position, normal, Impact.Feature.LINE)
