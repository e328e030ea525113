class_name WorldLimits
extends RefCounted
## What a world takes, and the sentence with which it refuses everything else. Each method returns
## "" or one sentence with the value and what is allowed.
##
## The parameter `largest` is the world's own limit for coordinates, speeds, sizes, masses and
## gravity, a power of ten.


## Whether both components are numbers within -[param largest]..[param largest].
static func is_within(vector: Vec2, largest: float) -> bool:
	return absf(vector.x) <= largest and absf(vector.y) <= largest


## Gravity in px/s².
static func problem_of_gravity(gravity: Vec2, largest: float) -> String:
	if is_within(gravity, largest):
		return ""
	return "Gravity must be within %s px/s² in x and y, not %s." % [_range_of(largest), gravity]


## The coefficient of restitution C.
static func problem_of_bounciness(bounciness: float) -> String:
	if bounciness >= 0.0 and bounciness <= 1.0:
		return ""
	return "The bounciness C must be within 0..1, not %s." % bounciness


## A line between two ends, in pixels.
static func problem_of_segment(segment: LineSegment, largest: float) -> String:
	if segment.problem():
		return segment.problem()
	if is_within(segment.start, largest) and is_within(segment.end, largest):
		return ""
	var values := [_range_of(largest), segment.start, segment.end]
	return "A segment's ends must be within %s px, not %s and %s." % values


## A ball: pixels, seconds and their quotients.
static func problem_of_ball(ball: Ball, largest: float) -> String:
	if ball.problem():
		return ball.problem()
	if not (is_within(ball.position, largest) and is_within(ball.velocity, largest)):
		var values := [_range_of(largest), ball.position, ball.velocity]
		return "A ball's position and velocity must be within %s, not %s and %s." % values
	return problem_of_sizes(ball, largest)


## The radius in pixels and the mass of a ball.
static func problem_of_sizes(ball: Ball, largest: float) -> String:
	if ball.radius <= largest and ball.mass <= largest:
		return ""
	var values := [_name_of(largest), ball.radius, ball.mass]
	return "A ball's radius and mass must be at most %s, not %s and %s." % values


## An upright box, by its corners at the upper left and the lower right, in pixels.
static func problem_of_walls(low: Vec2, high: Vec2, largest: float) -> String:
	if is_within(low, largest) and is_within(high, largest) and low.x < high.x and low.y < high.y:
		return ""
	return (
		"The walls need a corner above and left of the other, within %s px, not %s and %s."
		% [_range_of(largest), low, high]
	)


## A place where there must be something, named by [param what].
static func problem_of_place(place: int, is_taken: bool, what: String) -> String:
	return "" if is_taken else "There is no %s at the place %d." % [what, place]


static func _range_of(largest: float) -> String:
	return "-%s..%s" % [_name_of(largest), _name_of(largest)]


static func _name_of(largest: float) -> String:
	return "1e%d" % roundi(log(largest) / log(10.0))
