class_name BounceLaws
extends BallSupport
## What an event does to the balls: the law of each kind of contact. A ball meets a line (a wall, or
## a segment between its ends) in _bounce_off_line, the cap of a segment in _bounce_off_cap, another
## ball in _exchange. The first two share _reflect, the law of reflection. The laws of friction are
## in BallSpins.
##
## Some of the laws are written out once more for the commonest cases: _bounce_between_walls,
## _bounce_off_segment_fast and _collide_fast. Tests compare them to the last bit.


# Gravity, bounciness, friction, walls or segments may have been changed.
func _take_settings() -> void:
	_moves = _segments.has_motion()
	_takes_short_ways = _is_weightless() and _friction == 0.0 and not _moves
	_frame.set_up(_segments, Vec2.new(_gravity_x, _gravity_y))
	_counts_touches = _bounciness < 1.0 or _friction > 0.0 or _moves
	var strength := sqrt(_gravity_x * _gravity_x + _gravity_y * _gravity_y)
	_least_squared_speed = 2.0 * strength * REST_HEIGHT
	_piles.set_up(_gravity_x, _gravity_y, _bounciness)
	if _friction > 0.0:
		var gravity := Vec2.new(_gravity_x, _gravity_y)
		var low := Vec2.new(_left_x, _top_y)
		var high := Vec2.new(_right_x, _bottom_y)
		_spins.slopes.set_up(_segments, low, high, gravity, _friction)


# Lets the event of this ball happen, which comes first of all. What is no impact counts for the
# bound of impacts in a second, too, so that time always goes on.
func _happen(index: int) -> void:
	if _uses_cells and _cross_time[index] < _event_time[index]:
		if _gravity_x == 0.0 and _gravity_y == 0.0:
			_cross_fast(index)
		else:
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
	elif kind == CRUSH:
		_crush(index)
	else:
		_counted_impacts -= 1
		_go_on(index, kind)
		_forecast(index)


# What is no impact happens to a ball that something supports.
func _go_on(index: int, kind: int) -> void:
	var surface := _support[index]
	if kind == SUPPORT_TURNS:
		_go_on_from_here(index)
		_leave_support(index)
		return
	_enter_frame(index, surface)
	if kind == SLIDE_OFF:
		_touched[index] = _slide_off(index)
	elif kind == FOLLOW_CAP:
		_follow_cap(index)
	elif kind == END_SLIP:
		_end_slip(index)
	elif kind == TRY_AGAIN:
		_restart(index)
		if not _settle(index):
			_set_free(index)
	_leave_frame(index)
	if kind == SLIDE_OFF and _touched[index] != NOTHING:
		_touched_feature[index] = Impact.Feature.LINE
		_bounce(index)


func _bounce(index: int) -> void:
	impacts += 1
	var surface := _touched[index]
	if _counts_touches:
		# A touch that follows too many hurried ones counts as one of a pile-up. What can hardly rise
		# any more stands still for a moment, so that gravity can take it out.
		if _piles.is_hurried(index, surface, time - _start[index]):
			_last_meeting[index] = time
			if _can_hardly_rise(index):
				_velocity_x[index] = 0.0
				_velocity_y[index] = 0.0
	_restart(index)
	if _takes_short_ways and not keeps_events and _bounciness == 1.0 and surface >= 0:
		if _touched_feature[index] == Impact.Feature.LINE:
			_bounce_off_segment_fast(index, surface)
			return
	if _moves and not _really_touches(index, surface):
		return
	var event := _begin_event(index)
	if _takes_short_ways and surface < NOTHING:
		_bounce_off_wall(index, surface, event)
		return
	_find_contact(index, surface)
	_enter_frame(index, surface)
	var approach := -(_velocity_x[index] * _normal_x + _velocity_y[index] * _normal_y)
	var has_left_line := _left_feature[index] == Impact.Feature.LINE
	if surface == _left_surface[index] and has_left_line and _is_line(index, surface):
		# It comes back as fast as it left: no digit is lost from bounce to bounce.
		approach = _left_speed[index]
	_bounce_off(index, surface, maxf(approach, 0.0), event)
	_leave_frame(index)
	if _piles.slow_speed > 0.0:
		_piles.count_touch(index, time)
		_calm(index)


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
	if not _is_weightless() and _frame.can_rest:
		_rest_if_over(index, surface, speed, pressure)


