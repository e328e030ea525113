class_name TimedShotCheck
extends RefCounted
## What can be wrong with a state of the lesson on the moment to fire.

## No place or speed is larger than this, in pixels and seconds.
const LARGEST := 1e4
## The bullet is not slower than this, in px/s, and a circle not smaller, in pixels.
const SMALLEST := 1.0
## Nothing turns faster than this, in degrees per second.
const FASTEST_TURN := 720.0
## The target on a circle does not turn more slowly than this.
const SLOWEST_TURN := 1.0
## A shot later than this, in seconds, does not count.
const LONGEST := 60.0


## "" if the lesson, which has [param kind_count] kinds of motion, can show [param stored]; else one
## sentence with the value and what is allowed. Only the kind [param circle] needs a circle.
static func problem_in(stored: Dictionary, kind_count: int, circle: int) -> String:
	var problems: PackedStringArray = []
	for key: String in ["muzzle", "bullet", "target", "velocity", "centre"]:
		var pair: PackedFloat64Array = stored[key]
		for number in pair:
			problems.append(StateCheck.within(key, number, -LARGEST, LARGEST))
	var of_kind: int = stored["kind"]
	var circling: float = stored["circling"]
	var turning: float = stored["turning"]
	var radius: float = stored["radius"]
	var fire: float = stored["fire"]
	var mistake: int = stored["mistake"]
	var fastest := FASTEST_TURN
	(
		problems
		. append_array(
			[
				StateCheck.within("kind", of_kind, 0, kind_count - 1),
				StateCheck.within("radius", radius, 0.0, LARGEST),
				StateCheck.within("fire", fire, 0.0, LONGEST),
				StateCheck.within("turning", turning, -fastest, fastest),
				StateCheck.within("circling", absf(circling), SLOWEST_TURN, fastest),
				_size_problem("bullet", "", stored),
				_size_problem("target", "centre", stored) if of_kind == circle else "",
				StateCheck.mistake(mistake, TimedShotMistakes.infos()),
			]
		)
	)
	return StateCheck.first(problems)


# How fast the bullet is, or how large the circle.
static func _size_problem(key: String, from: String, stored: Dictionary) -> String:
	var pair: PackedFloat64Array = stored[key]
	var size := Vec2.new(pair[0], pair[1])
	if from:
		var start: PackedFloat64Array = stored[from]
		size.subtract(Vec2.new(start[0], start[1]))
	if size.length() >= SMALLEST:
		return ""
	var sentence := LabText.translate("The circle needs a radius of 1 px or more, not %s.")
	if not from:
		sentence = LabText.translate("The bullet needs a speed of 1 px/s or more, not %s.")
	return sentence % NumberText.short(size.length())
