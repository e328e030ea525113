class_name Aim
extends RefCounted
## A shot that hits, or why there is none. Read [member hit] first: without a hit, only
## [member outcome] has a meaning.

## Why there is a shot, or why there is none: the target is faster than the bullet and gets away, or
## no direction reaches it (in time).
enum Outcome { HIT, OUTRUN, OUT_OF_REACH }

## Whether the shot hits.
var hit := false
## Seconds from the shot to the hit.
var time := 0.0
## The direction in which to shoot, length 1; zero where target and shooter are in one place.
var direction: Vec2
## The target's centre at that moment, in pixels.
var target: Vec2
## Why there is a shot, or why there is none.
var outcome := Outcome.OUT_OF_REACH


## A result without a hit, for the reason [param reason].
static func miss(reason: Outcome) -> Aim:
	var aim := Aim.new()
	aim.outcome = reason
	return aim


## A shot in [param with_direction], of any length, that hits after [param at_time] seconds where
## the target is then.
static func at(at_time: float, with_direction: Vec2, at_target: Vec2) -> Aim:
	var aim := Aim.new()
	aim.hit = true
	aim.outcome = Outcome.HIT
	aim.time = at_time
	aim.direction = with_direction.normalized()
	aim.target = at_target
	return aim


## Whether a bullet can have this speed: above 0 px/s and finite. Else it is an error.
static func can_shoot(speed: float) -> bool:
	if speed > 0.0 and speed < INF:
		return true
	push_error("The speed of a bullet must be above 0 px/s and finite, but is %s." % speed)
	return false
