class_name CirclePass
extends RefCounted
## A bullet that flies straight past a target on a circle: when it crosses the circle, and when it
## is nearest to the target. In plain numbers, because many moments are looked at.

# The target turns by no more than this between two looks, in radians.
const _LOOK := 0.1
const _FEWEST_LOOKS := 120
const _MOST_LOOKS := 4000
# Then the way between two looks is cut in three, so often.
const _THIRDS := 60

var _x: float
var _y: float
var _vx: float
var _vy: float
var _radius: float
var _phase: float
var _turn: float


## A bullet [param from] the circle's centre, in pixels, with [param velocity], in px/s, not zero.
## The circle has [param radius]; the target is at the angle [param phase], in radians, as the
## bullet is fired, and turns by [param turn] radians a second.
func _init(from: Vec2, velocity: Vec2, radius: float, phase: float, turn: float) -> void:
	_x = from.x
	_y = from.y
	_vx = velocity.x
	_vy = velocity.y
	_radius = radius
	_phase = phase
	_turn = turn


## Seconds from the shot until the bullet first crosses the circle; -1 where it does not.
func first_crossing() -> float:
	var distance := sqrt(_x * _x + _y * _y)
	var outside := (distance - _radius) * (distance + _radius)
	var growth := 2.0 * (_x * _vx + _y * _vy)
	for seconds in Quadratic.roots(_vx * _vx + _vy * _vy, growth, outside):
		if seconds > 0.0:
			return seconds
	return -1.0


## Seconds from the shot until the bullet is nearest to the target.
func nearest_time() -> float:
	# Later it is farther away than at the muzzle.
	var reach := sqrt(_x * _x + _y * _y) + _radius
	var longest := 2.0 * reach / sqrt(_vx * _vx + _vy * _vy)
	var looks := clampi(ceili(absf(_turn) * longest / _LOOK), _FEWEST_LOOKS, _MOST_LOOKS)
	var best := 0
	var least := INF
	for look: int in looks + 1:
		var apart := _squared_distance(longest * look / looks)
		if apart < least:
			least = apart
			best = look
	return _between(longest * maxi(best - 1, 0) / looks, longest * mini(best + 1, looks) / looks)


func _between(from: float, to: float) -> float:
	for part: int in _THIRDS:
		var third := (to - from) / 3.0
		if _squared_distance(from + third) <= _squared_distance(to - third):
			to -= third
		else:
			from += third
	return from


func _squared_distance(seconds: float) -> float:
	var angle := _phase + _turn * seconds
	var x := _x + _vx * seconds - _radius * cos(angle)
	var y := _y + _vy * seconds - _radius * sin(angle)
	return x * x + y * y
