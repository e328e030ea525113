class_name EventCourse
extends BallImpacts
## How time passes: events happen one after the other, the earliest one first, and after a change
## from outside everything begins anew.

# From this number of balls on, each looks for partners only around its own cell.
const _MANY_BALLS := 16


# Apart from [method advance], because a function with fewer variables is called faster.
func _advance_through_events(seconds: float) -> String:
	if not (seconds >= 0.0 and seconds <= WorldLimits.LARGEST):
		return "The world can advance by 0 to 1e15 s, not by %s." % seconds
	if _has_changed:
		_begin_anew()
	var step := seconds + _time_low
	var target := time + step
	return _advance_to(target, step - (target - time))


# Where an event comes first, or the flight of a lone ball is not noted.
func _go_to_moment(target: float) -> void:
	# Nothing happens until then: most frames of a few balls end here.
	if target < _quiet_until and target >= time:
		time = target
		_time_low = 0.0
	else:
		var problem := _advance_to_event(target)
		if problem:
			Refusal.push(problem)
	if _x.size() == 1 and _pull_x[0] == 0.0 and _pull_y[0] == 0.0:
		_note_lone_flight()
	else:
		_write_places(_places)


# See EventWorld.moment.
func _note_lone_flight() -> void:
	_lone_until = _quiet_until
	_lone_start = _start[0]
	_lone_start_low = _start_low[0]
	_lone_x = _x[0]
	_lone_y = _y[0]
	_lone_velocity_x = _velocity_x[0]
	_lone_velocity_y = _velocity_y[0]
	var seconds := (time - _lone_start) + (_time_low - _lone_start_low)
	_places[0] = _lone_x + _lone_velocity_x * seconds
	_places[1] = _lone_y + _lone_velocity_y * seconds


func _advance_to_event(target: float) -> String:
	if not (target >= time and target <= WorldLimits.LARGEST):
		return (
			"The world stands at %s s and can advance to at most 1e15 s, not to %s."
			% [time, target]
		)
	if _has_changed:
		_begin_anew()
	return _advance_to(target, 0.0)


# Lets all events happen until this time. "" or a sentence, where there are too many impacts: then
# the world stays at that moment.
func _advance_to(target: float, low: float) -> String:
	var queue := _queue
	while queue.first_time <= target:
		# An event within the last place of the target is still to come: if it happened now, a fast
		# ball would be seen beyond what it bounces off.
		if queue.first_time == target and queue.first_low > low:
			break
		time = queue.first_time
		_time_low = queue.first_low
		var index := queue.first
		if _is_alone and not keeps_events and _event_kind[index] == TOUCH:
			_bounce_between_walls(index, target, low)
		else:
			_happen(index)
		if impacts - _counted_impacts > most_impacts_per_second:
			var problem := _problem_of_count()
			if problem:
				return problem
	time = target
	_time_low = low
	_quiet_until = queue.first_time
	return ""


# A new second begins where the old one is over; within one there are too many.
func _problem_of_count() -> String:
	if time >= _count_from + 1.0:
		_count_again()
		return ""
	var values := [most_impacts_per_second, time]
	return "There are more than %d impacts within a second at %s s: the world stops there." % values


func _count_again() -> void:
	_quiet_until = -INF
	_lone_until = -INF
	_count_from = time
	_counted_impacts = impacts


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
	elif kind == SLIDE_OFF:
		_counted_impacts -= 1
		_touched[index] = _slide_off(index)
		if _touched[index] != NOTHING:
			_touched_feature[index] = Impact.Feature.LINE
			_bounce(index)
		_forecast(index)
	elif kind == FOLLOW_CAP:
		_counted_impacts -= 1
		_follow_cap(index)
		_forecast(index)
	elif kind == TRY_AGAIN:
		_counted_impacts -= 1
		_restart(index)
		if not _settle(index):
			_set_free(index)
		_forecast(index)


# All flights begin now, from places and velocities alone, as in a world that is built now.
func _begin_anew() -> void:
	_has_changed = false
	_piles.set_up(_gravity_x, _gravity_y, _bounciness)
	_count_again()
	for index in ball_count():
		if _is_there[index] == 1:
			_restart(index)
			_set_free(index)
			_last_meeting[index] = -INF
			_piles.forget(index, time)
			_lasting_speed[index] = NAN
	_lay_out_cells()
	_is_alone = _balls_there == 1 and _segments.size() == 0 and _is_weightless()
	for index in ball_count():
		_set_event(index, INF, 0.0, LOOK_AGAIN, NOTHING)
	for index in ball_count():
		if _is_there[index] == 1:
			_forecast(index)


func _lay_out_cells() -> void:
	_balls_there = _is_there.count(1)
	_uses_cells = _balls_there >= _MANY_BALLS
	_cross_time.fill(INF)
	if _uses_cells:
		var size := BallCells.size_for(positions(), _radius, _is_there)
		# Removed balls count for nothing: the world is as one without them.
		_cells.lay_out(size, _balls_there)
		_cells.make_room(ball_count())
		for index in ball_count():
			if _is_there[index] == 1:
				_cells.put(index, _x[index], _y[index])
