class_name TurningBarrel
extends RefCounted
## Waits for the moment at which a barrel that turns all the time points ahead of a target as it
## should, without gravity.

# Between two looks neither the barrel nor the direction to aim at turns by more than this, in
# radians: else a crossing could be missed.
const _LARGEST_TURN := 0.3
const _FIRST_STEP := 1.0 / 64.0
const _SHORTEST_STEP := 1e-12

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
	var step := _FIRST_STEP
	var time := 0.0
	var ahead := _ahead(time)
	if ahead == 0.0:
		return _shot(time)
	while time < longest:
		var next := minf(time + step, longest)
		var next_ahead := _ahead(next)
		var change := absf(Turn.shortest(ahead, next_ahead))
		var turned := absf(_turn) * (next - time)
		if maxf(change, turned) > _LARGEST_TURN and step > _SHORTEST_STEP:
			step *= 0.5
			continue
		# Far from 0 a change of sign is the one from half a turn to minus half a turn.
		if (ahead < 0.0) != (next_ahead < 0.0) and absf(ahead) < 1.0:
			return _shot(_bisected(time, next, ahead < 0.0))
		if maxf(change, turned) < 0.5 * _LARGEST_TURN:
			step *= 1.5
		time = next
		ahead = next_ahead
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


func _bisected(left: float, right: float, rises: bool) -> float:
	while true:
		var middle := left + 0.5 * (right - left)
		if middle <= left or middle >= right:
			break
		if (_ahead(middle) < 0.0) == rises:
			left = middle
		else:
			right = middle
	return left if absf(_ahead(left)) < absf(_ahead(right)) else right


func _shot(time: float) -> TimedShot:
	return TimedShot.at(time, _lead(time).time)
