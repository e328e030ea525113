class_name BallRun
extends RefCounted
## The balls of the lesson as they fly in the event world, at any moment, forwards and back.
##
## A bounce with C below 1 forgets how fast the balls came: two different pasts end in the same
## present, at C = 0 always. So the way back cannot be computed from the velocities. The run keeps
## the whole world once a second, and a moment between two of these is flown again from the one
## before: the event world gives the same bits, however its time is cut. So any moment comes back
## to the last bit, and a minute of 50 balls needs only 60 kept worlds.

## A run ends after so many seconds at the latest.
const LONGEST := 60.0
## Half of the width and half of the height of the box around the origin.
const HALF_BOX: Array[float] = [12.0, 6.5]
# Seconds between two worlds that are kept.
const _PERIOD := 1.0
# Without walls the run goes on so many seconds after the meeting, or as long as it took to come.
const _AFTER_MEETING := 1.5
# Without a meeting it goes on so long.
const _WITHOUT_MEETING := 4.0
# Before the first meeting there are at most so many bounces off walls.
const _MOST_EVENTS := 5000
# A share of a time that is a little more than the last place of it.
const _HAIR := 2.0 ** -52

## The first meeting of two balls; null where there is none within [constant LONGEST].
var meeting: BallMeeting
## When it ends, in seconds.
var end := LONGEST
## Why the world has stopped before its time; "" where it has not.
var refusal := ""

var _world := EventWorld.new()
var _kept: Array[WorldSnapshot] = []
var _has_newton: bool
var _bounciness: float


## Of these balls, in the box or not. Without [param has_newton] each ball bounces off another one
## as off a wall.
func _init(at_start: Array[Ball], bounciness: float, has_box: bool, has_newton: bool) -> void:
	_has_newton = has_newton
	_bounciness = bounciness
	_world.keeps_events = true
	Refusal.push(_world.set_bounciness(bounciness))
	if has_box:
		var corner := Vec2.new(HALF_BOX[0], HALF_BOX[1])
		Refusal.push(_world.set_walls(corner.negated(), corner))
	Refusal.push(_world.set_balls(at_start))
	_kept.append(_world.snapshot())
	_find_meeting()
	_put_back(_kept[0])
	if not has_box:
		end = _end_without_walls()


## Goes to the moment [param seconds] after the start, 0 to [constant LONGEST].
func go_to(seconds: float) -> void:
	if seconds < _world.time:
		_put_back(_kept[mini(floori(seconds / _PERIOD), _kept.size() - 1)])
	while _kept.size() * _PERIOD <= seconds and not refusal:
		_fly_to(_kept.size() * _PERIOD)
		_kept.append(_world.snapshot())
	_fly_to(seconds)


## The balls as they are now.
func balls() -> Array[Ball]:
	var found: Array[Ball] = []
	for index: int in _world.ball_count():
		found.append(_world.ball(index))
	return found


## The momentum of all balls now.
func momentum() -> Vec2:
	var sum := Vec2.new()
	for ball in balls():
		sum.add(ball.velocity.scaled(ball.mass))
	return sum


## The kinetic energy of all balls now.
func energy() -> float:
	return _world.energy()


## How many bounces there were until now.
func bounce_count() -> int:
	return _world.impacts


func _find_meeting() -> void:
	for count: int in _MOST_EVENTS:
		if _world.advance_to_next_event() or _world.time > LONGEST:
			return
		var first := _world.events.find_custom(_is_of_balls)
		if first >= 0:
			_take_meeting(_world.events[first], _world.events[first + 1])
			return
		_world.events.clear()


static func _is_of_balls(event: WorldEvent) -> bool:
	return event.kind == WorldEvent.Kind.BALL


# Each of the two balls has an event of its own, one after the other.
func _take_meeting(one: WorldEvent, other: WorldEvent) -> void:
	var low := one if one.ball < other.ball else other
	var high := other if one.ball < other.ball else one
	meeting = BallMeeting.new(_ball_before(low), _ball_before(high), _bounciness)
	meeting.first = low.ball
	meeting.second = high.ball
	meeting.time = _world.time


func _ball_before(event: WorldEvent) -> Ball:
	var ball := _world.ball(event.ball)
	ball.velocity = event.velocity_before
	return ball


func _end_without_walls() -> float:
	if not meeting:
		return _WITHOUT_MEETING
	return minf(meeting.time + maxf(meeting.time, _AFTER_MEETING), LONGEST)


func _put_back(kept: WorldSnapshot) -> void:
	refusal = ""
	Refusal.push(_world.restore(kept))
	_world.events.clear()


func _fly_to(seconds: float) -> void:
	var count := 0
	while not _has_newton and not refusal and _fly_to_bounce(seconds):
		count += 1
		if count > _MOST_EVENTS:
			refusal = "There are more than %d bounces until %s s." % [_MOST_EVENTS, seconds]
	if not refusal:
		refusal = _world.advance_to(seconds)
	_world.events.clear()


# Without Newton: what happens next is looked at and put back, and two balls are changed a hair
# before they meet. False where nothing happens any more until then.
func _fly_to_bounce(seconds: float) -> bool:
	if _world.next_event_time() > seconds:
		return false
	var before := _world.snapshot()
	_world.events.clear()
	if _world.advance_to_next_event() or _world.time > seconds:
		_put_back(before)
		return false
	var events: Array[WorldEvent] = _world.events.duplicate()
	if not _is_of_balls(events[0]):
		return true
	var moment := _world.time * (1.0 - _HAIR)
	_put_back(before)
	if moment > _world.time:
		refusal = _world.advance_to(moment)
	for event: WorldEvent in events.slice(0, 2):
		_bounce_as_off_a_wall(event)
	return true


func _bounce_as_off_a_wall(event: WorldEvent) -> void:
	var ball := _world.ball(event.ball)
	ball.velocity = event.velocity_before.reflected(event.normal, _bounciness)
	if _bounciness < 1.0:
		# At C = 0 rounding would have them meet again at once, and for ever.
		var size := event.velocity_before.length()
		ball.velocity.add(event.normal.scaled(BallPiles.LEAST_SHARE * size))
	Refusal.push(_world.change_ball(event.ball, ball))
