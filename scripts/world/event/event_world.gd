class_name EventWorld
extends WorldContents
## Balls among segments and walls, moved from event to event: what happens next is predicted once,
## by exact formulas, and stays true until something changes. Between events nothing is computed; a
## world costs by the bounce, not by the frame, and is as exact for one long step as for many short
## ones.
##
## Segments work from both sides and have round ends; balls collide with each other; one gravity and
## one bounciness hold for all. How to put things in and take them out stands in [WorldContents],
## the balls' flights and forecasts in [BallFlights], [TouchForecast] and [PartnerForecast], what an
## event does in [BallEvents].

## More impacts than this within one second of the world are refused by [method advance]: between
## two walls that touch a ball on both sides they would go on for ever. At least 1.
var most_impacts_per_second := 1_000_000


## Lets so many seconds pass, 0 or more. Where there are more impacts than
## [member most_impacts_per_second] it returns a sentence, and the world stays at that moment.
func advance(seconds: float) -> String:
	# Kahan's sum: what the time loses by rounding is made up for by the next step.
	var step := seconds + _time_low
	var target := time + step
	# Nothing happens until then: that is most frames, so nothing else is asked first.
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


## When something happens next, in seconds; INF if nothing ever does. It may be no more than that a
## ball has to look again for others.
func next_event_time() -> float:
	return _queue.first_time


## Lets time pass until the next impact, rest or sliding off has happened. Where there is none, or
## more than [member most_impacts_per_second], it says so.
func advance_to_next_event() -> String:
	var before := events.size()
	var kept := keeps_events
	keeps_events = true
	var problem := ""
	while events.size() == before and not problem:
		if _queue.first_time == INF:
			problem = "Nothing happens any more after %s s." % time
		else:
			problem = _advance_to(_queue.first_time, _queue.first_low)
	keeps_events = kept
	if not kept:
		events.resize(before)
	return problem


## Everything that moves, as it is now.
func snapshot() -> WorldSnapshot:
	var kept := WorldSnapshot.new()
	kept.time = time
	kept.time_low = _time_low
	kept.impacts = impacts
	kept.contents = _contents
	kept.counted = [_count_from, _counted_impacts]
	kept.keep(_all_arrays())
	kept.rolls = _rolls.duplicate()
	return kept


## Puts back what [method snapshot] has kept, to the last bit. Segments, walls, gravity and
## bounciness must be those of that time: else a sentence says so.
func restore(kept: WorldSnapshot) -> String:
	if kept.contents != _contents:
		return "The snapshot of %s s was taken among other segments, walls or pulls." % kept.time
	time = kept.time
	_time_low = kept.time_low
	impacts = kept.impacts
	_count_from = kept.counted[0]
	_counted_impacts = int(kept.counted[1])
	kept.put_into(_all_arrays())
	_rolls = kept.rolls.duplicate()
	_quiet_until = -INF
	_queue.resize(ball_count())
	_balls_there = _is_there.count(1)
	return ""


## The energy of all balls, m (v^2 / 2 - g . x), in px^2/s^2 times mass.
func energy() -> float:
	var sum := 0.0
	for index in ball_count():
		if _is_there[index] == 1:
			var speed_squared := velocity(index).length_squared()
			var height := _gravity_x * position_x(index) + _gravity_y * position_y(index)
			sum += _mass[index] * (0.5 * speed_squared - height)
	return sum


## Whether a ball lies or slides on a segment or a wall.
func is_resting(index: int) -> bool:
	return _support[index] != NOTHING and time >= _start[index]


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
		# Within the last place of the target an event may still be to come; were it to happen now, a
		# fast ball would be seen beyond what it bounces off.
		if queue.first_time == target and queue.first_low > low:
			break
		time = queue.first_time
		_time_low = queue.first_low
		var index := queue.first
		if may_hurry and _event_kind[index] == TOUCH and _touched[index] < NOTHING:
			_bounce_off_wall(index)
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


func _all_arrays() -> Array:
	var arrays: Array = [_is_there, _queue.times, _queue.lows]
	arrays.append_array(_float_arrays())
	arrays.append_array(_int_arrays())
	arrays.append_array(_cells.arrays())
	return arrays
