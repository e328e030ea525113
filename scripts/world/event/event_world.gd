class_name EventWorld
extends BounceLaws
## Balls among segments and walls, moved from event to event: what happens next is predicted once,
## by exact formulas, and stays true until something changes. Between events nothing is computed; a
## world costs by the bounce, not by the frame, and is as exact for one long step as for many short
## ones.
##
## Segments work from both sides and have round ends, their caps; balls collide with each other; one
## gravity and one bounciness hold for all. This file holds what a user of the world calls: putting
## things in, changing and removing them while time goes on, letting time pass. Predictions are made
## anew only for what a change touches. Where a ball is now is answered by [EventState], which holds
## all fields; [EventForecast] predicts, [BallSupport] and [BounceLaws] say what an event does. The
## page docs/event_world.md tells where each law is.
##
## What cannot be taken is refused: each such method returns "" or one sentence with the value and
## what is allowed, and then nothing has changed.

## Coordinates, speeds, sizes, masses and gravity stay within this, in pixels, seconds and their
## quotients.
const LARGEST := WorldLimits.LARGEST

# From this number of balls on, each looks for partners only around its own cell.
const _MANY_BALLS := 16


## Balls keep inside this upright box from now on: its corners at the upper left and lower right.
func set_walls(low: Vec2, high: Vec2) -> String:
	var problem := WorldLimits.problem_of_walls(low, high)
	if problem:
		return problem
	_contents += 1
	_has_walls = true
	_left_x = low.x
	_top_y = low.y
	_right_x = high.x
	_bottom_y = high.y
	_begin_anew()
	return ""


## Takes the walls away.
func remove_walls() -> void:
	_contents += 1
	_has_walls = false
	_begin_anew()


## Takes this gravity from now on, in px/s^2.
func set_gravity(gravity: Vec2) -> String:
	var problem := FreeFlight.problem_of_gravity(gravity, LARGEST)
	if problem:
		return problem
	_contents += 1
	_gravity_x = gravity.x
	_gravity_y = gravity.y
	_lasting_speed.fill(NAN)
	_begin_anew()
	return ""


## Takes this bounciness C from now on, 0..1, for all that bounces.
func set_bounciness(bounciness: float) -> String:
	var problem := Bounce.problem_of_bounciness(bounciness)
	if problem:
		return problem
	_bounciness = bounciness
	_contents += 1
	return ""


## How many places for segments there are, with those of removed ones.
func segment_count() -> int:
	return _segments.size()


## The segment at that place.
func segment(place: int) -> LineSegment:
	return _segments.segment(place)


## Takes copies of these segments in place of the old ones.
func set_segments(new_segments: Array[LineSegment]) -> String:
	for new_segment in new_segments:
		var problem := new_segment.problem(LARGEST)
		if problem:
			return problem
	_contents += 1
	_set_uses_grid(uses_grid)
	for place in new_segments.size():
		_segments.put(place, new_segments[place])
	_begin_anew()
	return ""


## Adds a segment; its place is the old [method segment_count].
func add_segment(new_segment: LineSegment) -> String:
	var problem := new_segment.problem(LARGEST)
	if not problem:
		_contents += 1
		_segments.put(_segments.size(), new_segment)
		_meet_new_segment(_segments.size() - 1)
	return problem


## Moves the segment at that place.
func move_segment(place: int, new_segment: LineSegment) -> String:
	var problem := WorldLimits.problem_of_place(place, _segments.has_segment(place), "segment")
	if not problem:
		problem = new_segment.problem(LARGEST)
	if not problem:
		_contents += 1
		_segments.put(place, new_segment)
		_lose_segment(place)
		_meet_new_segment(place)
	return problem


## Removes the segment at that place, which stays empty: the others keep their places.
func remove_segment(place: int) -> String:
	var problem := WorldLimits.problem_of_place(place, _segments.has_segment(place), "segment")
	if not problem:
		_contents += 1
		_segments.remove(place)
		_lose_segment(place)
	return problem


## Takes copies of these balls in place of the old ones. The time goes on.
func set_balls(new_balls: Array[Ball]) -> String:
	for new_ball in new_balls:
		var problem := new_ball.problem(LARGEST)
		if problem:
			return problem
	for index in ball_count():
		_is_there[index] = 0
	_resize_places(new_balls.size())
	for index in new_balls.size():
		_put_ball(index, new_balls[index])
	_lay_out_cells()
	_begin_anew()
	return ""


## Adds a ball; its place is the old [method ball_count].
func add_ball(new_ball: Ball) -> String:
	var problem := new_ball.problem(LARGEST)
	if not problem:
		_resize_places(ball_count() + 1)
		_put_ball(ball_count() - 1, new_ball)
		_join(ball_count() - 1)
	return problem


