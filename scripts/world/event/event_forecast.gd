class_name EventForecast
extends EventState
## What comes next for each ball: its touch of a wall or a segment, or an impact with another ball,
## whichever is earlier. It is worked out once, when a flight begins, and stays true until something
## changes.
##
## Each ball has one event at a time (Lubachevsky, How to Simulate Billiards and Similar Systems,
## 1991). Two balls that are to meet share one. When a ball finds an earlier partner, it may take it
## away from a third ball; that one is told to look again at the time of the impact that it has
## lost. A ball with another event before a possible impact is no partner: it looks again then.

# From this number of balls on, each looks for partners only around its own cell.
const _MANY_BALLS := 16


# Works out what comes next for a ball whose flight begins now.
func _forecast(index: int) -> void:
	_forecast_touch(index)
	if _uses_cells and _gravity_x == 0.0 and _gravity_y == 0.0:
		_choose_event_fast(index, true)
		return
	_forecast_meeting(index)


# What comes next for a ball whose next touch is known.
func _forecast_meeting(index: int) -> void:
	if _balls_there > 1:
		_ask(index)
		if _uses_cells:
			_forecast_crossing(index)
	_choose_event(index)


# What _forecast_meeting does for a ball of a crowd that nothing pulls, by one search that is
# written out; without [param is_new] what _forecast_event does.
func _choose_event_fast(index: int, is_new: bool) -> void:
	var within := (_touch_time[index] - time) + (_touch_low[index] - _time_low)
	var cells := _cells
	cells.search(index, time, _time_low, within, cells.all_neighbors, is_new)
	if cells.partner >= 0:
		_meet_found_partner(index)
		return
	if _event_kind[index] == MEET:
		_release_partner(index)
	_set_event(index, _touch_time[index], _touch_low[index], _touch_kind[index], _touched[index])


# What _cross does with readable steps, by the search that is written out.
func _cross_fast(index: int) -> void:
	var within := (_event_time[index] - time) + (_event_low[index] - _time_low)
	var cells := _cells
	var new_neighbors := cells.new_neighbors[cells.border[index] + 2]
	cells.cross(index)
	cells.search(index, time, _time_low, within, new_neighbors, true)
	if cells.partner >= 0:
		_meet_found_partner(index)
	elif _cross_time[index] < _event_time[index]:
		_queue.change(index, _cross_time[index], 0.0)
	else:
		_queue.change(index, _event_time[index], _event_low[index])


func _meet_found_partner(index: int) -> void:
	_asker = index
	_partner = _cells.partner
	_partner_seconds = _cells.seconds
	_release_partner(index)
	_meet_partner(index)


# When the asker comes into another cell.
func _forecast_crossing(index: int) -> void:
	_cross_time[index] = (
		time
		+ _cells.time_to_leave(
			index,
			_asker_x,
			_asker_y,
			_asker_velocity_x,
			_asker_velocity_y,
			_asker_pull_x,
			_asker_pull_y
		)
	)


# A ball comes into another cell: three of the nine cells around it are new, and only with their
# balls can it have an impact before its event.
func _cross(index: int) -> void:
	var new_neighbors := _cells.new_neighbors[_cells.border[index] + 2]
	_cells.cross(index)
	_ask(index)
	_forecast_crossing(index)
	_partner_seconds = (_event_time[index] - time) + (_event_low[index] - _time_low)
	_try_cells(9 * _cells.cell[index], new_neighbors)
	if _partner >= 0:
		_release_partner(index)
		_meet_partner(index)
	elif _cross_time[index] < _event_time[index]:
		_queue.change(index, _cross_time[index], 0.0)
	else:
		_queue.change(index, _event_time[index], _event_low[index])


# Looks for a partner again, while the flight goes on.
func _forecast_event(index: int) -> void:
	if _uses_cells and _gravity_x == 0.0 and _gravity_y == 0.0:
		_choose_event_fast(index, false)
		return
	_ask(index)
	_choose_event(index)


