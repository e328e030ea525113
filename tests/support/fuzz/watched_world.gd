class_name WatchedWorld
extends EventWorld
## An event world that notices when its time stands still, whatever kind of event repeats itself,
## and that answers what judges ask.

## So many events within [constant STILL] are a stand-still.
const MOST_AT_ONCE := 3000
## Seconds.
const STILL := 1e-9
## An elastic ball makes some 200 000 of the lowest hops in a second.
const MOST_IMPACTS_PER_SECOND := 300_000

## Whether time stands still.
var stands_still := false

var _happened := 0
var _since := 0.0
var _lines: Array[LineSegment] = []
# The count of changes for which they hold.
var _lines_of := -1


func _init() -> void:
	most_impacts_per_second = MOST_IMPACTS_PER_SECOND


## [method EventWorld.advance_to], with a sentence of its own for a stand-still.
func fly_to(target: float) -> String:
	var refusal := advance_to(target)
	if not refusal or not stands_still:
		return refusal
	return "Time stands still at %s s." % DecimalText.of(time)


## A world that is built from what is here now, and remembers nothing of what was before.
func afresh() -> WatchedWorld:
	var made := WatchedWorld.new()
	made.keeps_events = keeps_events
	Refusal.push(made.advance_to(time))
	if _has_walls:
		var low := Vec2.new(_left_x, _top_y)
		Refusal.push(made.set_walls(low, Vec2.new(_right_x, _bottom_y)))
	Refusal.push(made.set_gravity(Vec2.new(_gravity_x, _gravity_y)))
	Refusal.push(made.set_bounciness(_bounciness))
	Refusal.push(made.set_friction(_friction))
	Refusal.push(made.set_segments(lines()))
	var balls: Array[Ball] = []
	for index: int in ball_places():
		balls.append(ball(index))
	Refusal.push(made.set_balls(balls))
	return made


## The places where there is a line, in order.
func line_places() -> PackedInt32Array:
	var found: PackedInt32Array = []
	for place: int in segment_count():
		if _segments.has_segment(place):
			found.append(place)
	return found


## The places where there is a ball, in order.
func ball_places() -> PackedInt32Array:
	var found: PackedInt32Array = []
	for index: int in ball_count():
		if has_ball(index):
			found.append(index)
	return found


## The lines, in the order of their places.
func lines() -> Array[LineSegment]:
	if _lines_of != _contents or _moves:
		_lines_of = _contents
		_lines.clear()
		for place: int in line_places():
			_lines.append(segment(place))
	return _lines


## px/s².
func gravity() -> Vec2:
	return Vec2.new(_gravity_x, _gravity_y)


## µ.
func friction() -> float:
	return _friction


## The nearest point of each line and wall that the ball may touch.
func nearest_points(of_ball: Ball) -> Array[Vec2]:
	var at := of_ball.position
	var found := InsideCheck.points_of(lines(), of_ball)
	if _has_walls:
		# A ball beyond a wall is as deep in it as its far side is away.
		found.append(Vec2.new(minf(_left_x, at.x), at.y))
		found.append(Vec2.new(maxf(_right_x, at.x), at.y))
		found.append(Vec2.new(at.x, minf(_top_y, at.y)))
		found.append(Vec2.new(at.x, maxf(_bottom_y, at.y)))
	return found


# A stand-still counts as too many impacts, so that the world refuses to go on.
func _happen(index: int) -> void:
	super(index)
	_happened += 1
	if time - _since > STILL:
		_since = time
		_happened = 0
	elif _happened > MOST_AT_ONCE:
		stands_still = true
		_count_from = time
		impacts += most_impacts_per_second + 1
