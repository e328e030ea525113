class_name ShotMiss
extends RefCounted
## By how much a shot in free flight misses: the smallest distance of the centres of bullet and
## target, as the event world flies the bullet.

## Seconds from the shot to the moment at which both are nearest.
var moment := 0.0
## How far the centres are from each other then, in pixels.
var distance := 0.0


## The miss of a bullet that leaves [param start] with [param velocity], in px/s, and is pulled by
## [param gravity], in px/s², within [param longest] seconds. Where the shot was computed to hit
## after [param computed] seconds, that moment counts, too: there the search can be off by rounding.
##
## Seen from the bullet, the target moves by Q(t) = P + U t + B t²/2. It is nearest where
## Q · (U + B t) = 0, an equation of degree three.
static func of(
	start: Vec2,
	velocity: Vec2,
	gravity: Vec2,
	target: AimTarget,
	longest: float,
	computed: float = 0.0
) -> ShotMiss:
	var way := target.position.minus(start)
	var closing := target.velocity.minus(velocity)
	var bend := target.acceleration.minus(gravity)
	var moments := _nearest_times(way, closing, bend, longest)
	moments.append_array([0.0, computed])
	var shot := FiredShot.new(start, velocity, gravity)
	return nearest_of(shot, target.position_after, moments)


## The miss of [param shot] at the one of these [param moments], in seconds after it, at which it is
## nearest to a target that is at [code]place.call(seconds)[/code].
static func nearest_of(shot: FiredShot, place: Callable, moments: PackedFloat64Array) -> ShotMiss:
	var found := ShotMiss.new()
	found.distance = INF
	for time in moments:
		var apart := shot.distance_after(time, place)
		if apart < found.distance:
			found.distance = apart
			found.moment = time
	return found


# Where the distance does not change, and where the search ends. Lengths are counted in that of the
# way, and times in the time for it.
static func _nearest_times(
	way: Vec2, closing: Vec2, bend: Vec2, longest: float
) -> PackedFloat64Array:
	var length := way.length()
	var speed := closing.length()
	if length == 0.0 or speed == 0.0:
		return [longest]
	var unit := length / speed
	var p := way.divided(length)
	var u := closing.divided(speed)
	var b := bend.scaled(unit / speed)
	var growth: PackedFloat64Array = [
		p.dot(u), u.length_squared() + p.dot(b), 1.5 * u.dot(b), 0.5 * b.length_squared()
	]
	var found: PackedFloat64Array = [longest]
	for time in RealRoots.of_polynomial(growth, 0.0, longest / unit):
		found.append(time * unit)
	return found
