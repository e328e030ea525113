class_name ShotCondition
extends RefCounted
## How sensitive a shot is: how far it misses when the numbers that belong to it are not quite
## right. A number in a computer is right to half a unit in the last place, so even an exact
## solver misses by about [constant EPSILON] times the condition.

## The distance from 1 to the next number, 2⁻⁵².
const EPSILON := 2.220446049250313e-16

# Each number is changed by this share of itself. A power of two, so that the change is exact.
const _SHARE := 1.0 / (1 << 20)


## The sum, over all [param numbers] x, of |x| |d miss / d x|, in the unit of the miss.
## [code]miss.call(numbers)[/code] returns by how much the shot misses, as a [Vec2] in pixels. The
## numbers are all that the shot hangs on: places, velocities, the direction, and the time.
static func of(numbers: PackedFloat64Array, miss: Callable) -> float:
	var condition := 0.0
	for place: int in numbers.size():
		var changed := numbers.duplicate()
		changed[place] = numbers[place] * (1.0 + _SHARE)
		var more: Vec2 = miss.call(changed)
		changed[place] = numbers[place] * (1.0 - _SHARE)
		var less: Vec2 = miss.call(changed)
		condition += more.distance_to(less) / (2.0 * _SHARE)
	return condition
