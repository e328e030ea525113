class_name ShotSearch
extends RefCounted
## When a shot is nearest to its target, found by looking at many moments: slow, but it knows
## nothing of how both move.

const _MOMENTS := 400
const _THIRDS := 80


## The moment until [param longest] seconds at which the bullet of [param shot] is nearest to a
## target that is at [code]place.call(seconds)[/code]. The earliest of equal ones.
static func nearest_moment(shot: FiredShot, place: Callable, longest: float) -> float:
	var nearest := 0
	var least := INF
	for moment: int in _MOMENTS + 1:
		var distance := shot.distance_after(longest * moment / _MOMENTS, place)
		if distance < least:
			least = distance
			nearest = moment
	var from := longest * maxi(nearest - 1, 0) / _MOMENTS
	var to := longest * mini(nearest + 1, _MOMENTS) / _MOMENTS
	# The way is cut in three, and the third that is farther away is left.
	for part: int in _THIRDS:
		var third := (to - from) / 3.0
		if shot.distance_after(from + third, place) <= shot.distance_after(to - third, place):
			to -= third
		else:
			from += third
	return from