## Puts another ball in the place of one: elsewhere, faster, larger.
func change_ball(index: int, new_ball: Ball) -> String:
	var problem := WorldLimits.problem_of_place(index, has_ball(index), "ball")
	if not problem:
		problem = new_ball.problem(LARGEST)
	if not problem:
		_release_partner(index)
		_put_ball(index, new_ball)
		_join(index)
	return problem


## Removes the ball at that place, which stays empty: the others keep their places.
func remove_ball(index: int) -> String:
	var problem := WorldLimits.problem_of_place(index, has_ball(index), "ball")
	if not problem:
		_release_partner(index)
		_is_there[index] = 0
		_balls_there -= 1
		if _uses_cells:
			_cells.remove(index)
			_cross_time[index] = INF
		_set_event(index, INF, 0.0, LOOK_AGAIN, NOTHING)
	return problem


## Lets [param seconds] pass, 0 or more. Where there are more impacts than
## [member most_impacts_per_second] it returns a sentence, and the world stays at that moment.
func advance(seconds: float) -> String:
	# Kahan's sum: what the time loses by rounding is made up for by the next step.
	var step := seconds + _time_low
	var target := time + step
	# Nothing happens until then: most frames end here, so this is tested first.
	if target < _quiet_until:
		if seconds >= 0.0:
			_time_low = step - (target - time)
			time = target
			return ""
	return _advance_through_events(seconds)


## Lets time pass until [param target], in seconds since the start, which must not lie in the past.
func advance_to(target: float) -> String:
	if target < _quiet_until:
		if target >= time:
			time = target
			_time_low = 0.0
			return ""
	return _advance_to_event(target)


## When something happens next, in seconds; INF if nothing ever does. That may be an impact, or only
## that a ball has to look for others again.
func next_event_time() -> float:
	return _queue.first_time


## Lets time pass until the next impact, rest or sliding off has happened. Where there is none, or
## more than [member most_impacts_per_second], it says so.
func advance_to_next_event() -> String:
	var before := _log.events.size()
	var kept := keeps_events
	keeps_events = true
	var problem := ""
	while _log.events.size() == before and not problem:
		if _queue.first_time == INF:
			problem = "Nothing happens any more after %s s." % time
		else:
			problem = _advance_to(_queue.first_time, _queue.first_low)
	keeps_events = kept
	if not kept:
		_log.events.resize(before)
	return problem


## Everything that moves, as it is now.
func snapshot() -> WorldSnapshot:
	var kept := WorldSnapshot.new()
	kept.time = time
	kept.time_low = _time_low
	kept.impacts = impacts
	kept.contents = _contents
	kept.count_from = _count_from
	kept.counted_impacts = _counted_impacts
	kept.uses_cells = _uses_cells
	kept.cell_size = _cells.size
	kept.cell_columns = _cells.columns
	kept.keep(_all_arrays())
	kept.slides = _rolls.slides.duplicate()
	return kept


## Puts back what [method snapshot] has kept, to the last bit. Segments, walls, gravity and
## bounciness must be those of that time: else a sentence says so.
func restore(kept: WorldSnapshot) -> String:
	if kept.contents != _contents:
		return "The snapshot of %s s was taken among other segments, walls or pulls." % kept.time
	time = kept.time
	_time_low = kept.time_low
	impacts = kept.impacts
	_count_from = kept.count_from
	_counted_impacts = kept.counted_impacts
	_uses_cells = kept.uses_cells
	_cells.take_layout(kept.cell_size, kept.cell_columns)
	kept.put_into(_all_arrays())
	_rolls.slides = kept.slides.duplicate()
	_quiet_until = -INF
	_queue.resize(ball_count())
	_balls_there = _is_there.count(1)
	return ""


func _count_again() -> void:
	_quiet_until = -INF
	_count_from = time
	_counted_impacts = impacts


# All flights begin now, and everything is predicted anew.
func _begin_anew() -> void:
	_count_again()
	for index in ball_count():
		if _is_there[index] == 1:
			_restart(index)
			_set_free(index)
			_set_event(index, INF, 0.0, LOOK_AGAIN, NOTHING)
	for index in ball_count():
		if _is_there[index] == 1:
			_forecast(index)


func _resize_places(count: int) -> void:
	var old := ball_count()
	for numbers: PackedFloat64Array in _float_arrays():
		numbers.resize(count)
	for numbers: PackedInt32Array in _int_arrays():
		numbers.resize(count)
	_is_there.resize(count)
	_rolls.resize(count)
	_queue.resize(count)
	for index in range(old, count):
		_is_there[index] = 0
		_event_kind[index] = LOOK_AGAIN


