class_name AimQuestion
extends RefCounted
## Where to aim at a target that moves: what is asked, and by how much a shot misses.

## The muzzle, in pixels.
var shooter: Vec2
## What must be hit, a point.
var target: AimTarget
## What pulls the bullet, in px/s².
var gravity: Vec2
## The bullet's speed, in px/s.
var speed: float
## Seconds until a right shot hits.
var time: float


## A question; [method BallisticAim.at_moving] must know an answer within [param longest] seconds,
## else [member time] is 0.
func _init(
	from: Vec2, at: AimTarget, bullet_speed: float, with_gravity: Vec2, longest: float
) -> void:
	shooter = from
	target = at
	speed = bullet_speed
	gravity = with_gravity
	var shots := BallisticAim.at_moving(shooter, target, gravity, speed, longest)
	time = shots[0].time if shots else 0.0


## By how much a shot in [param direction], of length 1, misses, in pixels: the least distance of
## the centres until a while after the right moment. NAN for what is no direction.
func miss(direction: Vec2) -> float:
	if not direction.is_finite():
		return NAN
	var factor := DoubleDouble.from_float(speed)
	var bullet := ExactVector.from_vec2(direction).scaled(factor)
	var velocity := bullet.minus(ExactVector.from_vec2(target.velocity))
	var place := ExactVector.between(target.position, shooter)
	return ExactApproach.new(place, velocity, gravity).least_distance(2.0 * time + 1.0, time)


## The same for a result of the aiming code; NAN for one without a hit.
func miss_of(aim: Aim) -> float:
	return miss(aim.direction) if aim.hit else NAN
