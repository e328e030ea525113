class_name BallBounces
extends BallRolls
## What happens to a ball that touches a wall or a segment: it bounces, and may come to rest.

## Where nothing presses a ball on a line it leaves with at least this share of its speed along the
## normal, so that no rounding lets it meet the same line once more.
const LEAST_SHARE := 1.0 / 2.0 ** 50
## A ball loses no speed in an impact if it has met another one within this time before, in seconds:
## among three balls that lose speed, or two and a wall, impacts may pile up without end (the TC
## model of Luding and McNamara, How to Handle the Inelastic Collapse, 1998).
const PILE_UP := 1e-6

# The squared speed of a ball that no gravity pulls, from one elastic bounce to the next; NAN where
# it has changed.
var _lasting_speed: PackedFloat64Array = []
# When each ball has met another one last.
var _last_meeting: PackedFloat64Array = []


# A ball touches a wall or a segment.
func _bounce(index: int) -> void:
	impacts += 1
	_restart(index)
	var surface := _touched[index]
	if not keeps_events and _bounciness == 1.0 and surface >= 0 and _is_weightless():
		if _touched_feature[index] == Impact.Feature.LINE:
			_bounce_off_line(index, surface)
			return
	var event := _begin_event(index)
	_find_contact(index, surface)
	var approach := -(_velocity_x[index] * _normal_x + _velocity_y[index] * _normal_y)
	if surface == _left_surface[index] and _is_line(index, surface):
		# It comes back as fast as it left: no digit is lost from bounce to bounce.
		approach = _left_speed[index]
	_leave(index, surface, maxf(approach, 0.0), event)


# The short way for an elastic bounce off a line in straight flight: what [method _leave] does, with
# all calls written out.
func _bounce_off_line(index: int, place: int) -> void:
	var normal_x := _segments.normal_x(place)
	var normal_y := _segments.normal_y(place)
	var x := _velocity_x[index]
	var y := _velocity_y[index]
	if is_nan(_lasting_speed[index]):
		_lasting_speed[index] = x * x + y * y
	var squared := _lasting_speed[index]
	# Towards the line; from which side does not matter to the law of reflection.
	var change := -2.0 * (x * normal_x + y * normal_y)
	x += change * normal_x
	y += change * normal_y
	var now := x * x + y * y
	if now > 0.0:
		var factor := 1.0 + 0.5 * (squared - now) / now
		x *= factor
		y *= factor
	_velocity_x[index] = x
	_velocity_y[index] = y
	_left_surface[index] = place


# The short way for the commonest event, a ball in straight flight and a wall: what [method _bounce]
# and [method _forecast] do, with all calls written out, because a lone ball does nothing else. A
# test compares both ways.
func _bounce_off_wall(index: int) -> void:
	impacts += 1
	var flown := (time - _start[index]) + (_time_low - _start_low[index])
	var velocity_x := _velocity_x[index]
	var velocity_y := _velocity_y[index]
	var radius := _radius[index]
	var x := _x[index] + velocity_x * flown
	var y := _y[index] + velocity_y * flown
	var wall := _touched[index]
	if wall == LEFT_WALL:
		x = _left_x + radius
		velocity_x *= -_bounciness
	elif wall == RIGHT_WALL:
		x = _right_x - radius
		velocity_x *= -_bounciness
	elif wall == TOP_WALL:
		y = _top_y + radius
		velocity_y *= -_bounciness
	else:
		y = _bottom_y - radius
		velocity_y *= -_bounciness
	_x[index] = x
	_y[index] = y
	_velocity_x[index] = velocity_x
	_velocity_y[index] = velocity_y
	_start[index] = time
	_start_low[index] = _time_low
	if _balls_there > 1 or _segments.size() > 0:
		_left_surface[index] = NOTHING
		_forecast(index)
		return
	var seconds := INF
	if velocity_x > 0.0:
		seconds = (_right_x - radius - x) / velocity_x
		wall = RIGHT_WALL
	elif velocity_x < 0.0:
		seconds = (_left_x + radius - x) / velocity_x
		wall = LEFT_WALL
	if velocity_y > 0.0:
		var to_wall := (_bottom_y - radius - y) / velocity_y
		if to_wall < seconds:
			seconds = to_wall
			wall = BOTTOM_WALL
	elif velocity_y < 0.0:
		var to_wall := (_top_y + radius - y) / velocity_y
		if to_wall < seconds:
			seconds = to_wall
			wall = TOP_WALL
	if not seconds > 0.0 or seconds == INF:
		_forecast(index)
		return
	var sum := time + seconds
	var part := sum - time
	var low := (time - (sum - part)) + (seconds - part) + _time_low
	var event_time := sum + low
	low -= event_time - sum
	_touch_time[index] = event_time
	_touch_low[index] = low
	_touched[index] = wall
	_event_time[index] = event_time
	_event_low[index] = low
	_queue.change(index, event_time, low)