func _put_ball(index: int, new_ball: Ball) -> void:
	_x[index] = new_ball.position.x
	_y[index] = new_ball.position.y
	_velocity_x[index] = new_ball.velocity.x
	_velocity_y[index] = new_ball.velocity.y
	_radius[index] = new_ball.radius
	_mass[index] = new_ball.mass
	_start[index] = time
	_start_low[index] = _time_low
	_set_free(index)
	_last_meeting[index] = -INF
	_lasting_speed[index] = NAN
	if _is_there[index] == 0:
		_is_there[index] = 1
		_balls_there += 1


# A ball that is new, or has been changed, is entered among the others.
func _join(index: int) -> void:
	_count_again()
	if _uses_cells != (_balls_there >= _MANY_BALLS) or 2.0 * _radius[index] > _cells.size:
		_lay_out_cells()
		_begin_anew()
		return
	if _uses_cells:
		_cells.make_room(ball_count())
		_cells.remove(index)
		_cells.put(index, _x[index], _y[index])
	_set_event(index, INF, 0.0, LOOK_AGAIN, NOTHING)
	_forecast(index)


func _lay_out_cells() -> void:
	_balls_there = _is_there.count(1)
	_uses_cells = _balls_there >= _MANY_BALLS
	if _uses_cells:
		_cells.lay_out(BallCells.size_for(positions(), _radius, _is_there), ball_count())
		for index in ball_count():
			if _is_there[index] == 1:
				_cells.put(index, position_x(index), position_y(index))


# Balls that touch the segment at that place next, or lie on it, begin a new flight.
func _lose_segment(place: int) -> void:
	_count_again()
	for index in ball_count():
		if _is_there[index] == 1 and place in [_touched[index], _support[index]]:
			_release_partner(index)
			_restart(index)
			_set_free(index)
			_set_event(index, INF, 0.0, LOOK_AGAIN, NOTHING)
			_forecast(index)


# Only balls that would meet the new segment before anything else begin a new flight.
func _meet_new_segment(place: int) -> void:
	_count_again()
	for index in ball_count():
		if _is_there[index] == 1 and _meets_first(index, place):
			_release_partner(index)
			_restart(index)
			_set_event(index, INF, 0.0, LOOK_AGAIN, NOTHING)
			_forecast(index)


func _meets_first(index: int, place: int) -> bool:
	var now := ball(index)
	var ends := _segments.segment(place)
	_accelerated.set_flight(
		now.position.x,
		now.position.y,
		now.velocity.x,
		now.velocity.y,
		_pull_x[index],
		_pull_y[index],
		now.radius
	)
	var horizon := _touch_time[index] - time
	return _accelerated.with_segment(ends.start.x, ends.start.y, ends.end.x, ends.end.y, horizon)


# Apart from [method advance], because a function with fewer variables is called faster.
func _advance_through_events(seconds: float) -> String:
	if not (seconds >= 0.0 and seconds <= LARGEST):
		return "The world can advance by 0 to 1e15 s, not by %s." % seconds
	var step := seconds + _time_low
	var target := time + step
	return _advance_to(target, step - (target - time))


func _advance_to_event(target: float) -> String:
	if not (target >= time and target <= LARGEST):
		return (
			"The world stands at %s s and can advance to at most 1e15 s, not to %s."
			% [time, target]
		)
	return _advance_to(target, 0.0)


func _advance_to(target: float, low: float) -> String:
	var queue := _queue
	var is_weightless := _gravity_x == 0.0 and _gravity_y == 0.0
	var may_hurry := is_weightless and not keeps_events and not _uses_cells
	while queue.first_time <= target:
		# An event within the last place of the target is still to come: if it happened now, a fast
		# ball would be seen beyond what it bounces off.
		if queue.first_time == target and queue.first_low > low:
			break
		time = queue.first_time
		_time_low = queue.first_low
		var index := queue.first
		if may_hurry and _event_kind[index] == TOUCH and _touched[index] < NOTHING:
			_bounce_off_wall_fast(index)
		else:
			_happen(index)
		if impacts - _counted_impacts > most_impacts_per_second:
			var problem := _problem_of_count()
			if problem:
				return problem
	time = target
	_time_low = low
	_quiet_until = _queue.first_time
	return ""


# A new second begins where the old one is over; within one there are too many.
func _problem_of_count() -> String:
	if time >= _count_from + 1.0:
		_count_again()
		return ""
	return (
		"There are more than %d impacts within a second at %s s: the world stops there."
		% [most_impacts_per_second, time]
	)


# All arrays that change while balls move, for snapshots.
func _all_arrays() -> Array:
	var arrays: Array = [_is_there, _queue.times, _queue.lows]
	arrays.append_array(_float_arrays())
	arrays.append_array(_int_arrays())
	arrays.append_array(_rolls.arrays())
	arrays.append_array(_cells.arrays())
	return arrays
