class_name EventLog
extends RefCounted
## What has happened in an [EventWorld], in order. An event is begun before it changes the ball, and
## finished after it.

const _NO_SURFACE := -1

## The events so far.
var events: Array[WorldEvent] = []


## Notes that something happens to this ball at [param time] seconds, while it has this velocity in
## pixels per second and this spin in radians per second.
func begin(time: float, ball: int, velocity: Vec2, spin: float) -> WorldEvent:
	var event := WorldEvent.new()
	event.time = time
	event.ball = ball
	event.velocity_before = velocity
	event.spin_before = spin
	events.append(event)
	return event


## Adds what it was, with which other thing (a surface or a ball of [EventState]), at which unit
## normal, and how the ball is after it.
func finish(
	event: WorldEvent, kind: WorldEvent.Kind, other: int, normal: Vec2, ball_after: Ball
) -> void:
	event.kind = kind
	event.other = other
	if kind != WorldEvent.Kind.BALL and other < _NO_SURFACE:
		event.other = other - Slopes.LEFT_WALL
		if kind == WorldEvent.Kind.SEGMENT:
			event.kind = WorldEvent.Kind.WALL
	event.normal = normal
	event.point = ball_after.position.minus(normal.scaled(ball_after.radius))
	event.velocity_after = ball_after.velocity
	event.spin_after = ball_after.spin
