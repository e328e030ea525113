class_name MovingPlatformsCheck
extends RefCounted
## What can be wrong with a state of the lesson on surfaces that move.

## No place or speed is larger than this, in pixels and seconds.
const LARGEST := 1e4
## No surface is shorter than this, in pixels, and no belt leads less far to the right.
const SHORTEST := 40.0
## Nothing turns faster than this, in radians per second.
const FASTEST_TURN := 20.0
## The largest friction µ.
const MOST_FRICTION := 10.0
## What has to move moves at least so fast, in px/s; and no way is shorter, in pixels.
const SMALLEST := 1.0

# How sentences on what is wrong call a number.
const _SYMBOLS: Dictionary[String, String] = {
	"bounciness": "C",
	"friction": "µ",
	"turning": "ω",
	"speed": "v",
	"surface_speed": "V",
	"way": "h"
}


## "" if the lesson can show [param stored]; else one sentence with the value and what is allowed.
static func problem_in(stored: Dictionary) -> String:
	var kind: int = stored["kind"]
	var mistake: int = stored["mistake"]
	var problems: PackedStringArray = [
		StateCheck.within("kind", kind, 0, MovingSurface.Kind.size() - 1),
		StateCheck.mistake(mistake, MovingPlatformsMistakes.infos()),
	]
	for key: String in ["ball", "velocity", "surface", "surface_velocity"]:
		var list: PackedFloat64Array = stored[key]
		for number in list:
			problems.append(StateCheck.within(key, number, -LARGEST, LARGEST))
	var limits: Dictionary[String, PackedFloat64Array] = {
		"bounciness": [0.0, 1.0],
		"friction": [0.0, MOST_FRICTION],
		"turning": [-FASTEST_TURN, FASTEST_TURN],
		"speed": [-LARGEST, LARGEST],
		"surface_speed": [-LARGEST, LARGEST],
		"way": [SMALLEST, LARGEST],
	}
	if kind in [MovingSurface.Kind.PLATFORM, MovingSurface.Kind.PRESS]:
		limits["surface_speed"][0] = SMALLEST
	for key in limits:
		var number: float = stored[key]
		problems.append(StateCheck.within(_SYMBOLS[key], number, limits[key][0], limits[key][1]))
	problems.append(_problem_of_kind(kind, stored))
	return StateCheck.first(problems)


static func _problem_of_kind(kind: int, stored: Dictionary) -> String:
	match kind:
		MovingSurface.Kind.WALL, MovingSurface.Kind.PADDLE:
			return _problem_of_gap(stored)
		MovingSurface.Kind.BELT:
			return _problem_of_belt(stored)
		MovingSurface.Kind.PRESS:
			return _problem_of_press(stored)
	return ""


# A ball that overlaps has no moment at which it comes.
static func _problem_of_gap(stored: Dictionary) -> String:
	var list: PackedFloat64Array = stored["surface"]
	var segment := segment_of(list)
	if segment.length() < SHORTEST:
		var sentence := LabText.translate("The surface must be at least %s px long, not %s.")
		return sentence % [SHORTEST, segment.length()].map(NumberText.short)
	var pair: PackedFloat64Array = stored["ball"]
	var ball := Vec2.new(pair[0], pair[1])
	var distance := segment.closest_point(ball).distance_to(ball)
	if distance > MovingSurface.RADIUS:
		return ""
	var wanted := LabText.translate(
		"At the start the ball's centre must be more than %s px from the surface, not %s."
	)
	return wanted % [MovingSurface.RADIUS, distance].map(NumberText.short)


static func _problem_of_belt(stored: Dictionary) -> String:
	var list: PackedFloat64Array = stored["surface"]
	if list[2] - list[0] >= SHORTEST:
		return ""
	var sentence := LabText.translate("The belt must lead at least %s px to the right, not %s.")
	return sentence % [SHORTEST, list[2] - list[0]].map(NumberText.short)


static func _problem_of_press(stored: Dictionary) -> String:
	var speed: float = stored["speed"]
	var wall_speed: float = stored["surface_speed"]
	if speed >= wall_speed + SMALLEST:
		return ""
	var sentence := LabText.translate(
		"The ball must be at least %s px/s faster than the wall with %s, not %s."
	)
	return sentence % [SMALLEST, wall_speed, speed].map(NumberText.short)


## The segment of a stored list of four numbers.
static func segment_of(list: PackedFloat64Array) -> LineSegment:
	return LineSegment.new(Vec2.new(list[0], list[1]), Vec2.new(list[2], list[3]))
