class_name WorldLimits
extends RefCounted
## What an [EventWorld] takes, and the sentence with which it refuses everything else. Each method
## returns "" or one sentence with the value and what is allowed.

## Coordinates, speeds, sizes, masses, times and gravity stay within this, in pixels, seconds and
## their quotients.
const LARGEST := 1e15


## Whether both components are numbers within -[constant LARGEST]..[constant LARGEST].
static func is_within(vector: Vec2) -> bool:
	return absf(vector.x) <= LARGEST and absf(vector.y) <= LARGEST


## Gravity in px/s².
static func problem_of_gravity(gravity: Vec2) -> String:
	if is_within(gravity):
		return ""
	return "Gravity must be within -1e15..1e15 px/s² in x and y, not %s." % gravity


## The coefficient of restitution C.
static func problem_of_bounciness(bounciness: float) -> String:
	if bounciness >= 0.0 and bounciness <= 1.0:
		return ""
	return "The bounciness C must be within 0..1, not %s." % bounciness


## A line between two ends, in pixels.
static func problem_of_segment(segment: LineSegment) -> String:
	if segment.problem():
		return segment.problem()
	if is_within(segment.start) and is_within(segment.end):
		return ""
	var values := [segment.start, segment.end]
	return "A segment's ends must be within -1e15..1e15 px, not %s and %s." % values


## A ball: pixels, seconds and their quotients.
static func problem_of_ball(ball: Ball) -> String:
	if ball.problem():
		return ball.problem()
	if not (is_within(ball.position) and is_within(ball.velocity)):
		var vectors := [ball.position, ball.velocity]
		return "A ball's position and velocity must be within -1e15..1e15, not %s and %s." % vectors
	if ball.radius <= LARGEST and ball.mass <= LARGEST:
		return ""
	var sizes := [ball.radius, ball.mass]
	return "A ball's radius and mass must be at most 1e15, not %s and %s." % sizes


## An upright box, by its corners at the upper left and the lower right, in pixels.
static func problem_of_walls(low: Vec2, high: Vec2) -> String:
	if is_within(low) and is_within(high) and low.x < high.x and low.y < high.y:
		return ""
	return (
		"The walls need a corner above and left of the other, within -1e15..1e15 px, not %s and %s."
		% [low, high]
	)


## A place where there must be something, named by [param what].
static func problem_of_place(place: int, is_taken: bool, what: String) -> String:
	return "" if is_taken else "There is no %s at the place %d." % [what, place]
