class_name CapSlide
extends RefCounted
## A ball that slides without friction over the round end of a line. Its centre moves on a circle
## about the end, and only gravity holds it there, until it leaves the circle or until it is back
## where it started. Times are in seconds.
##
## The ball is a point mass at its centre. Let a be the angle from the top (against gravity), R the
## radius of the circle, and k = g / R. Energy gives the angular speed:
## w² = w0² + 2 k (cos a0 - cos a). The cap can push but not pull, so the ball leaves it where
## w² = k cos a, that is where cos a = (w0² / k + 2 cos a0) / 3.
## [br][br]
## The time between two angles is an elliptic integral. With u = sin²(a / 2), and s = u + c the
## squared angular speed over 4 k, it is the integral of 1 / sqrt(u (1 - u) (u + c)) over u, divided
## by 2 sqrt(k). It is finite also where the ball starts from rest; [CarlsonIntegral] computes it.

## How the sliding ends. LEAVES: the ball flies off. RETURNS: it stops on its way up and is back at
## the start with the reversed velocity. NEVER: it stays on the cap for ever, at rest at the top or
## on its way to it.
enum Ending { LEAVES, RETURNS, NEVER }

const _EPSILON := 1.0 / 2.0 ** 52

# A ball on its way up that the cap pushes no less than this stays on it, as a share of gravity: it
# becomes slower at once, and is pressed on the cap then.
const _LEAST_PUSH := -1e-12

const _MOST_STEPS := 100

## How the sliding ends.
var ending := Ending.NEVER
## Seconds until then; INF for [constant Ending.NEVER].
var end_time := INF

## In which direction the ball starts round the end: 1.0 from x towards y, else -1.0. The angles are
## counted in this direction.
var turn := 1.0
## x of the centre at the time given to [method move_to], in pixels.
var position_x := 0.0
## y of the centre then.
var position_y := 0.0
## x of the velocity then, in px/s.
var velocity_x := 0.0
## y of the velocity then.
var velocity_y := 0.0

var _cx := 0.0
var _cy := 0.0
var _radius := 0.0
# The unit vector against gravity.
var _up_x := 0.0
var _up_y := 0.0
# g / R, and the start: the angle from the top, and the angular speed, which is 0 or more.
var _k := 0.0
var _start := 0.0
var _speed := 0.0
# The angle at which the ball is slowest (the start, the top, or where it stops), and its squared
# angular speed there. Counted from there, the energy loses no digits.
var _slowest := 0.0
var _least_squared_speed := 0.0
# The angle at which the ball leaves or stops, or which it never reaches; and the time it takes.
var _last := 0.0
var _last_time := INF
# sin²(_last / 2) - sin²(_start / 2). Computing it from the two angles would lose digits.
var _last_difference := 0.0


## Starts again: the centre is at (px, py), on a circle about the end (cx, cy), and has the velocity
## (vx, vy) under the gravity (gx, gy). Only the part of the velocity along the circle counts.
## Returns "", or a sentence if the centre is on the end itself; then nothing has changed.
func start(
	cx: float, cy: float, px: float, py: float, vx: float, vy: float, gx: float, gy: float
) -> String:
	var away := Vec2.new(px - cx, py - cy)
	if away.length() == 0.0:
		return "CapSlide.start: the centre must not be on the end itself, (%s, %s)." % [cx, cy]
	_cx = cx
	_cy = cy
	_radius = away.length()
	var gravity := Vec2.new(gx, gy)
	_k = gravity.length() / _radius
	var up := gravity.negated() if _k > 0.0 else away.copy()
	up.normalize()
	_up_x = up.x
	_up_y = up.y
	_start = up.angle_to(away)
	_speed = away.cross(Vec2.new(vx, vy)) / _radius / _radius
	turn = -1.0 if _speed < 0.0 or (_speed == 0.0 and _start < 0.0) else 1.0
	_start *= turn
	_speed = absf(_speed)
	_find_end()
	return ""


## Sets position and velocity to those [param seconds] after the start. Values outside 0 to
## [member end_time] are clamped.
func move_to(seconds: float) -> void:
	var at := clampf(seconds, 0.0, end_time)
	# On the way back the ball is where it was the same time before the stop.
	var is_back := ending == Ending.RETURNS and at > _last_time
	var angle := _angle_at(end_time - at if is_back else at)
	var angular_speed := _speed_at(angle) * (-1.0 if is_back else 1.0)
	_place(angle * turn, angular_speed * turn)


## The first time at which the centre is in the direction (x, y) from the end; INF if the sliding
## ends before.
func time_to_direction(x: float, y: float) -> float:
	var angle := Vec2.new(_up_x, _up_y).angle_to(Vec2.new(x, y)) * turn
	if angle < _start or angle > _last or end_time == 0.0:
		return 0.0 if angle == _start else INF
	return _time_to(angle)