# Chooses the next event of the asker. Where that is an impact with another ball, whoever was to
# meet that ball loses it.
func _choose_event(index: int) -> void:
	if _event_kind[index] == MEET:
		_release_partner(index)
	if _balls_there > 1:
		_partner_seconds = (_touch_time[index] - time) + (_touch_low[index] - _time_low)
		_try_all_partners(index)
		if _partner >= 0:
			_meet_partner(index)
			return
	_set_event(index, _touch_time[index], _touch_low[index], _touch_kind[index], _touched[index])


# Gives the asker and the partner that it has found their common event. The time is a sum of two
# numbers (two-sum), as in _note_touch.
func _meet_partner(index: int) -> void:
	var sum := time + _partner_seconds
	var part := sum - time
	var low := (time - (sum - part)) + (_partner_seconds - part) + _time_low
	var event_time := sum + low
	low -= event_time - sum
	_release_partner(_partner)
	_set_event(_partner, event_time, low, MEET, index)
	_set_event(index, event_time, low, MEET, _partner)


func _set_event(index: int, event_time: float, low: float, kind: int, with: int) -> void:
	_event_time[index] = event_time
	_event_low[index] = low
	_event_kind[index] = kind
	_event_with[index] = with
	if _uses_cells and _cross_time[index] < event_time:
		event_time = _cross_time[index]
		low = 0.0
	_queue.change(index, event_time, low)


# An impact with this ball is off: the other one looks again when it would have happened.
func _release_partner(index: int) -> void:
	if _event_kind[index] == MEET:
		_event_kind[_event_with[index]] = LOOK_AGAIN


# Makes a ball the asker, the one that looks for a partner, and notes where it is now.
func _ask(index: int) -> void:
	var flown := (time - _start[index]) + (_time_low - _start_low[index])
	_asker = index
	_asker_pull_x = _pull_x[index]
	_asker_pull_y = _pull_y[index]
	_asker_velocity_x = _velocity_x[index] + _asker_pull_x * flown
	_asker_velocity_y = _velocity_y[index] + _asker_pull_y * flown
	_asker_x = _x[index] + 0.5 * (_velocity_x[index] + _asker_velocity_x) * flown
	_asker_y = _y[index] + 0.5 * (_velocity_y[index] + _asker_velocity_y) * flown
	_asker_radius = _radius[index]
	_partner = NOTHING


func _try_all_partners(index: int) -> void:
	if _uses_cells:
		_try_cells(9 * _cells.cell[index], _cells.all_neighbors)
		return
	for other in _x.size():
		if _is_there[other] == 1:
			_try_partner(other)


# Tries all balls of these cells.
func _try_cells(around: int, cells: PackedInt32Array) -> void:
	for place in cells:
		var other := _cells.first[_cells.neighbors[around + place]]
		while other >= 0:
			_try_partner(other)
			other = _cells.next[other]


# Takes the other ball as partner if the asker meets it before all that it has found, by the formula
# of StraightImpactFinder.
func _try_partner(other: int) -> void:
	var flown := (time - _start[other]) + (_time_low - _start_low[other])
	var pulled_x := _pull_x[other] * flown
	var pulled_y := _pull_y[other] * flown
	var dx := _asker_x - _x[other] - (_velocity_x[other] + 0.5 * pulled_x) * flown
	var dy := _asker_y - _y[other] - (_velocity_y[other] + 0.5 * pulled_y) * flown
	var velocity_x := _asker_velocity_x - (_velocity_x[other] + pulled_x)
	var velocity_y := _asker_velocity_y - (_velocity_y[other] + pulled_y)
	var reach := _asker_radius + _radius[other]
	var pull_x := _asker_pull_x - _pull_x[other]
	var pull_y := _asker_pull_y - _pull_y[other]
	if pull_x != 0.0 or pull_y != 0.0:
		if other != _asker:
			_pulled_meeting.set_flight(dx, dy, velocity_x, velocity_y, pull_x, pull_y)
			if _pulled_meeting.is_found(reach, _partner_seconds):
				_take_partner(other, _pulled_meeting.time)
		return
	var approach := -(dx * velocity_x + dy * velocity_y)
	if not approach > 0.0:
		return
	var excess := dx * dx + dy * dy - reach * reach
	if excess <= 0.0:
		_take_partner(other, 0.0)
		return
	var offset := dx * velocity_y - dy * velocity_x
	var speed_squared := velocity_x * velocity_x + velocity_y * velocity_y
	var discriminant := reach * reach * speed_squared - offset * offset
	if discriminant > 0.0:
		_take_partner(other, excess / (approach + sqrt(discriminant)))


