class_name TimedShotCheck
extends RefCounted
## What can be wrong with a state of the lesson on the moment to fire.


## "" if the lesson can show [param stored]; else one sentence with the value and what is allowed.
static func problem_in(stored: Dictionary) -> String:
	var problems: PackedStringArray = []
	for key: String in ["muzzle", "bullet", "target", "velocity", "centre"]:
		var pair: PackedFloat64Array = stored[key]
		for number in pair:
			problems.append(
				StateCheck.within(key, number, -TimedShotModel.LARGEST, TimedShotModel.LARGEST)
			)
	var of_kind: int = stored["kind"]
	var circling: float = stored["circling"]
	var turning: float = stored["turning"]
	var radius: float = stored["radius"]
	var fire: float = stored["fire"]
	var mistake: int = stored["mistake"]
	var fastest := TimedShotModel.FASTEST_TURN
	(
		problems
		. append_array(
			[
				StateCheck.within("kind", of_kind, 0, TimedShotModel.Kind.size() - 1),
				StateCheck.within("radius", radius, 0.0, TimedShotModel.LARGEST),
				StateCheck.within("fire", fire, 0.0, TimedShotModel.LONGEST),
				StateCheck.within("turning", turning, -fastest, fastest),
				StateCheck.within("circling", absf(circling), TimedShotModel.SLOWEST_TURN, fastest),
				_size_problem("bullet", "", stored),
				_size_problem("target", "centre", stored),
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
	if size.length() >= TimedShotModel.SMALLEST:
		return ""
	var sentence := LabText.translate("The circle needs a radius of 1 px or more, not %s.")
	if not from:
		sentence = LabText.translate("The bullet needs a speed of 1 px/s or more, not %s.")
	return sentence % NumberText.short(size.length())
