class_name AngledLinesLink
extends RefCounted
## What a link to the lesson on angled lines holds: the situation that was picked, and what is
## different from its start. The past and the counters stay behind.

## The ways of stepping by their words, in the order of [enum SteppingMethods.Method].
const METHODS: PackedStringArray = [
	"position_reset", "point_of_impact", "whole_frame", "event_world"
]
## Radii of balls in pixels.
const SMALLEST_RADIUS := 0.1
const LARGEST_RADIUS := 200.0

const _BALL := 5
const _START := 4
const _LINE := 4
# What a link does not take from the start of the situation.
const _PICKED: PackedStringArray = ["scene", "method", "mistake"]


## What [param model] is like now.
static func state_of(model: AngledLinesModel) -> Dictionary:
	var stored := model.to_dictionary()
	var world: Dictionary = stored["world"]
	var starts: PackedFloat64Array = stored["first"]
	var lines: PackedFloat64Array = world["lines"]
	var balls: Array[PackedFloat64Array] = []
	for ball in model.world.balls:
		var place := ball.position
		var velocity := ball.velocity
		balls.append(PackedFloat64Array([place.x, place.y, velocity.x, velocity.y, ball.radius]))
	return {
		"scene": model.scene,
		"method": METHODS[model.method],
		"mistake": model.mistake,
		"selected": model.selected,
		"gravity": world["gravity"],
		"bounciness": world["bounciness"],
		"balls": balls,
		"starts": _cut(starts, _START),
		"lines": _cut(lines, _LINE),
	}


## The start of the situation that [param wanted] names, but for what was picked: that is as in
## [param first].
static func base(first: Dictionary, wanted: Dictionary) -> Dictionary:
	var model := AngledLinesModel.new()
	var scene: int = wanted["scene"]
	model.set_up(clampi(scene, 0, AngledLinesScenes.TITLES.size() - 1))
	var start := state_of(model)
	for name in _PICKED:
		start[name] = first[name]
	return start


## "" if [param linked] can be shown; else one sentence with the value and what is allowed.
static func problem_of(linked: Dictionary) -> String:
	var method: String = linked["method"]
	var mistake: int = linked["mistake"]
	var is_exact := method == METHODS[SteppingMethods.Method.EVENT_WORLD]
	var infos: Array[MistakeInfo] = []
	var scene: int = linked["scene"]
	var selected: int = linked["selected"]
	var balls: Array[PackedFloat64Array] = linked["balls"]
	return (
		StateCheck
		. first(
			[
				StateCheck.within("scene", scene, 0, AngledLinesScenes.TITLES.size() - 1),
				StateCheck.word("method", method, METHODS),
				# The event world makes no mistake.
				StateCheck.mistake(mistake, infos if is_exact else AngledLinesMistakes.all()),
				StateCheck.within("selected", selected, 0, balls.size() - 1),
				_problem_of_surroundings(linked),
				_problem_of_balls(linked),
			]
		)
	)


## The state for [method AngledLinesModel.from_dictionary], as it is before anything has happened.
static func to_dictionary(linked: Dictionary) -> Dictionary:
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
		"scene": linked["scene"],
		"method": METHODS.find(str(linked["method"])),
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
	if lines.size() > AngledLinesModel.MOST_LINES:
		var sentence := TranslationServer.translate("There is room for %d lines: delete one first.")
		return sentence % AngledLinesModel.MOST_LINES
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


# A lost ball is brought back to its start: that must not be lost itself.
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