# THE LAW FOR A WALL where there is no gravity and no friction: the ball is put exactly where it
# touches the wall, and one of its two velocities turns round. So the other one loses nothing by
# rounding.
func _bounce_off_wall(index: int, wall: int, event: WorldEvent) -> void:
	_find_normal(index, wall)
	_move_to_wall(index, wall)
	var share := 1.0 if _is_pile_up(index) else _bounciness
	if wall == LEFT_WALL or wall == RIGHT_WALL:
		_velocity_x[index] *= -share
	else:
		_velocity_y[index] *= -share
	_set_free(index)
	_end_event(index, wall, event)


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
	if _is_weightless() or not _frame.can_rest:
		return
	if _is_held_by_two(index):
		_lie_still(index, place)
	elif _is_hop_over(index, speed, pressure):
		_roll(index, place, _touched_feature[index] as Impact.Feature)


# The law of reflection, v + (1 + C) |v.n| n, for a ball that approaches with |v.n|. Gives the speed
# along the normal with which the ball leaves.
func _reflect(index: int, surface: int, approach: float, pressure: float) -> float:
	var speed_squared := _squared_speed(index)
	var speed := approach if _is_pile_up(index) else _bounciness * approach
	speed = maxf(speed, _frame.least_speed)
	_velocity_x[index] += (approach + speed) * _normal_x
	_velocity_y[index] += (approach + speed) * _normal_y
	if not _frame.can_rest:  # A hop may be faster than the approach.
		_lasting_speed[index] = NAN
	elif _bounciness == 1.0 and surface >= 0 and _is_weightless():
		if is_nan(_lasting_speed[index]):
			_lasting_speed[index] = speed_squared
		_keep_speed(index, _lasting_speed[index])
	elif speed >= approach:
		_keep_speed(index, speed_squared)
	else:
		_lasting_speed[index] = NAN
	var missing := BallPiles.LEAST_SHARE * sqrt(speed_squared) - speed
	if pressure <= 0.0 and missing > 0.0:
		_velocity_x[index] += missing * _normal_x
		_velocity_y[index] += missing * _normal_y
	if _friction > 0.0 and not _is_pile_up(index):
		_rub(index, approach + speed)
	return speed


# What _bounce_off_line does at the line of a segment for C = 1, without gravity, friction and
# events, written out: without it a ball among 64 segments takes 1.2 times as long, among four 1.5.
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


# All bounces until the target of a ball that is alone between walls: what _bounce_off_wall and
# _forecast do again and again, written out, with all numbers in local variables.
func _bounce_between_walls(index: int, target: float, target_low: float) -> void:
	var radius := _radius[index]
	var left := _left_x + radius
	var right := _right_x - radius
	var top := _top_y + radius
	var bottom := _bottom_y - radius
	var x := _x[index]
	var y := _y[index]
	var velocity_x := _velocity_x[index]
	var velocity_y := _velocity_y[index]
	var start := _start[index]
	var start_low := _start_low[index]
	var wall := _touched[index]
	var event_time := time
	var event_low := _time_low
	var seconds := 0.0
	# The one with which there are too many is the last.
	var last := _counted_impacts + most_impacts_per_second + 1
	while true:
		impacts += 1
		var flown := (event_time - start) + (event_low - start_low)
		start = event_time
		start_low = event_low
		if wall <= RIGHT_WALL:
			x = left if wall == LEFT_WALL else right
			y += velocity_y * flown
			velocity_x *= -_bounciness
		else:
			x += velocity_x * flown
			y = top if wall == TOP_WALL else bottom
			velocity_y *= -_bounciness
		seconds = INF
		if velocity_x > 0.0:
			seconds = (right - x) / velocity_x
			wall = RIGHT_WALL
		elif velocity_x < 0.0:
			seconds = (left - x) / velocity_x
			wall = LEFT_WALL
		var up_or_down := INF
		if velocity_y > 0.0:
			up_or_down = (bottom - y) / velocity_y
		elif velocity_y < 0.0:
			up_or_down = (top - y) / velocity_y
		if up_or_down < seconds:
			seconds = up_or_down
			wall = BOTTOM_WALL if velocity_y > 0.0 else TOP_WALL
		if not seconds > 0.0 or seconds == INF:
			break
		var sum := start + seconds
		var part := sum - start
		var low := (start - (sum - part)) + (seconds - part) + start_low
		event_time = sum + low
		event_low = low - (event_time - sum)
		if event_time >= target and (event_time > target or event_low > target_low):
			break
		if impacts >= last:
			break
	_x[index] = x
	_y[index] = y
	_velocity_x[index] = velocity_x
	_velocity_y[index] = velocity_y
	time = start
	_time_low = start_low
	_start[index] = start
	_start_low[index] = start_low
	if not seconds > 0.0 or seconds == INF:
		_forecast(index)
		return
	_touch_time[index] = event_time
	_touch_low[index] = event_low
	_touched[index] = wall
	_event_time[index] = event_time
	_event_low[index] = event_low
	_queue.change(index, event_time, event_low)


