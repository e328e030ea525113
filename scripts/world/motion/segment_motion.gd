class_name SegmentMotion
extends MotionPieces
## How a segment of an [EventWorld] moves, by its time alone: with a constant velocity, along a path
## with turning points, or about a pivot. The time 0 is when the segment is given this motion.


## A constant velocity, in pixels per second.
static func steady(velocity: Vec2) -> SegmentMotion:
	var made := SegmentMotion.new()
	made._velocities = [velocity.copy()]
	return made


## A path: at each of these times, in seconds, the segment is so far from where it was at the time
## 0, in pixels, and in between it moves straight. The first time is 0, and the first way is (0, 0).
## At the end the segment stays; with [param repeats] the path begins again, and has to end at (0,
## 0).
static func along(
	times: PackedFloat64Array, ways: Array[Vec2], repeats: bool = false
) -> SegmentMotion:
	var made := SegmentMotion.new()
	made._problem = _problem_of_path(times, ways, repeats)
	if made._problem:
		return made
	made._begins = times.duplicate()
	made._ways.clear()
	made._velocities.clear()
	for place in ways.size():
		made._ways.append(ways[place].copy())
		if place + 1 < ways.size():
			var seconds := times[place + 1] - times[place]
			made._velocities.append(ways[place + 1].minus(ways[place]).divided(seconds))
		else:
			made._velocities.append(Vec2.zero())
	if repeats:
		made._period = times[-1]
	return made


## Turns about a point, in pixels, by so many radians per second, clockwise on screen; 0 turns
## nothing. The point may move with a constant velocity, in pixels per second.
static func turning(about: Vec2, speed: float, velocity := Vec2.zero()) -> SegmentMotion:
	var made := steady(velocity)
	made.pivot = about.copy()
	made.turn = speed
	return made


## See [method GivenMotion.begin].
func begin(segments: SegmentScan, place: int, time: float, low: float) -> SegmentScan:
	var moving := segments as MovingSegments
	if not moving:
		moving = MovingSegments.new()
		moving.take_from(segments)
	moving.move(place, SegmentMover.new(segments.segment(place), self, time, low))
	return moving


static func _problem_of_path(times: PackedFloat64Array, ways: Array[Vec2], repeats: bool) -> String:
	if times.size() != ways.size() or times.size() < 2:
		var sizes := [times.size(), ways.size()]
		return "A path needs two times or more and a way for each, not %d and %d." % sizes
	if times[0] != 0.0 or ways[0].length() != 0.0:
		return (
			"A path begins at 0 s with the way (0, 0), not at %s s with %s." % [times[0], ways[0]]
		)
	for place in range(1, times.size()):
		if not (times[place] > times[place - 1] and times[place] < INF):
			var values := [times[place - 1], times[place]]
			return "The times of a path must rise, not go from %s s to %s s." % values
	if repeats and ways[-1].length() != 0.0:
		return "A path that is repeated ends with the way (0, 0), not with %s." % ways[-1]
	return ""
