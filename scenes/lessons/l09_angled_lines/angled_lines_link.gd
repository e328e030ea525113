class_name AngledLinesLink
extends RefCounted
## What a link to the lesson on angled lines holds: the preset that was picked, and what differs
## from its start. It leaves out the past and the counters.

## The words for the ways of stepping, in the order of [enum SteppingMethods.Method].
const METHODS: PackedStringArray = [
	"position_reset", "point_of_impact", "whole_frame", "event_world"
]
## Radii of balls in pixels.
const SMALLEST_RADIUS := 0.1
const LARGEST_RADIUS := 200.0
## More lines would leave no room on the board.
const MOST_LINES := 60

const _BALL := 5
const _START := 4
const _LINE := 4
# Numbers before and for each ball in SteppedWorld.state().
const _COUNTERS := 3
const _MOVING := 5
# What does not come from the start of a preset.
const _PICKED: PackedStringArray = ["scene", "method", "mistake"]


## The link state for [param stored], a state of [method AngledLinesModel.to_dictionary].
static func of_state(stored: Dictionary) -> Dictionary:
	var world: Dictionary = stored["world"]
	var starts: PackedFloat64Array = stored["first"]
	var lines: PackedFloat64Array = world["lines"]
	var radii: PackedFloat64Array = world["radii"]
	var moving: PackedFloat64Array = world["moving"]
	var balls: Array[PackedFloat64Array] = []
	for i in radii.size():
		var at := _COUNTERS + _MOVING * i
		balls.append(moving.slice(at, at + _BALL - 1) + PackedFloat64Array([radii[i]]))
	var method: int = stored["method"]
	return {
		"scene": stored["preset"],
		"method": METHODS[method],
		"endless": stored["endless"],
		"mistake": stored["mistake"],
		"selected": stored["selected"],
		"gravity": world["gravity"],
		"bounciness": world["bounciness"],
		"balls": balls,
		"starts": _cut(starts, _START),
		"lines": _cut(lines, _LINE),
	}


## [param base], the start of a preset, with those values of the link state [param first] that do
## not come from a preset. A preset with endless lines has the one way of stepping that knows them.
static func with_picked(base: Dictionary, first: Dictionary) -> Dictionary:
	var is_endless: bool = base["endless"]
	var found := base.duplicate()
	for name in _PICKED:
		if name == "scene" or not is_endless:
			found[name] = first[name]
	return found


## "" if [param linked] can be shown; else one sentence with the value and what is allowed.
static func problem_in(linked: Dictionary) -> String:
	var method: String = linked["method"]
	var mistake: int = linked["mistake"]
	var is_endless: bool = linked["endless"]
	var is_exact := method == METHODS[SteppingMethods.Method.EVENT_WORLD]
	var infos: Array[MistakeInfo] = []
	var preset: int = linked["scene"]
	var selected: int = linked["selected"]
	var balls: Array[PackedFloat64Array] = linked["balls"]
	return (
		StateCheck
		. first(
			[
				StateCheck.within("scene", preset, 0, AngledLinesPresets.TITLES.size() - 1),
				StateCheck.word("method", method, METHODS),
				problem_of_kind(is_endless, METHODS.find(method)),
				# The event world makes no mistake; beside endless lines none is shown.
				StateCheck.mistake(
					mistake, infos if is_exact or is_endless else AngledLinesMistakes.all()
				),
				StateCheck.within("selected", selected, 0, balls.size() - 1),
				_problem_of_surroundings(linked),
				_problem_of_balls(linked),
			]
		)
	)


## "" if the way of stepping at the place [param method] knows the kind of line; else one sentence.
static func problem_of_kind(is_endless: bool, method: int) -> String:
	if not is_endless or method == SteppingMethods.Method.POSITION_RESET:
		return ""
	return LabText.translate(
		"Only position reset knows endless lines: choose lines that end first."
	)


## The state for [method AngledLinesModel.from_dictionary] that [param linked] stands for. Its
## counters are at 0, but for the balls that are lost already.
static func to_state(linked: Dictionary) -> Dictionary:
	var balls: Array[PackedFloat64Array] = linked["balls"]
	var starts: Array[PackedFloat64Array] = linked["starts"]
	var lines: Array[PackedFloat64Array] = linked["lines"]
	var radii: PackedFloat64Array = []
	var moving: PackedFloat64Array = []
	var lost_count := 0
	for ball in balls:
		var is_lost := int(not SteppedWorld.reaches(Vec2.new(ball[0], ball[1])))
		lost_count += is_lost
		moving.append_array(ball.slice(0, _BALL - 1))
		moving.append(is_lost)
		radii.append(ball[_BALL - 1])
	var counters: PackedFloat64Array = [0, 0, lost_count]
	return {
		"preset": linked["scene"],
		"method": METHODS.find(str(linked["method"])),
		"endless": linked["endless"],
		"mistake": linked["mistake"],
		"selected": linked["selected"],
		"world":
		{
			"gravity": linked["gravity"],
			"bounciness": linked["bounciness"],
			"lines": _joined(lines),
			"radii": radii,
			"moving": counters + moving,
		},
		"first": _joined(starts),
	}


static func _problem_of_surroundings(linked: Dictionary) -> String:
	var surroundings := Surroundings.new()
	var gravity: PackedFloat64Array = linked["gravity"]
	var bounciness: float = linked["bounciness"]
	var lines: Array[PackedFloat64Array] = linked["lines"]
	if lines.size() > MOST_LINES:
		var sentence := TranslationServer.translate("There is room for %d lines: delete one first.")
		return sentence % MOST_LINES
	var segments: Array[LineSegment] = []
	for line in lines:
		var start := Vec2.new(line[0], line[1])
		segments.append(LineSegment.new(start, Vec2.new(line[2], line[3])))
	return (
		StateCheck
		. first(
			[
				surroundings.set_gravity(Vec2.new(gravity[0], gravity[1])),
				surroundings.set_bounciness(bounciness),
				surroundings.set_segments(segments),
			]
		)
	)


static func _problem_of_balls(linked: Dictionary) -> String:
	var balls: Array[PackedFloat64Array] = linked["balls"]
	var starts: Array[PackedFloat64Array] = linked["starts"]
	if starts.size() != balls.size():
		var sentence := TranslationServer.translate(
			"starts must have %d parts, as balls has, not %d."
		)
		return sentence % [balls.size(), starts.size()]
	var far := Surroundings.LARGEST
	for ball in balls:
		for number in ball:
			var problem := StateCheck.within("balls", number, -far, far)
			if problem:
				return problem
		var radius := ball[_BALL - 1]
		var refused := StateCheck.within("balls", radius, SMALLEST_RADIUS, LARGEST_RADIUS)
		if refused:
			return refused
	return _problem_of_starts(starts)


# A lost ball is brought back to its start: a start must not be out of reach itself.
static func _problem_of_starts(starts: Array[PackedFloat64Array]) -> String:
	var world := SteppedWorld.new(WholeFrameMover.new())
	var balls: Array[Ball] = []
	for start in starts:
		balls.append(Ball.new(Vec2.new(start[0], start[1]), 1.0, Vec2.new(start[2], start[3])))
	return world.set_balls(balls)


static func _cut(numbers: PackedFloat64Array, length: int) -> Array[PackedFloat64Array]:
	var lists: Array[PackedFloat64Array] = []
	for at in range(0, numbers.size(), length):
		lists.append(numbers.slice(at, at + length))
	return lists


static func _joined(lists: Array[PackedFloat64Array]) -> PackedFloat64Array:
	var numbers: PackedFloat64Array = []
	for list in lists:
		numbers.append_array(list)
	return numbers