func _take_partner(other: int, seconds: float) -> void:
	if seconds < _partner_seconds and time + seconds < _event_time[other]:
		_partner_seconds = seconds
		_partner = other


# The next touch of a wall or a segment, as if there were no other balls.
func _forecast_touch(index: int) -> void:
	if _pull_x[index] != 0.0 or _pull_y[index] != 0.0 or _support[index] >= 0:
		_forecast_accelerated_touch(index)
		return
	if _support[index] < NOTHING:
		if _support[index] == ON_BALLS:
			_forecast_end_of_lying(index, _piles.end_of_lying(index) - _start[index])
			return
		if _support[index] == CRUSHED:
			_note_touch(
				index, maxf(_piles.end_of_lying(index) - _start[index], 0.0), CRUSHED, CRUSH
			)
			return
		if _spins.slip_ends[index] < INF:
			_forecast_accelerated_touch(index)
			return
	var x := _x[index]
	var y := _y[index]
	var velocity_x := _velocity_x[index]
	var velocity_y := _velocity_y[index]
	var radius := _radius[index]
	var seconds := INF
	var surface := NOTHING
	if _has_walls:
		if velocity_x > 0.0:
			seconds = maxf((_right_x - radius - x) / velocity_x, 0.0)
			surface = RIGHT_WALL
		elif velocity_x < 0.0:
			seconds = maxf((_left_x + radius - x) / velocity_x, 0.0)
			surface = LEFT_WALL
		if velocity_y > 0.0:
			var to_wall := maxf((_bottom_y - radius - y) / velocity_y, 0.0)
			if to_wall < seconds:
				seconds = to_wall
				surface = BOTTOM_WALL
		elif velocity_y < 0.0:
			var to_wall := maxf((_top_y + radius - y) / velocity_y, 0.0)
			if to_wall < seconds:
				seconds = to_wall
				surface = TOP_WALL
	if _segments.size() > 0:
		# A segment is convex: in straight flight a ball never comes back to the one it has left.
		var left := _left_surface[index]
		if _segments.first_impact(x, y, velocity_x, velocity_y, radius, seconds, left):
			seconds = _segments.time
			surface = _segments.index
			_touched_feature[index] = _segments.feature
	_note_touch(index, seconds, surface, TOUCH)


# A ball that lies in a pile tries again after a while, unless a segment comes before.
func _forecast_end_of_lying(index: int, seconds: float) -> void:
	if _moves and _segments.first_impact(_x[index], _y[index], 0.0, 0.0, _radius[index], seconds):
		_touched_feature[index] = _segments.feature
		_note_touch(index, _segments.time, _segments.index, TOUCH)
	else:
		_note_touch(index, seconds, ON_BALLS, TRY_AGAIN)


# Stores the touch that comes after this many seconds of flight. Its time is a sum of two numbers
# (two-sum), the second one smaller than the last place of the first, so that times can be compared.
func _note_touch(index: int, seconds: float, surface: int, kind: int) -> void:
	var start := _start[index]
	var sum := start + seconds
	_touch_time[index] = sum
	_touch_low[index] = 0.0
	if seconds < INF:
		var part := sum - start
		var low := (start - (sum - part)) + (seconds - part) + _start_low[index]
		_touch_time[index] = sum + low
		_touch_low[index] = low - (sum + low - sum)
	_touch_kind[index] = kind
	_touched[index] = surface