func _collide(one: int, other: int) -> void:
	if _takes_short_ways and _uses_cells and _bounciness == 1.0 and not keeps_events:
		_collide_fast(one, other)
	else:
		_collide_by_laws(one, other)


func _collide_by_laws(one: int, other: int) -> void:
	impacts += 1
	_restart(one)
	_restart(other)
	var dx := _x[one] - _x[other]
	var dy := _y[one] - _y[other]
	var distance := sqrt(dx * dx + dy * dy)
	_normal_x = dx / distance if distance > 0.0 else 0.0
	_normal_y = dy / distance if distance > 0.0 else 0.0
	if _piles.slow_speed > 0.0:
		_collide_in_pile(one, other, distance)
	else:
		_push(one, other)
	_forecast(one)
	_forecast(other)


# What _collide_by_laws does for two balls of a crowd, for C = 1, without gravity, friction and
# events, written out.
func _collide_fast(one: int, other: int) -> void:
	impacts += 1
	_cells.push_apart(one, other, time, _time_low)
	_forecast(one)
	_forecast(other)


func _push(one: int, other: int) -> void:
	if keeps_events:
		_exchange_with_events(one, other)
	else:
		_exchange(one, other)
	_leave_support(one)
	_leave_support(other)


# What BallPiles says: a ball that lies takes a slow push; balls that are pressed on each other may
# come to lie.
func _collide_in_pile(one: int, other: int, distance: float) -> void:
	var pull_x := _pull_x[one] - _pull_x[other]
	var pull_y := _pull_y[one] - _pull_y[other]
	var is_pressed := pull_x * _normal_x + pull_y * _normal_y < 0.0
	_piles.note_meeting(one, other, distance, is_pressed, time)
	if not (_is_borne(one, other, 1.0) or _is_borne(other, one, -1.0)):
		var woken := _wake(one)
		woken.append_array(_wake(other))
		_push(one, other)
		for index in woken:
			_forecast(index)
	for index: int in [one, other]:
		_calm(index)
		if is_pressed:
			_settle(index)