# Whether a ball that touches this surface touches a straight line, and not a round end.
func _is_line(index: int, surface: int) -> bool:
	return surface < NOTHING or _touched_feature[index] == Impact.Feature.LINE


# The unit normal of what a ball touches, towards the ball.
func _find_contact(index: int, surface: int) -> void:
	if _is_line(index, surface):
		_find_normal(index, surface)
		return
	_find_end_normal(index, surface, _touched_feature[index] as Impact.Feature)


# The law of reflection, v + (1 + C) |v.n| n, for a ball that approaches with |v.n|; and whether it
# comes to rest on the surface.
func _leave(index: int, surface: int, approach: float, event: WorldEvent) -> void:
	var speed_squared := _squared_speed(index)
	var is_line := _is_line(index, surface)
	var pressure := -(_gravity_x * _normal_x + _gravity_y * _normal_y)
	var speed := approach if _is_pile_up(index) else _bounciness * approach
	_velocity_x[index] += (approach + speed) * _normal_x
	_velocity_y[index] += (approach + speed) * _normal_y
	if _bounciness == 1.0 and surface >= 0 and _is_weightless():
		if is_nan(_lasting_speed[index]):
			_lasting_speed[index] = speed_squared
		_keep_speed(index, _lasting_speed[index])
	elif speed >= approach:
		_keep_speed(index, speed_squared)
	else:
		_lasting_speed[index] = NAN
	_set_free(index)
	if pressure > 0.0 and is_line or _is_weightless():
		_left_surface[index] = surface
		_left_speed[index] = speed
	if pressure <= 0.0:
		_lift(index, speed, speed_squared)
	_end_event(index, surface, event)
	if _is_weightless():
		return
	if is_line:
		_rest_if_over(index, surface, speed, pressure)
	elif _is_hop_over(index, speed, pressure):
		_roll(index, surface, _touched_feature[index] as Impact.Feature)


func _is_pile_up(index: int) -> bool:
	return time - _last_meeting[index] < PILE_UP


# A unit normal is rounded, always to the same side for the same line: scaled back to its length
# before, the velocity does not grow or shrink over a million bounces.
func _keep_speed(index: int, speed_squared: float) -> void:
	var now := _squared_speed(index)
	if now > 0.0:
		var factor := 1.0 + 0.5 * (speed_squared - now) / now
		_velocity_x[index] *= factor
		_velocity_y[index] *= factor


# Where nothing presses the ball on the surface.
func _lift(index: int, speed: float, speed_squared: float) -> void:
	var missing := LEAST_SHARE * sqrt(speed_squared) - speed
	if missing > 0.0:
		_velocity_x[index] += missing * _normal_x
		_velocity_y[index] += missing * _normal_y


func _float_arrays() -> Array[PackedFloat64Array]:
	return super() + ([_lasting_speed, _last_meeting] as Array[PackedFloat64Array])
