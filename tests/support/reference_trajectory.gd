class_name ReferenceTrajectory
extends RefCounted
## One row of tests/data/reference/trajectories.json: an elastic ball among segments, and where it
## is after some seconds, worked out elsewhere with 140 digits and rounded once.

const _FILE := "res://tests/data/reference/trajectories.json"

## The kind of room, and for how long the ball flies: `hexagon, 40 s`.
var title: String
## The ball at its start.
var ball: Ball
## The segments around it.
var segments: Array[LineSegment] = []
## How long it flies.
var seconds: float
## Where it is at the end, to the nearest double.
var end: Vec2
## Its velocity at the end.
var end_velocity: Vec2
## How often it has bounced.
var bounces: int
## How far the end moves, in pixels, per unit of relative change in the start.
var amplification: float


## All rows of the file.
static func all() -> Array[ReferenceTrajectory]:
	var content: Dictionary = JSON.parse_string(FileAccess.get_file_as_string(_FILE))
	var cases: Array = content["cases"]
	var trajectories: Array[ReferenceTrajectory] = []
	for case: Dictionary in cases:
		trajectories.append(_read(case))
	return trajectories


static func _read(case: Dictionary) -> ReferenceTrajectory:
	var trajectory := ReferenceTrajectory.new()
	trajectory.title = "%s, %s s" % [case["world"], case["seconds"]]
	var texts: Array = case["segments"]
	for ends: Array in texts:
		trajectory.segments.append(LineSegment.new(_point(ends), _point(ends.slice(2))))
	var radius := _doubles([case["radius"]])[0]
	trajectory.ball = Ball.new(_vector(case, "start"), radius, _vector(case, "velocity"))
	trajectory.seconds = case["seconds"]
	trajectory.end = _vector(case, "end")
	trajectory.end_velocity = _vector(case, "end_velocity")
	trajectory.bounces = int(str(case["bounces"]))
	trajectory.amplification = case["amplification_px"]
	return trajectory


static func _vector(case: Dictionary, key: String) -> Vec2:
	var texts: Array = case[key]
	return _point(texts)


static func _point(texts: Array) -> Vec2:
	var numbers := _doubles(texts)
	return Vec2.new(numbers[0], numbers[1])


static func _doubles(texts: Array) -> PackedFloat64Array:
	var numbers := PackedFloat64Array()
	for hex_digits: String in texts:
		numbers.append(hex_digits.hex_decode().decode_double(0))
	return numbers
