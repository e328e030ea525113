class_name BounceLaws
extends BallSupport
## What an event does to the balls: the law of each kind of contact. A ball meets a line (a wall, or
## a segment between its ends) in _bounce_off_line, the cap of a segment in _bounce_off_cap, another
## ball in _exchange. The first two share _reflect, the law of reflection.
##
## Two of the laws are written out once more for the commonest cases, right below the readable ones:
## _bounce_off_wall_fast and _bounce_off_segment_fast. Tests compare them to the last bit.

## Where nothing presses a ball on a surface it leaves with at least this share of its speed along
## the normal: then rounding cannot let it meet the same surface again at once.
const LEAST_SHARE := 1.0 / 2.0 ** 50
## A ball loses no speed in an impact if it has met another ball within this time before, in
## seconds. Otherwise impacts among three balls that lose speed, or two and a wall, could follow
## each other without end (the TC model of Luding and McNamara, How to Handle the Inelastic
## Collapse, 1998).
const PILE_UP := 1e-6
## A ball does not come to rest on another one: their bounces end in hops of this time, in seconds,
## in which no more speed is lost. At 500 px/s² such a hop is 0.006 px high.
const LEAST_HOP := 1e-2


# Lets the event of this ball happen, which comes first of all.
func _happen(index: int) -> void:
	if _uses_cells and _cross_time[index] < _event_time[index]:
		_cross(index)
		return
	var kind := _event_kind[index]
	if kind == TOUCH:
		_bounce(index)
		_forecast(index)
	elif kind == MEET:
		_collide(index, _event_with[index])
	elif kind == LOOK_AGAIN:
		_forecast_event(index)
	elif kind == SLIDE_OFF:
		_touched[index] = _slide_off(index)
		if _touched[index] != NOTHING:
			_touched_feature[index] = Impact.Feature.LINE
			_bounce(index)
		_forecast(index)
	elif kind == FOLLOW_CAP:
		_follow_cap(index)
		_forecast(index)


# A ball touches a wall or a segment.
func _bounce(index: int) -> void:
	impacts += 1
	_restart(index)
	var surface := _touched[index]
	if not keeps_events and _bounciness == 1.0 and surface >= 0 and _is_weightless():
		if _touched_feature[index] == Impact.Feature.LINE:
			_bounce_off_segment_fast(index, surface)
			return
	var event := _begin_event(index)
	_find_contact(index, surface)
	var approach := -(_velocity_x[index] * _normal_x + _velocity_y[index] * _normal_y)
	if surface == _left_surface[index] and _is_line(index, surface):
		# It comes back as fast as it left: no digit is lost from bounce to bounce.
		approach = _left_speed[index]
	_bounce_off(index, surface, maxf(approach, 0.0), event)


# A ball approaches a surface, whose normal must be known, with this speed along the normal.
func _bounce_off(index: int, surface: int, approach: float, event: WorldEvent) -> void:
	if _is_line(index, surface):
		_bounce_off_line(index, surface, approach, event)
	else:
		_bounce_off_cap(index, surface, approach, event)


# THE LAW FOR A LINE, a wall or a segment between its ends: the ball is reflected; it may come to
# rest there.
func _bounce_off_line(index: int, surface: int, approach: float, event: WorldEvent) -> void:
	var pressure := -(_gravity_x * _normal_x + _gravity_y * _normal_y)
	var speed := _reflect(index, surface, approach, pressure)
	_set_free(index)
	if pressure > 0.0 or _is_weightless():
		_left_surface[index] = surface
		_left_speed[index] = speed
	_end_event(index, surface, event)
	if not _is_weightless():
		_rest_if_over(index, surface, speed, pressure)


# THE LAW FOR A CAP, the round end of a segment: the ball is reflected as off a line through the
# point of contact; it may slide over the cap from there.
func _bounce_off_cap(index: int, place: int, approach: float, event: WorldEvent) -> void:
	var pressure := -(_gravity_x * _normal_x + _gravity_y * _normal_y)
	var speed := _reflect(index, place, approach, pressure)
	_set_free(index)
	if _is_weightless():
		_left_surface[index] = place
		_left_speed[index] = speed
	_end_event(index, place, event)
	if not _is_weightless() and _is_hop_over(index, speed, pressure):
		_roll(index, place, _touched_feature[index] as Impact.Feature)


# The law of reflection, v + (1 + C) |v.n| n, for a ball that approaches with |v.n|. Gives the speed
# along the normal with which the ball leaves.
func _reflect(index: int, surface: int, approach: float, pressure: float) -> float:
	var speed_squared := _squared_speed(index)
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
	if pressure <= 0.0:
		_lift(index, speed, speed_squared)
	return speed


# Where nothing presses the ball on the surface: see LEAST_SHARE.
func _lift(index: int, speed: float, speed_squared: float) -> void:
	var missing := LEAST_SHARE * sqrt(speed_squared) - speed
	if missing > 0.0:
		_velocity_x[index] += missing * _normal_x
		_velocity_y[index] += missing * _normal_y


# What _bounce_off_line does at the line of a segment for C = 1, without gravity and without events,
# written out: without it a ball among 64 segments takes 1.2 times as long, among four 1.5 times.
func _bounce_off_segment_fast(index: int, place: int) -> void:
	var normal_x := _segments.normal_x(place)
	var normal_y := _segments.normal_y(place)
	var x := _velocity_x[index]
	var y := _velocity_y[index]
	if is_nan(_lasting_speed[index]):
		_lasting_speed[index] = x * x + y * y
	var squared := _lasting_speed[index]
	# For this law it does not matter on which side of the line the ball is.
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


