class_name AimTarget
extends RefCounted
## What is shot at: a disc whose centre moves with a constant acceleration.

## The centre when the shot is fired, in pixels.
var position: Vec2
## Pixels per second.
var velocity: Vec2
## Pixels per second squared.
var acceleration: Vec2
## The radii of bullet and target together, in pixels; 0 where the centres must meet.
var radius: float


## A target at [param at_position]; without more, it rests and is a point. The vectors are copied,
## so that nothing is shared.
func _init(
	at_position: Vec2,
	with_velocity := Vec2.zero(),
	with_acceleration := Vec2.zero(),
	with_radius: float = 0.0
) -> void:
	position = at_position.copy()
	velocity = with_velocity.copy()
	acceleration = with_acceleration.copy()
	radius = with_radius


## Where the centre is after so many seconds, in pixels.
func position_after(seconds: float) -> Vec2:
	var way := velocity.scaled(seconds).plus(acceleration.scaled(0.5 * seconds * seconds))
	return position.plus(way)