# Whether the other ball lies and takes the push of this one. Side is -1 for the opposite normal.
func _is_borne(index: int, lying: int, side: float) -> bool:
	if not _piles.takes_push(lying, index, side * _normal_x, side * _normal_y):
		return false
	_normal_x *= side
	_normal_y *= side
	var event := _begin_event(index)
	var pressure := -(_pull_x[index] * _normal_x + _pull_y[index] * _normal_y)
	var part := sqrt(_mass[lying] / (_mass[lying] + _mass[index]))
	_rub(index, _piles.hop_off(index, _normal_x, _normal_y, pressure, part))
	_last_meeting[index] = time
	_end_event(index, lying, event, WorldEvent.Kind.BALL)
	_leave_support(index)
	return true


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
	var is_pile_up := _is_pile_up(one) or _is_pile_up(other)
	if is_pile_up:
		speed = approach
	_last_meeting[one] = time
	_last_meeting[other] = time
	var pull_x := _pull_x[one] - _pull_x[other]
	var pull_y := _pull_y[one] - _pull_y[other]
	if pull_x != 0.0 or pull_y != 0.0:
		var around := velocity_x * _normal_y - velocity_y * _normal_x
		var pressure := -(pull_x * _normal_x + pull_y * _normal_y)
		pressure -= around * around / (_radius[one] + _radius[other])
		approach = maxf(approach, 0.0)
		speed = _piles.hop_speed(speed, approach, pressure)
	if _bounciness < 1.0:
		# See LEAST_SHARE.
		var size := sqrt(_squared_speed(one)) + sqrt(_squared_speed(other))
		speed = maxf(speed, BallPiles.LEAST_SHARE * size)
	if not approach + speed > 0.0:
		return
	var share := (approach + speed) / (_mass[one] + _mass[other])
	_velocity_x[one] += share * _mass[other] * _normal_x
	_velocity_y[one] += share * _mass[other] * _normal_y
	_velocity_x[other] -= share * _mass[one] * _normal_x
	_velocity_y[other] -= share * _mass[one] * _normal_y
	if _friction > 0.0 and not is_pile_up:
		_spins.rub_balls(one, other, _normal_x, _normal_y, approach + speed)
	_lasting_speed[one] = NAN
	_lasting_speed[other] = NAN


# After the push of another ball: a ball that lay on something may be lifted off it, or driven into
# it.
func _leave_support(index: int) -> void:
	_left_surface[index] = NOTHING
	var surface := _support[index]
	if surface == NOTHING or surface <= ON_BALLS:
		return
	_touched_feature[index] = _rolled_end[index]
	if surface >= 0 and _rolled_end[index] == Impact.Feature.LINE:
		_touched_feature[index] = _segments.nearest_feature(surface, _x[index], _y[index])
	_find_contact(index, surface)
	_enter_frame(index, surface)
	_take_push(index, surface)
	_leave_frame(index)


# A ball that lay on this surface, whose normal must be known, has got another velocity.
func _take_push(index: int, surface: int) -> void:
	var speed := _velocity_x[index] * _normal_x + _velocity_y[index] * _normal_y
	var pressure := -(_gravity_x * _normal_x + _gravity_y * _normal_y)
	var is_slow := _bounciness < 1.0 and -speed <= 0.5 * pressure * BallPiles.LEAST_HOP
	if _is_line(index, surface) and (speed == 0.0 or (speed < 0.0 and is_slow)):
		# The line takes a push that is no stronger than a hop at once.
		_rub(index, -speed)
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


# Where lines move: whether a ball that was foreseen to touch this surface does so. It may have to
# look again only.
func _really_touches(index: int, surface: int) -> bool:
	if surface == NOTHING or _is_weightless():
		_left_surface[index] = NOTHING
	if surface == NOTHING:
		impacts -= 1
		return false
	for one in _wake(index):
		_forecast(one)
	var squeeze := _segments.squeeze_of(ball(index), _piles.is_hurried_now(index))
	if squeeze == SegmentScan.Squeeze.SHAKEN:
		_frame.shake()
	elif squeeze == SegmentScan.Squeeze.CRUSHED:
		_hold(index, surface)
	return squeeze != SegmentScan.Squeeze.CRUSHED


# What is around a ball, which touches this surface, crushes it after a while, or now.
func _hold(index: int, surface: int) -> void:
	_set_free(index)
	_lie_on(index, CRUSHED)
	_velocity_x[index] = _segments.crush_velocity.x
	_velocity_y[index] = _segments.crush_velocity.y
	_left_surface[index] = surface
	_piles.lie_until(index, time + _segments.crush_seconds)


# A ball that is crushed is out of the world, and stays where it is.
func _crush(index: int) -> void:
	_restart(index)
	var surface := _left_surface[index]
	_find_contact(index, surface)
	_end_event(index, surface, _begin_event(index), WorldEvent.Kind.CRUSHED)
	_take_out(index)


# The unit normal of what a ball touches, towards the ball.
func _find_contact(index: int, surface: int) -> void:
	if _is_line(index, surface):
		_find_normal(index, surface)
	else:
		_find_cap_normal(index, surface, _touched_feature[index] as Impact.Feature)