# What becomes of a ball in straight flight at a wall, and its next touch of a wall if nothing else
# is there, written out: a lone ball in a box does nothing else. With the readable steps it takes
# 1.5 times as long, and cut into two functions 1.1 times. Unlike _bounce_off_line this law puts
# the ball exactly where it touches the wall.
func _bounce_off_wall_fast(index: int) -> void:
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


# Two balls meet.
func _collide(one: int, other: int) -> void:
	impacts += 1
	_restart(one)
	_restart(other)
	var dx := _x[one] - _x[other]
	var dy := _y[one] - _y[other]
	var distance := sqrt(dx * dx + dy * dy)
	_normal_x = dx / distance if distance > 0.0 else 0.0
	_normal_y = dy / distance if distance > 0.0 else 0.0
	if keeps_events:
		_exchange_with_events(one, other)
	else:
		_exchange(one, other)
	_leave_support(one)
	_leave_support(other)
	_forecast(one)
	_forecast(other)


# Each of the two has an event of its own.
func _exchange_with_events(one: int, other: int) -> void:
	var event := _begin_event(one)
	var event_of_other := _begin_event(other)
	_exchange(one, other)
	_end_event(one, other, event, WorldEvent.Kind.BALL)
	_normal_x = -_normal_x
	_normal_y = -_normal_y
	_end_event(other, one, event_of_other, WorldEvent.Kind.BALL)


# THE LAW FOR TWO BALLS, Newton's laws along the normal as in BallBounce: momentum is kept, and they
# part with C times the speed of their approach.
func _exchange(one: int, other: int) -> void:
	var velocity_x := _velocity_x[one] - _velocity_x[other]
	var velocity_y := _velocity_y[one] - _velocity_y[other]
	var approach := -(velocity_x * _normal_x + velocity_y * _normal_y)
	var speed := _bounciness * approach
	if _is_pile_up(one) or _is_pile_up(other):
		speed = approach
	_last_meeting[one] = time
	_last_meeting[other] = time
	var pull_x := _pull_x[one] - _pull_x[other]
	var pull_y := _pull_y[one] - _pull_y[other]
	if pull_x != 0.0 or pull_y != 0.0:
		var around := velocity_x * _normal_y - velocity_y * _normal_x
		var outwards := around * around / (_radius[one] + _radius[other])
		var pressure := -(pull_x * _normal_x + pull_y * _normal_y) - outwards
		approach = maxf(approach, 0.0)
		speed = _hop_speed(speed, approach, pressure)
	if _bounciness < 1.0:
		# See LEAST_SHARE.
		var size := sqrt(_squared_speed(one)) + sqrt(_squared_speed(other))
		speed = maxf(speed, LEAST_SHARE * size)
	if not approach + speed > 0.0:
		return
	var share := (approach + speed) / (_mass[one] + _mass[other])
	_velocity_x[one] += share * _mass[other] * _normal_x
	_velocity_y[one] += share * _mass[other] * _normal_y
	_velocity_x[other] -= share * _mass[one] * _normal_x
	_velocity_y[other] -= share * _mass[one] * _normal_y
	_lasting_speed[one] = NAN
	_lasting_speed[other] = NAN


# The speed with which two balls part that a pull presses together: not so slow that the hop is
# shorter than LEAST_HOP, but no faster than the approach, unless there was almost none.
func _hop_speed(speed: float, approach: float, pressure: float) -> float:
	var least := 0.5 * pressure * LEAST_HOP
	if speed >= least:
		return speed
	return minf(approach, least) if approach > 1e-3 * least else least


# After the push of another ball: a ball that lay on something may be lifted off it, or driven into
# it.
func _leave_support(index: int) -> void:
	_left_surface[index] = NOTHING
	var surface := _support[index]
	if surface == NOTHING:
		return
	_touched_feature[index] = _rolled_end[index]
	_find_contact(index, surface)
	var speed := _velocity_x[index] * _normal_x + _velocity_y[index] * _normal_y
	var pressure := -(_gravity_x * _normal_x + _gravity_y * _normal_y)
	var is_slow := _bounciness < 1.0 and -speed <= 0.5 * pressure * LEAST_HOP
	if _is_line(index, surface) and (speed == 0.0 or (speed < 0.0 and is_slow)):
		# The line takes a push that is no stronger than a hop at once.
		_put_on(index, surface)
		return
	_set_free(index)
	if speed > 0.0 and _is_line(index, surface):
		_left_surface[index] = surface
		_left_speed[index] = speed
		return
	if speed <= 0.0:
		impacts += 1
		_bounce_off(index, surface, -speed, _begin_event(index))


# Whether a ball that touches this surface touches a straight line, and not a cap.
func _is_line(index: int, surface: int) -> bool:
	return surface < NOTHING or _touched_feature[index] == Impact.Feature.LINE


# The unit normal of what a ball touches, towards the ball.
func _find_contact(index: int, surface: int) -> void:
	if _is_line(index, surface):
		_find_normal(index, surface)
	else:
		_find_cap_normal(index, surface, _touched_feature[index] as Impact.Feature)


# Whether a ball has met another one so recently that it loses no speed now: see PILE_UP.
func _is_pile_up(index: int) -> bool:
	return time - _last_meeting[index] < PILE_UP