# The next touch under a constant pull. When the ball comes back to the surface that it has just
# left follows from its normal speed alone; the other surfaces are searched.
func _forecast_accelerated_touch(index: int) -> void:
	_seconds = INF
	_surface = NOTHING
	_kind = TOUCH
	if _friction > 0.0 and _spins.slip_ends[index] < INF:
		_take(_spins.slip_ends[index], _support[index], END_SLIP)
	if _support[index] >= 0:
		if _rolled_end[index] == Impact.Feature.LINE:
			_forecast_slide(index, _support[index])
		else:
			_take(_piece[index], _support[index], FOLLOW_CAP)
		if _moves and _segments.seconds_left(_support[index]) <= _seconds:
			_take(_segments.seconds_left(_support[index]), _support[index], SUPPORT_TURNS)
	if _has_walls:
		for wall: int in [RIGHT_WALL, LEFT_WALL, BOTTOM_WALL, TOP_WALL]:
			_forecast_wall(index, wall)
	if _segments.size() > 0:
		var skipped := _support[index]
		if _left_surface[index] >= 0:
			_forecast_return(index, _left_surface[index])
			if _left_feature[index] == Impact.Feature.LINE:
				skipped = _left_surface[index]
		_tell_contact(index)
		if _segments.first_accelerated_impact(
			_x[index],
			_y[index],
			_velocity_x[index],
			_velocity_y[index],
			_pull_x[index],
			_pull_y[index],
			_radius[index],
			_seconds,
			skipped
		):
			_take(_segments.time, _segments.index, TOUCH)
			_touched_feature[index] = _segments.feature
			if _segments.index == skipped:  # Which has begun to move otherwise.
				_left_surface[index] = NOTHING
	_note_touch(index, _seconds, _surface, _kind)


func _take(seconds: float, surface: int, kind: int) -> void:
	_seconds = seconds
	_surface = surface
	_kind = kind


func _forecast_wall(index: int, wall: int) -> void:
	if wall == _support[index]:
		return
	_find_normal(index, wall)
	var speed := _velocity_x[index] * _normal_x + _velocity_y[index] * _normal_y
	var pull := _pull_x[index] * _normal_x + _pull_y[index] * _normal_y
	var height := _gap_to_wall(index, wall)
	if wall == _left_surface[index]:
		height = 0.0
		speed = _left_speed[index]
	var seconds := FreeFlight.time_to_fall(height, speed, pull)
	if seconds < _seconds:
		_take(seconds, wall, TOUCH)


func _gap_to_wall(index: int, wall: int) -> float:
	match wall:
		LEFT_WALL:
			return _x[index] - _radius[index] - _left_x
		RIGHT_WALL:
			return _right_x - _radius[index] - _x[index]
		TOP_WALL:
			return _y[index] - _radius[index] - _top_y
	return _bottom_y - _radius[index] - _y[index]


# Tells the segments what the ball touches already: what it lies on, or the end of a segment that it
# slides round or has slid off.
func _tell_contact(index: int) -> void:
	var is_held := _support[index] != NOTHING
	var place := _support[index] if is_held else _left_surface[index]
	_segments.contact_place = place
	var feature := (_rolled_end[index] if is_held else _left_feature[index]) as Impact.Feature
	if is_held and feature == Impact.Feature.LINE:
		_find_normal(index, place)
		var x := _x[index] - _radius[index] * _normal_x
		var y := _y[index] - _radius[index] * _normal_y
		_segments.lie_on_line(x, y, _normal_x, _normal_y)
	elif is_held:
		_segments.slide_round(_segments.end_x(place, feature), _segments.end_y(place, feature))
	elif place >= 0 and feature != Impact.Feature.LINE:
		_segments.leave_point(_segments.end_x(place, feature), _segments.end_y(place, feature))


