class_name RacingBall
extends RefCounted
## A ball on the line of the lesson, by [Incline]: where it is after some seconds, how fast, and how
## far it has turned.

## Seconds until it is at the end of the line; INF where nothing moves it.
var end_time := INF
## Its speed there, in pixels per second.
var end_speed := 0.0
## When it began to roll, in seconds; -1 where it slips all the way.
var roll_time := -1.0

var _incline: Incline
var _radius: float
var _speed: float
var _spin: float
# Where and how far it had turned when it began to roll.
var _roll_distance := 0.0
var _roll_turn := 0.0


## A ball of radius [param radius] at the start of the line, with [param speed] px/s along it and
## [param spin] radians per second.
func _init(incline: Incline, radius: float, speed: float, spin: float) -> void:
	_incline = incline
	_radius = radius
	_speed = speed
	_spin = spin
	var run := after(Incline.LARGEST)
	roll_time = run.roll_time
	if run.leaves == InclineRun.End.END:
		end_time = run.time
		end_speed = run.speed
	if roll_time > 0.0:
		var change := after(roll_time)
		_roll_distance = change.distance
		_roll_turn = 0.5 * (_spin + change.spin) * roll_time


## The ball after [param seconds]; from its end on it stays there.
func after(seconds: float) -> InclineRun:
	return _incline.run(_radius, 0.0, _speed, _spin, minf(seconds, end_time))


## How far it has turned after [param seconds], in radians, clockwise on screen.
func turn_after(seconds: float) -> float:
	var run := after(seconds)
	if roll_time < 0.0 or run.time < roll_time:
		return 0.5 * (_spin + run.spin) * run.time
	return _roll_turn + _incline.side * (run.distance - _roll_distance) / _radius
