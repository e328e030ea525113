class_name PointOfImpact
extends RefCounted
## Part 13 of the lecture: how much of a frame has passed when a ball touches an infinite line.
##
## With the old and the new distance from the line, a = old - r is the way to the contact and
## b = old - new the way of the whole frame: t = a / b.


## The share t = a / b of the frame at which the distance is [param radius]; it is a time of impact
## only if it is in 0..1. b must not be 0: then the ball moves along the line.
static func share(old_distance: float, new_distance: float, radius: float) -> float:
	return (old_distance - radius) / (old_distance - new_distance)


## The impact of a ball that moves by [param motion] from [param old_position] in this frame with
## the good side of the infinite line. A ball that already overlaps and still approaches touches at
## time 0.
static func with_line(old_position: Vec2, motion: Vec2, radius: float, line: LineSegment) -> Impact:
	var normal := line.normal()
	var old_distance := LineDistance.signed_distance(old_position, line)
	var approach := -motion.dot(normal)
	if approach == 0.0:
		return Impact.miss(Impact.Outcome.PARALLEL)
	if approach < 0.0:
		return Impact.miss(Impact.Outcome.MOVING_AWAY)
	# a / b as in the slide; b is known before it is lost in the difference of two large distances.
	var time := maxf((old_distance - radius) / approach, 0.0)
	if time > 1.0:
		return Impact.miss(Impact.Outcome.TOO_FAR)
	var position := old_position.plus(motion.scaled(time))
	return Impact.at(time, position, normal, Impact.Feature.LINE)