func _find_end() -> void:
	ending = Ending.LEAVES
	end_time = 0.0
	_last = _start
	_last_time = 0.0
	var squared_speed := _speed * _speed
	_slowest = _start
	_least_squared_speed = squared_speed
	# How hard the cap pushes: the force per unit of mass and of radius.
	var pressure := _k * cos(_start) - squared_speed
	var is_climbing := _start < 0.0 and _speed > 0.0
	if pressure < (_LEAST_PUSH * _k if is_climbing else 0.0):
		return
	if pressure == 0.0 and not is_climbing and _k > 0.0:
		return
	# At rest where nothing pulls along the circle.
	if _speed == 0.0 and (_k == 0.0 or _start == 0.0):
		_stay_for_ever()
		return
	var sine := sin(0.5 * _start)
	var over_top := squared_speed - 4.0 * _k * sine * sine
	if is_climbing and over_top <= 0.0:
		_stop_uphill(-over_top / (4.0 * _k))
		return
	if is_climbing:
		_slowest = 0.0
		_least_squared_speed = over_top
	_last = 2.0 * asin(sqrt(clampf((1.0 - over_top / _k) / 6.0, 0.0, 1.0)))
	_last_difference = pressure / (6.0 * _k)
	_last_time = _time_to(_last)
	end_time = _last_time


func _stay_for_ever() -> void:
	ending = Ending.NEVER
	end_time = INF
	_last_time = INF


# `squared_sine` is sin² of half the angle at which the ball stops; 0 is the top, which it never
# reaches.
func _stop_uphill(squared_sine: float) -> void:
	_last = -2.0 * asin(sqrt(squared_sine))
	_slowest = _last
	_least_squared_speed = 0.0
	if squared_sine == 0.0:
		_stay_for_ever()
		return
	ending = Ending.RETURNS
	_last_difference = -_speed * _speed / (4.0 * _k)
	_last_time = _time_to(_last)
	end_time = 2.0 * _last_time


# Seconds from the start to an angle on the way to the last angle.
func _time_to(angle: float) -> float:
	if _start >= 0.0 or angle <= 0.0:
		return _time_between(_start, angle)
	return _time_between(_start, 0.0) + _time_between(0.0, angle)


# The same for two angles on the same side of the top.
func _time_between(from: float, to: float) -> float:
	var difference := sin(0.5 * (to - from)) * sin(0.5 * (to + from))
	if from == _start and to == _last:
		difference = _last_difference
	if difference == 0.0:
		return 0.0
	# The square roots of u, 1 - u and u + c at both angles, with u = sin²(a / 2) as at the top.
	var u_from := absf(sin(0.5 * from))
	var u_to := absf(sin(0.5 * to))
	var rest_from := cos(0.5 * from)
	var rest_to := cos(0.5 * to)
	var s_from := 0.5 * _speed_at(from) / sqrt(_k)
	var s_to := 0.5 * _speed_at(to) / sqrt(_k)
	var one := (u_to * rest_to * s_from + u_from * rest_from * s_to) / difference
	var two := (u_to * s_to * rest_from + u_from * s_from * rest_to) / difference
	var three := (rest_to * s_to * u_from + rest_from * s_from * u_to) / difference
	return CarlsonIntegral.first_kind(one * one, two * two, three * three) / sqrt(_k)


# The angular speed at an angle, from the energy.
func _speed_at(angle: float) -> float:
	if angle == _start:
		return _speed
	var fallen := sin(0.5 * (angle - _slowest)) * sin(0.5 * (angle + _slowest))
	return sqrt(_least_squared_speed + 4.0 * _k * maxf(fallen, 0.0))


# The angle at a time up to `_last_time`, by Newton's method between two bounds.
func _angle_at(seconds: float) -> float:
	if seconds <= 0.0 or (ending == Ending.NEVER and _speed == 0.0):
		return _start
	if seconds >= _last_time:
		return _last
	var low := _start
	var high := _last
	var angle := _start + seconds * (_speed + 0.5 * seconds * _k * sin(_start))
	for _count in _MOST_STEPS:
		if not (angle > low and angle < high):
			angle = 0.5 * (low + high)
		var late := _time_to(angle) - seconds
		if late > 0.0:
			high = angle
		else:
			low = angle
		angle -= late * _speed_at(angle)
		if absf(late) <= 2.0 * _EPSILON * seconds:
			break
	return clampf(angle, _start, _last)


func _place(angle: float, angular_speed: float) -> void:
	var across := sin(angle)
	var upwards := cos(angle)
	var x := upwards * _up_x - across * _up_y
	var y := upwards * _up_y + across * _up_x
	position_x = _cx + _radius * x
	position_y = _cy + _radius * y
	velocity_x = -_radius * angular_speed * y
	velocity_y = _radius * angular_speed * x
