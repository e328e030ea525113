class_name CarriedRun
extends RefCounted
## A disc that does not turn yet and lies on a surface that runs below it, such as a belt: it slips,
## and then it rolls. The motion is that of [Incline].

## What becomes of it: it rolls at once; it slips and then rolls; the surface ends before; it slips
## all the way, because friction cannot hold it.
enum Case { ROLLS, ROLLS_LATER, ENDS_BEFORE, SLIPS }

## u: how fast its lowest point slips along the surface at first, in px/s.
var slip := 0.0
## What becomes of it.
var run_case := Case.SLIPS
## Seconds until it rolls; only where it does.
var roll_time := 0.0
## Its speed along the line then, in px/s.
var roll_speed := 0.0
## Seconds until it is at an end of the surface; INF where it never is.
var leave_time := INF

var _incline: Incline
var _friction: float
var _distance: float
var _speed: float
# How far it has turned when it begins to roll, in radians.
var _roll_turn := 0.0


## A disc of radius [constant MovingSurface.RADIUS] on [param incline], which has the
## friction µ, with its foot [param distance] pixels from the start of the line, and [param speed]
## px/s along it.
func _init(incline: Incline, friction: float, distance: float, speed: float) -> void:
	_incline = incline
	_friction = friction
	_distance = distance
	_speed = speed
	slip = incline.slip(MovingSurface.RADIUS, speed, 0.0)
	var whole := _run(Incline.LARGEST)
	if whole.leaves != InclineRun.End.NONE:
		leave_time = whole.time
	if whole.roll_time >= 0.0:
		roll_time = whole.roll_time
		var then := after(roll_time)
		roll_speed = then.speed
		_roll_turn = 0.5 * then.spin * roll_time
		run_case = Case.ROLLS if roll_time == 0.0 else Case.ROLLS_LATER
	elif incline.can_hold() and fading() > 0.0:
		run_case = Case.ENDS_BEFORE


## Whether it rolls at last.
func rolls() -> bool:
	return run_case in [Case.ROLLS, Case.ROLLS_LATER]


## How fast the slip becomes less, in px/s²: 3 µ N - G, or 3 µ N + G where it slips backwards.
func fading() -> float:
	return Friction.YIELD * grip() - signf(slip) * _incline.pull


## The acceleration while it slips, in px/s².
func slipping_acceleration() -> float:
	return _incline.pull - signf(slip) * grip()


## µ N, in px/s².
func grip() -> float:
	return _friction * _incline.pressure


## G: the part of gravity along the line, in px/s².
func pull() -> float:
	return _incline.pull


## N: the part of gravity that presses on the line, in px/s².
func pressure() -> float:
	return _incline.pressure


## The disc after so many seconds; from an end of the surface on it stays there.
func after(seconds: float) -> InclineRun:
	return _run(minf(seconds, leave_time))


## How far it has turned after so many seconds, in radians, clockwise on screen.
func turn_after(seconds: float) -> float:
	var now := after(seconds)
	if not rolls() or now.time < roll_time:
		return 0.5 * now.spin * now.time
	var then := after(roll_time)
	return _roll_turn + 0.5 * (then.spin + now.spin) * (now.time - roll_time)


func _run(seconds: float) -> InclineRun:
	return _incline.run(MovingSurface.RADIUS, _distance, _speed, 0.0, seconds)
