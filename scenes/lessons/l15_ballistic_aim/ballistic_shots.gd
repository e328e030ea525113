class_name BallisticShots
extends RefCounted
## All aims from the origin that hit a target under gravity.

## A shot at a target that moves counts up to this flight, in seconds.
const LONGEST := 60.0

# Two directions that differ by less are one aim.
const _ONE_AIM := 1e-9


## The aims that hit [param target], the earliest first; none where it is at the origin.
## [param gravity] is in px/s², [param speed] in px/s. Of a target that rests up to two, else up to
## four.
static func aims(target: AimTarget, gravity: Vec2, speed: float) -> Array[Aim]:
	var here := Vec2.zero()
	if target.position.length() == 0.0:
		return []
	if target.velocity.length() == 0.0 and target.acceleration.length() == 0.0:
		return _apart(BallisticAim.at_fixed(here, target.position, gravity, speed))
	return BallisticAim.at_moving(here, target, gravity, speed, LONGEST)


# At the edge of what can be reached both arcs are one.
static func _apart(found: Array[Aim]) -> Array[Aim]:
	if found.size() == 2 and found[0].direction.distance_to(found[1].direction) <= _ONE_AIM:
		found.resize(1)
	return found
