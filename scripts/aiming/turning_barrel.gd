class_name TurningBarrel
extends RefCounted
## Waits for the moment at which a barrel that turns all the time points ahead of a target as it
## should, without gravity.
##
## Seen from the target, a bullet that is fired now flies with w = s u - v, and the muzzle is at -P.
## It hits where w × P = 0 while w · P is above 0. How much the slope of w × P can change is known;
## so a step in which it has no zero, or only one, is told for certain, and no zero is missed.

const _FIRST_STEP := 1.0 / 64.0
# As a share of the time from the first moment, or of a second. In a shorter step all is rounding:
# a zero that only touches is found, or not, as that has it.
const _SHORTEST_STEP := 1e-10

var _muzzle: Vec2
var _angle: float
var _turn: float
var _speed: float
var _target: AimTarget


## A barrel at [param muzzle] that points along [param angle], in radians, at the time 0 and turns
## by [param turn] radians a second, clockwise on screen; [param speed] of the bullet is more than
## that of the target, which moves on a line.
func _init(muzzle: Vec2, angle: float, turn: float, speed: float, target: AimTarget) -> void:
	_muzzle = muzzle
	_angle = angle
	_turn = turn
	_speed = speed
	_target = target


## The first moment to fire within [param longest] seconds. A bullet that is not faster than the
## target is an error.
func first(longest: float = TimedAim.LONGEST) -> TimedShot:
	if not _can_always_aim():
		return TimedShot.miss(TimedShot.Outcome.NO_CROSSING)
	if _ahead(0.0) == 0.0:
		return _shot(0.0)
	var step := _FIRST_STEP
	var time := 0.0
	while time < longest:
		var half := 0.5 * minf(step, longest - time)
		var middle := time + half
		var end := middle + half
		var most := _most_bend(time, end) * half
		var slope := absf(_slope(middle))
		var is_short := step < _SHORTEST_STEP * (1.0 + time)
		var has_none := absf(_beside(middle)) > (slope + 0.5 * most) * half
		if not (has_none or slope > most or is_short):
			step *= 0.5
			continue
		if not has_none and (_beside(time) < 0.0) != (_beside(end) < 0.0):
			var zero := _bisected(time, end, _beside(time) < 0.0)
			if _bullet(zero).dot(_place(zero)) > 0.0:
				return _shot(zero)
		time = end
		step *= 2.0
	return TimedShot.miss(TimedShot.Outcome.NOT_IN_TIME)


func _can_always_aim() -> bool:
	if not Aim.can_shoot(_speed):
		return false
	if _speed > _target.velocity.length():
		return true
	var values := [_speed, _target.velocity.length()]
	push_error("The bullet must be faster than the target, but has %s px/s to %s px/s." % values)
	return false


# The lead for a shot at this time.
func _lead(time: float) -> Aim:
	var there := AimTarget.new(_target.position_after(time), _target.velocity)
	return LeadAim.first(_muzzle, there, _speed)


# By how much the direction to aim at is clockwise of the barrel, in (-PI, PI].
func _ahead(time: float) -> float:
	var wanted := _lead(time).direction.angle_radians()
	return Turn.shortest(_angle + _turn * time, wanted)


# The target's place, as the muzzle sees it.
func _place(time: float) -> Vec2:
	return _target.position_after(time).minus(_muzzle)


# The velocity of a bullet that is fired then, as the target sees it.
func _bullet(time: float) -> Vec2:
	return _along(time).scaled(_speed).minus(_target.velocity)


func _along(time: float) -> Vec2:
	return Vec2.unit_radians(_angle + _turn * time)


# w × P: 0 where the bullet's way leads through the target.
func _beside(time: float) -> float:
	return _bullet(time).cross(_place(time))


# How fast it changes.
func _slope(time: float) -> float:
	var along := _along(time)
	return _speed * (along.cross(_target.velocity) - _turn * along.dot(_place(time)))


# How fast the slope changes at most between two times. The target is farthest at one of them.
func _most_bend(from: float, to: float) -> float:
	var farthest := maxf(_place(from).length(), _place(to).length())
	return _speed * absf(_turn) * (absf(_turn) * farthest + 2.0 * _target.velocity.length())


func _bisected(left: float, right: float, rises: bool) -> float:
	while true:
		var middle := left + 0.5 * (right - left)
		if middle <= left or middle >= right:
			break
		if (_beside(middle) < 0.0) == rises:
			left = middle
		else:
			right = middle
	return left if absf(_beside(left)) < absf(_beside(right)) else right


func _shot(time: float) -> TimedShot:
	return TimedShot.at(time, _lead(time).time)
