class_name TurningSegment
extends RefCounted
## A segment that turns about a pivot, such as a paddle. The pivot may be anywhere and may move with
## a constant velocity. With the turn 0 the segment moves along without turning.

## The segment at the time 0.
var segment: LineSegment
## The place of the pivot at the time 0, in pixels.
var pivot: Vec2
## How fast the segment turns, in radians per second, clockwise on screen.
var turn: float
## The velocity of the pivot, in pixels per second.
var velocity: Vec2


## A segment that turns. What is given is copied, so that nothing is shared.
func _init(
	segment_now: LineSegment, about: Vec2, with_turn: float, pivot_velocity := Vec2.zero()
) -> void:
	segment = segment_now.copy()
	pivot = about.copy()
	turn = with_turn
	velocity = pivot_velocity.copy()


## Where the pivot is after so many seconds, in pixels.
func pivot_at(seconds: float) -> Vec2:
	return pivot.plus(velocity.scaled(seconds))


## Where the segment is after so many seconds.
func segment_at(seconds: float) -> LineSegment:
	var moved := segment.copy()
	for end: Vec2 in [moved.start, moved.end]:
		end.rotate_around_radians(pivot, turn * seconds)
		end.add(velocity.scaled(seconds))
	return moved


## How fast a point of the segment moves, in pixels per second. [param arm] is the vector from the
## pivot to it: the turn moves it across the arm, by turn times its length.
func velocity_at(arm: Vec2) -> Vec2:
	return velocity.plus(Vec2.new(-arm.y, arm.x).scaled(turn))


## How far the end that is farther away is from the pivot, in pixels.
func reach() -> float:
	return maxf(segment.start.distance_to(pivot), segment.end.distance_to(pivot))


## "" if this segment can be used; otherwise one sentence with the value and what is allowed. All
## its numbers must be within -[param largest]..[param largest].
func problem(largest: float) -> String:
	var limit := String.num_scientific(largest)
	if not (pivot.is_within(largest) and velocity.is_within(largest)):
		var values := [limit, limit, pivot, velocity]
		return "A pivot's position and velocity must be within -%s..%s, not %s and %s." % values
	if not absf(turn) <= largest:
		return "A segment must turn by -%s..%s rad/s, not by %s." % [limit, limit, turn]
	return segment.problem(largest)