# Back to the segment that the ball has left: on its line after 2 v / g, or on one of its caps.
func _forecast_return(index: int, place: int) -> void:
	if _left_feature[index] != Impact.Feature.LINE:
		_forecast_return_to_cap(index, place)
		return
	_find_normal(index, place)
	var pull := _pull_x[index] * _normal_x + _pull_y[index] * _normal_y
	var seconds := FreeFlight.time_to_fall(0.0, _left_speed[index], pull)
	if seconds < _seconds and seconds <= _segments.seconds_left(place):
		var speed_x := _velocity_x[index] - _segments.segment_velocity_x(place)
		var speed_y := _velocity_y[index] - _segments.segment_velocity_y(place)
		var share := _segments.share_of(
			place,
			_x[index] + (speed_x + 0.5 * _pull_x[index] * seconds) * seconds,
			_y[index] + (speed_y + 0.5 * _pull_y[index] * seconds) * seconds
		)
		if share >= 0.0 and share <= 1.0:
			_touched_feature[index] = Impact.Feature.LINE
			_take(seconds, place, TOUCH)
			return
	_forecast_ends(index, place)


# Back to the cap that the ball has slid off: a ball that climbs may come back to it.
func _forecast_return_to_cap(index: int, place: int) -> void:
	var feature := _left_feature[index] as Impact.Feature
	var x := _x[index] - _segments.end_x(place, feature)
	var y := _y[index] - _segments.end_y(place, feature)
	var vx := _velocity_x[index] - _segments.segment_velocity_x(place)
	var vy := _velocity_y[index] - _segments.segment_velocity_y(place)
	var seconds := FreeFlight.time_back_to_circle(x, y, vx, vy, _pull_x[index], _pull_y[index])
	if seconds < _seconds and seconds <= _segments.seconds_left(place):
		_touched_feature[index] = feature
		_take(seconds, place, TOUCH)


# The caps of a segment, without its line.
func _forecast_ends(index: int, place: int) -> void:
	if _segments.first_end(
		place,
		_x[index],
		_y[index],
		_velocity_x[index],
		_velocity_y[index],
		_pull_x[index],
		_pull_y[index],
		_radius[index],
		_seconds
	):
		_touched_feature[index] = _segments.feature
		_take(_segments.time, place, TOUCH)


# When a ball that slides on a segment comes to the end of its line.
func _forecast_slide(index: int, place: int) -> void:
	var length := _segments.length(place)
	var along_x := _segments.normal_y(place)
	var along_y := -_segments.normal_x(place)
	var from_start := _segments.share_of(place, _x[index], _y[index]) * length
	var speed_x := _velocity_x[index] - _segments.segment_velocity_x(place)
	var speed_y := _velocity_y[index] - _segments.segment_velocity_y(place)
	var speed := speed_x * along_x + speed_y * along_y
	var pull := _pull_x[index] * along_x + _pull_y[index] * along_y
	var to_start := FreeFlight.time_to_fall(maxf(from_start, 0.0), speed, pull)
	var to_end := FreeFlight.time_to_fall(maxf(length - from_start, 0.0), -speed, -pull)
	if minf(to_start, to_end) < _seconds:
		_touched_feature[index] = (
			Impact.Feature.START if to_start < to_end else Impact.Feature.END
		)
		_take(minf(to_start, to_end), place, SLIDE_OFF)


# Whether a ball that touches this surface touches a straight line, and not a cap.
func _is_line(index: int, surface: int) -> bool:
	return surface < NOTHING or _touched_feature[index] == Impact.Feature.LINE


# The unit normal of a cap, towards the ball.
func _find_cap_normal(index: int, place: int, feature: Impact.Feature) -> void:
	var dx := _x[index] - _segments.end_x(place, feature)
	var dy := _y[index] - _segments.end_y(place, feature)
	var distance := sqrt(dx * dx + dy * dy)
	_normal_x = dx / distance if distance > 0.0 else 0.0
	_normal_y = dy / distance if distance > 0.0 else 0.0


# A ball is out of the world, and nothing happens to it any more.
func _take_out(index: int) -> void:
	_halt(index)
	_is_there[index] = 0
	_balls_there -= 1
	if _uses_cells:
		_cells.remove(index)
		_cross_time[index] = INF
	_set_event(index, INF, 0.0, LOOK_AGAIN, NOTHING)


func _lay_out_cells() -> void:
	_balls_there = _is_there.count(1)
	_uses_cells = _balls_there >= _MANY_BALLS
	_cross_time.fill(INF)
	if _uses_cells:
		_cells.put_all(positions(), _is_there)
