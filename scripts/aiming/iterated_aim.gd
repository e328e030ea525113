class_name IteratedAim
extends RefCounted
## Aims ahead as many games do: guess how long the bullet flies, aim at where the target is then,
## and guess again from there (fixed-point iteration).
##
## No round aims at where the target is now, and one round is the usual lead. Each round divides the
## error by about the ratio of the speeds of bullet and target. Nothing tells whether it is small
## yet; where the target is faster, it grows.


## A shot at a target whose acceleration does not count, after so many [param rounds], 0 or more.
## The bullet has [param speed], in px/s. The shot is meant to hit, but may miss.
static func lead(shooter: Vec2, target: AimTarget, speed: float, rounds: int) -> Aim:
	if not Aim.can_shoot(speed):
		return Aim.miss(Aim.Outcome.OUT_OF_REACH)
	var place := target.position.copy()
	var time := 0.0
	for each in rounds:
		time = maxf(place.distance_to(shooter) - target.radius, 0.0) / speed
		place = target.position.plus(target.velocity.scaled(time))
	return Aim.at(time, place.minus(shooter), place)


## The same under gravity: each round takes the flat arc to a target that rests where this one is
## after the guessed time. Where a place cannot be reached, there is no shot.
static func ballistic(
	shooter: Vec2, target: AimTarget, gravity: Vec2, speed: float, rounds: int
) -> Aim:
	var place := target.position.copy()
	var shots := BallisticAim.at_fixed(shooter, place, gravity, speed)
	for each in rounds:
		if shots:
			place = target.position_after(shots[0].time)
			shots = BallisticAim.at_fixed(shooter, place, gravity, speed)
	return shots[0] if shots else Aim.miss(Aim.Outcome.OUT_OF_REACH)
