class_name EventTimeline
extends RefCounted
## The balls of the lesson in event worlds: they can be brought to any moment, back and forth. Event
## worlds predict what is to come; what has been is computed again from a snapshot, one for each
## [constant SPAN] seconds.
##
## Each ball has a world of its own, because in this lesson balls do not touch each other. Times are
## in seconds since the start of the timeline.

## How many seconds are predicted, and shown.
const SPAN := 10.0
# Moments that differ by less than this are the same, in seconds.
const _NOTHING := 1e-9

## The moment at which the balls are.
var time := 0.0

var _world: SteppedWorld
# One for each ball; null where it was lost at the start of the timeline.
var _worlds: Array[EventWorld] = []
# The snapshots of each ball, one for the beginning of each SPAN seconds.
var _snapshots: Array[Array] = []
var _frame := 0.0
var _first_frames := 0
var _first_bounces := 0
var _forecast: EventWorld
var _forecast_index := -1
var _impacts: Array[WorldEvent] = []


## The timeline of the balls of [param world] from now on, which it moves. A frame of the course
## lasts [param frame_seconds].
func _init(world: SteppedWorld, frame_seconds: float) -> void:
	_world = world
	_frame = frame_seconds
	_first_frames = world.frames
	_first_bounces = world.bounces
	world.push_out_balls()
	for i in world.balls.size():
		var made: EventWorld = null
		if world.is_lost[i] == 0:
			made = EventMover.world_of(world.balls[i], world.surroundings)
			_snapshots.append([made.snapshot()])
		else:
			_snapshots.append([])
		_worlds.append(made)


## Goes to a moment, at 0 or later. "" or one sentence, if a ball bounces too often to get there.
func go_to(seconds: float) -> String:
	var problem := ""
	_world.latest_bounces.clear()
	_world.bounces = _first_bounces
	for i in _worlds.size():
		if _worlds[i]:
			var refused := _bring(i, seconds)
			problem = problem if problem else refused
			_show(i)
	time = seconds
	_world.frames = _first_frames + floori(time / _frame + _NOTHING)
	return problem


## Seconds that have passed in the world, including those before the start of the timeline.
func elapsed_seconds() -> float:
	return _first_frames * _frame + time


## The impacts of a ball from the start until [param seconds], and the later ones that are known.
## They end where the ball bounces too often for [method go_to].
func impacts(index: int, seconds: float) -> Array[WorldEvent]:
	if index != _forecast_index:
		_forecast_index = index
		_forecast = null
		_impacts.clear()
		if _worlds[index]:
			_forecast = EventMover.world_of(_first_ball(index), _world.surroundings)
	if _forecast and _forecast.time < seconds:
		var problem := _forecast.advance_to(seconds)
		_impacts.append_array(_forecast.events)
		_forecast.events.clear()
		if problem:
			_forecast = null
	return _impacts


## The moment of the ball's next impact after now, or of the one before; -1 where none is known.
func impact_time(index: int, direction: int) -> float:
	var found := -1.0
	for event in impacts(index, page_start() + SPAN):
		if direction > 0 and event.time > time + _NOTHING:
			return event.time
		if direction < 0 and event.time < time - _NOTHING:
			found = event.time
	return found


## The latest bounce of the ball until now; null before the first.
func last_bounce(index: int) -> BounceRecord:
	var latest: WorldEvent = null
	for event in impacts(index, time):
		if event.time <= time + _NOTHING and event.kind == WorldEvent.Kind.SEGMENT:
			latest = event
	return _record(latest, index) if latest else null


## The beginning of the [constant SPAN] seconds that are shown; now is among them.
func page_start() -> float:
	return floorf(time / SPAN + _NOTHING) * SPAN


func _bring(index: int, seconds: float) -> String:
	var world := _worlds[index]
	var kept := _snapshots[index]
	if seconds < world.time:
		var place := mini(floori(seconds / SPAN), kept.size() - 1)
		var snapshot: WorldSnapshot = kept[place]
		Refusal.push(world.restore(snapshot))
	world.events.clear()
	while kept.size() * SPAN <= seconds:
		var problem := world.advance_to(kept.size() * SPAN)
		if problem:
			return problem
		kept.append(world.snapshot())
	return world.advance_to(seconds)


func _show(index: int) -> void:
	var ball := _world.balls[index]
	ball.position = _worlds[index].position(0)
	ball.velocity = _worlds[index].velocity(0)
	_world.bounces += _worlds[index].impacts
	_world.is_lost[index] = 0 if SteppedWorld.reaches(ball.position) else 1
	for event in _worlds[index].events:
		if event.kind == WorldEvent.Kind.SEGMENT:
			_world.latest_bounces.append(_record(event, index))


# The bounce is given as a share of a frame of the course.
func _record(event: WorldEvent, index: int) -> BounceRecord:
	var frame_start := floorf(event.time / _frame) * _frame
	var radius := _world.balls[index].radius
	var record := EventMover.record_of(event, radius, frame_start, _frame)
	record.ball_index = index
	return record


func _first_ball(index: int) -> Ball:
	var world := _worlds[index]
	var now := world.snapshot()
	var first: WorldSnapshot = _snapshots[index][0]
	Refusal.push(world.restore(first))
	var ball := world.ball(0)
	Refusal.push(world.restore(now))
	return ball
