class_name WorldLimits
extends RefCounted
## How large the numbers of an [EventWorld] may be, and the sentences that refuse walls and places.
## [Ball], [LineSegment], [FreeFlight] and [Bounce] refuse the rest. Each method returns "" or one
## sentence with the value and what is allowed.

## Coordinates, speeds, sizes, masses, times and gravity stay within this, in pixels, seconds and
## their quotients.
const LARGEST := 1e15
## The largest friction µ.
const MOST_FRICTION := 1e6


## An upright box, by its corners at the upper left and the lower right, in pixels.
static func problem_of_walls(low: Vec2, high: Vec2) -> String:
	var is_near := low.is_within(LARGEST) and high.is_within(LARGEST)
	if is_near and low.x < high.x and low.y < high.y:
		return ""
	var limit := String.num_scientific(LARGEST)
	return (
		"The walls need a corner above and left of the other, within -%s..%s px, not %s and %s."
		% [limit, limit, low, high]
	)


## The speed of a belt, in px/s.
static func problem_of_speed(speed: float) -> String:
	if absf(speed) <= LARGEST:
		return ""
	var limit := String.num_scientific(LARGEST)
	return "A belt must run with -%s..%s px/s, not with %s." % [limit, limit, speed]


## A moment to which a world cannot advance that stands at [param time], in seconds.
static func problem_of_target(time: float, target: float) -> String:
	var values := [time, target]
	return "The world stands at %s s and can advance to at most 1e15 s, not to %s." % values


## More than [param most] impacts in the second before [param time].
static func problem_of_count(most: int, time: float) -> String:
	var values := [most, time]
	return "There are more than %d impacts within a second at %s s: the world stops there." % values


## A place where there must be something, named by [param what].
static func problem_of_place(place: int, is_taken: bool, what: String) -> String:
	return "" if is_taken else "There is no %s at the place %d." % [what, place]
