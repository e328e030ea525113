class_name BallSupport
extends EventForecast
## How a ball comes to rest under gravity, and how it moves while a surface supports it: it lies
## still, slides or rolls along a line, over a seam between two lines, or slides over a cap, where
## there is no friction.

## A ball that cannot rise by more than this any more, in pixels, lies still where two surfaces hold
## it: there its bounces off both mix, and no formula gives their end.
const REST_HEIGHT := 1e-9
## The second surface holds a ball that is this near to it, in pixels.
const REST_GAP := TwoSurfaces.GAP
## The next segment must still be below the ball this far beyond the end of the last, in pixels.
const AHEAD := 1e-6


# After a bounce on a line with this speed along the normal, pressed on it by this part of gravity.
func _rest_if_over(index: int, surface: int, speed: float, pressure: float) -> void:
	if _is_held_by_two(index):
		_lie_still(index, surface)
	elif pressure > 0.0:
		if LastBounces.are_over(speed, pressure, _bounciness):
			_rest(index, surface, speed, pressure)
		elif LastBounces.are_too_low(speed, pressure, _bounciness):
			_slide_on(index, surface)


# The last hop of a nearly elastic ball is too low to be seen: it slides from now on. With C = 1 it
# keeps its speed, as on a smooth surface, where a joint of two lines costs nothing.
func _slide_on(index: int, surface: int) -> void:
	var event := _begin_event(index)
	var speed_squared := _squared_speed(index)
	_lay_on(index, surface)
	var lost := speed_squared - _squared_speed(index)
	if _bounciness == 1.0 and lost <= LastBounces.LEAST_LOSS * speed_squared:
		_keep_speed(index, speed_squared)
	_go_along(index, surface)
	_end_event(index, surface, event, WorldEvent.Kind.REST)


# A unit normal is rounded, and always to the same side for the same line. So the velocity is scaled
# back to the length that it had: it does not grow or shrink over a million bounces.
func _keep_speed(index: int, speed_squared: float) -> void:
	var now := _squared_speed(index)
	if now > 0.0:
		var factor := 1.0 + 0.5 * (speed_squared - now) / now
		_velocity_x[index] *= factor
		_velocity_y[index] *= factor


# Whether a ball that can hardly rise touches a second line or cap, so that both together hold it.
# The normal is that of the first one. Where a belt rubs on a ball, it does not lie still.
func _is_held_by_two(index: int) -> bool:
	if not _can_hardly_rise(index):
		return false
	if _friction > 0.0 and _segments.is_near_belt(_x[index], _y[index], _radius[index]):
		return false
	var centre := Vec2.new(_x[index], _y[index])
	var surfaces := TwoSurfaces.new(Vec2.new(_normal_x, _normal_y), _gravity_x, _gravity_y)
	var tilts := _spins.tilts(index, _least_squared_speed)
	_pressure = surfaces.pressure_among(
		_segments.points_near(_x[index], _y[index], _radius[index]), centre, _radius[index], tilts
	)
	return _pressure >= 0.0


# Whether a ball cannot rise by REST_HEIGHT.
func _can_hardly_rise(index: int) -> bool:
	return _squared_speed(index) <= _least_squared_speed


# The ball, which two surfaces hold, stays where it is until something else touches it. A spin that
# it has dies down by friction.
func _lie_still(index: int, surface: int) -> void:
	var event := _begin_event(index)
	_lie_on(index, surface)
	if _friction > 0.0:
		_spins.spin_in_place(index, _pressure)
	_end_event(index, surface, event, WorldEvent.Kind.REST)


func _lie_on(index: int, surface: int) -> void:
	_support[index] = surface
	_left_surface[index] = NOTHING
	for motion: PackedFloat64Array in [_velocity_x, _velocity_y, _pull_x, _pull_y]:
		motion[index] = 0.0


# A ball that is squeezed among others loses half of its speed, or lies for a while.
func _calm(index: int) -> void:
	var is_slow := _piles.note_speed(index, time)
	if _piles.lies(index) or not _piles.is_squeezed(index, time) or _is_near_motion(index):
		return
	if is_slow:
		var seconds := BallPiles.WHILE if _is_held_in_pile(index) else BallPiles.SHORT_WHILE
		_lie_in_pile(index, time + seconds)
		return
	if _rolled_end[index] != Impact.Feature.LINE:
		_set_free(index)
	_velocity_x[index] *= 0.5
	_velocity_y[index] *= 0.5
	_left_speed[index] *= 0.5
	if _friction > 0.0:
		_spins.halve(index)
		if _support[index] != NOTHING:
			_go_along(index, _support[index])


# A ball, whose flight begins now, comes to lie until a push, with all that it touches.
func _settle(index: int) -> bool:
	if _piles.is_asleep(index) or not _piles.has_been_slow(index, time):
		return false
	var still := _piles.still_with(index, time, positions())
	for one in still:
		var is_slow := velocity(one).length_squared() <= _piles.slow_speed ** 2
		if not (is_slow and _is_held_in_pile(one)) or _is_near_motion(one):
			return false
	for one in still:
		_restart(one)
		_lie_in_pile(one, INF)
		if one != index:
			_forecast(one)
	return not still.is_empty()


# Whether a ball touches something that moves: there is no rest in a pile.
func _is_near_motion(index: int) -> bool:
	if not _moves:
		return false
	return _segments.has_motion_near(position_x(index), position_y(index), _radius[index])


func _is_held_in_pile(index: int) -> bool:
	if _piles.has_been_slow(index, time, BallPiles.CREEP_TIME):
		return true
	var gravity := Vec2.new(_gravity_x, _gravity_y)
	var points := _segments.points_near(position_x(index), position_y(index), _radius[index])
	return _piles.is_held(index, positions(), points, gravity)


# Only lying until a push, with INF, is an event.
func _lie_in_pile(index: int, until: float) -> void:
	var event := _begin_event(index) if until == INF else null
	_set_free(index)
	_lie_on(index, ON_BALLS)
	if _friction > 0.0:
		_spins.lie(index)
	_normal_x = 0.0
	_normal_y = 0.0
	_piles.lie_until(index, until)
	_start[index] = time
	_start_low[index] = _time_low
	_end_event(index, ON_BALLS, event, WorldEvent.Kind.REST)


# Frees all that lies with this ball, if it lies; gives whose flight began anew.
func _wake(index: int) -> PackedInt32Array:
	if not _piles.lies(index):
		return []
	var woken := _piles.lying_with(index, positions())
	for one in woken:
		_restart(one)
		_set_free(one)
	return woken


# Adds up all remaining bounces; then the ball lies or slides on the surface.
func _rest(index: int, surface: int, speed: float, pressure: float) -> void:
	var seconds := LastBounces.duration(speed, pressure, _bounciness)
	var event := _begin_event(index)
	_lay_on(index, surface)
	_x[index] += (_velocity_x[index] + 0.5 * _pull_x[index] * seconds) * seconds
	_y[index] += (_velocity_y[index] + 0.5 * _pull_y[index] * seconds) * seconds
	_velocity_x[index] += _pull_x[index] * seconds
	_velocity_y[index] += _pull_y[index] * seconds
	_start[index] = time + seconds
	_start_low[index] = _time_low
	_go_along(index, surface)
	if event:
		event.time = time + seconds
	_end_event(index, surface, event, WorldEvent.Kind.REST)


# From now on the ball slides or rolls along a wall or the line of a segment, whose normal must be
# known.
func _put_on(index: int, surface: int) -> void:
	_lay_on(index, surface)
	_go_along(index, surface)


# THE LAW OF FRICTION at a wall or a segment, whose normal must be known. It has pushed the ball
# away with this impulse per mass, in px/s.
func _rub(index: int, push: float) -> void:
	if _friction > 0.0:
		_spins.rub(index, _normal_x, _normal_y, push, _frame.belt)
		_lasting_speed[index] = NAN


# THE LAW OF FRICTION along a line on which the ball lies: see Incline.
func _go_along(index: int, surface: int) -> void:
	if _friction > 0.0:
		_spins.go_along(index, surface)


# The ball does not slip any more: it rolls, or slips the other way, or spins no more in its place.
func _end_slip(index: int) -> void:
	_restart(index)
	var surface := _support[index]
	var event := _begin_event(index)
	if _spins.regime(index) == BallSpins.Regime.SPINS:
		_spins.lie(index)
		_set_free(index)
	else:
		_find_normal(index, surface)
		_lay_on(index, surface)
		_spins.go_on_without_slip(index, surface)
	_end_event(index, surface, event, WorldEvent.Kind.SLIP_ENDS)


# Its velocity and its acceleration have no part along the normal any more.
func _lay_on(index: int, surface: int) -> void:
	var speed := _velocity_x[index] * _normal_x + _velocity_y[index] * _normal_y
	var pressure := _gravity_x * _normal_x + _gravity_y * _normal_y
	_velocity_x[index] -= speed * _normal_x
	_velocity_y[index] -= speed * _normal_y
	_pull_x[index] = _gravity_x - pressure * _normal_x
	_pull_y[index] = _gravity_y - pressure * _normal_y
	_support[index] = surface
	_rolled_end[index] = Impact.Feature.LINE
	_left_surface[index] = NOTHING
	if surface >= 0:
		var distance := absf(_segments.signed_distance(surface, _x[index], _y[index]))
		_x[index] += (_radius[index] - distance) * _normal_x
		_y[index] += (_radius[index] - distance) * _normal_y
	else:
		_move_to_wall(index, surface)


# Takes away what rounding left between a ball and the wall that it touches.
func _move_to_wall(index: int, wall: int) -> void:
	match wall:
		LEFT_WALL:
			_x[index] = _left_x + _radius[index]
		RIGHT_WALL:
			_x[index] = _right_x - _radius[index]
		TOP_WALL:
			_y[index] = _top_y + _radius[index]
		BOTTOM_WALL:
			_y[index] = _bottom_y - _radius[index]


# Nothing supports the ball, and gravity alone pulls it.
func _set_free(index: int) -> void:
	_support[index] = NOTHING
	_rolled_end[index] = Impact.Feature.LINE
	_left_surface[index] = NOTHING
	_left_feature[index] = Impact.Feature.LINE
	_pull_x[index] = _gravity_x
	_pull_y[index] = _gravity_y
	if _friction > 0.0:
		_spins.fly(index)


# The line under a sliding ball ends: another segment goes on there, or the ball slides over the cap
# or flies off. Where the next segment rises, so little that rounding has hidden its touch, nothing
# is done: its place is returned, and the ball has to bounce off it. Else NOTHING is returned.
func _slide_off(index: int) -> int:
	_restart(index)
	var old := _support[index]
	_find_normal(index, old)
	_set_free(index)
	var sign_of_end := 1.0 if _touched_feature[index] == Impact.Feature.END else -1.0
	var ahead_x := sign_of_end * AHEAD * _segments.normal_y(old)
	var ahead_y := -sign_of_end * AHEAD * _segments.normal_x(old)
	var next := NOTHING
	var least := SegmentEnds.SEAM * sqrt(_squared_speed(index))
	var is_risen := false
	for place in _segments.places_near(_x[index], _y[index], _radius[index]):
		if SegmentEnds.is_dot(_segments, place):
			continue
		if place != old and _goes_on(index, place, _x[index] + ahead_x, _y[index] + ahead_y):
			var across := _velocity_x[index] * _normal_x + _velocity_y[index] * _normal_y
			if across <= least:
				next = place
				is_risen = across < -least
				least = minf(across, least)
	if is_risen:
		return next
	if next != NOTHING:
		_find_normal(index, next)
		_put_on(index, next)
		return NOTHING
	_find_normal(index, old)
	_end_event(index, old, _begin_event(index), WorldEvent.Kind.LEAVE)
	_roll(index, old, _touched_feature[index] as Impact.Feature)
	return NOTHING


# Whether the ball touches the line of this segment, too, is pressed on it, and is still over it at
# (x, y), a little ahead. Finds its normal.
func _goes_on(index: int, place: int, x: float, y: float) -> bool:
	var distance := absf(_segments.signed_distance(place, _x[index], _y[index]))
	if absf(distance - _radius[index]) > _seam(index):
		return false
	var slack := _seam(index) / _segments.length(place)
	var share := _segments.share_of(place, x, y)
	if share < -slack or share > 1.0 + slack:
		return false
	_find_normal(index, place)
	return _gravity_x * _normal_x + _gravity_y * _normal_y < 0.0


# How near is near enough where a ball slides on from one segment to the next, in pixels: far from
# the origin rounding adds to SegmentEnds.SEAM.
func _seam(index: int) -> float:
	return SegmentEnds.seam_at(_x[index], _y[index])


# Whether bounces that leave a cap with this speed along the normal, which must be known, are over.
# Where the ball is too fast for the cap to hold it, it flies off along it.
func _is_hop_over(index: int, speed: float, pressure: float) -> bool:
	var pressed := pressure - _outward_pull(index)
	if pressed <= 0.0:
		pressed = pressure
	return pressed > 0.0 and LastBounces.is_lowest(speed, pressed)


# The centrifugal acceleration of a ball that goes round a point, in px/s².
func _outward_pull(index: int) -> float:
	var around := _velocity_x[index] * _normal_y - _velocity_y[index] * _normal_x
	return around * around / _radius[index]


# From now on the ball slides over a cap, if gravity holds it there; else it flies.
func _roll(index: int, place: int, feature: Impact.Feature) -> void:
	var slide := CapSlide.new()
	var x := _segments.end_x(place, feature)
	var y := _segments.end_y(place, feature)
	_set_free(index)
	if _comes_onto_line(index, x, y):
		return
	# A piece of the way over a cap was a little off its circle: see CapRolls.OFF_CIRCLE.
	var centre := Vec2.new(_x[index] - x, _y[index] - y)
	centre.set_length(_radius[index])
	_x[index] = x + centre.x
	_y[index] = y + centre.y
	var problem := slide.start(
		x, y, _x[index], _y[index], _velocity_x[index], _velocity_y[index], _gravity_x, _gravity_y
	)
	if problem or slide.end_time == 0.0:
		_fly_off(index, place, feature)
		return
	_support[index] = place
	_rolled_end[index] = feature
	_rolls.begin(index, slide, time, _time_low, _frame.x, _frame.y)
	for other in _lines_at(index, x, y):
		var away := SegmentEnds.direction_from(_segments, other, x, y)
		_rolls.end_at_line(index, away.x, away.y)
	_begin_piece(index, 0.0)


# Whether the ball, which slides round the point (x, y), is over a line that begins there, and moves
# along it: from now on it slides on this line.
func _comes_onto_line(index: int, x: float, y: float) -> bool:
	var centre := Vec2.new(_x[index] - x, _y[index] - y)
	var velocity_now := Vec2.new(_velocity_x[index], _velocity_y[index])
	for place in _lines_at(index, x, y):
		var away := SegmentEnds.direction_from(_segments, place, x, y)
		var over := away.dot(centre)
		var is_over := over >= -_seam(index) and over <= _segments.length(place) + _seam(index)
		if is_over and away.dot(velocity_now) > 0.0:
			_find_normal(index, place)
			if _gravity_x * _normal_x + _gravity_y * _normal_y < 0.0:
				_put_on(index, place)
				return true
	return false


# The segments that end at the point (x, y), round which a ball goes.
func _lines_at(index: int, x: float, y: float) -> PackedInt32Array:
	var near := _segments.places_near(_x[index], _y[index], _radius[index])
	return SegmentEnds.places_at(_segments, near, x, y)


# The next piece of the way over a cap, this many seconds after its beginning.
func _begin_piece(index: int, seconds: float) -> void:
	var gravity := sqrt(_gravity_x * _gravity_x + _gravity_y * _gravity_y)
	_rolls.begin_piece(index, seconds, gravity, _radius[index])
	_take_place_on_cap(index)
	_pull_x[index] = _rolls.pull_x
	_pull_y[index] = _rolls.pull_y
	_piece[index] = _rolls.piece_seconds


func _take_place_on_cap(index: int) -> void:
	_x[index] = _rolls.x
	_y[index] = _rolls.y
	_velocity_x[index] = _rolls.velocity_x - _frame.x
	_velocity_y[index] = _rolls.velocity_y - _frame.y


# A piece is over: the next one begins, or the way over the cap has come to its end.
func _follow_cap(index: int) -> void:
	_restart(index)
	var seconds := _rolls.seconds_since(index, time, _time_low)
	var duration := _rolls.duration(index)
	if duration - seconds > CapRolls.LINE_TIME:
		_begin_piece(index, seconds)
		return
	_rolls.move_to(index, duration)
	_take_place_on_cap(index)
	_leave_cap(index, _support[index], _rolled_end[index] as Impact.Feature)


# At the end of the way over a cap the ball slides on along the line, or back over the cap, or
# flies.
func _leave_cap(index: int, place: int, feature: Impact.Feature) -> void:
	_set_free(index)
	var x := _segments.end_x(place, feature)
	var y := _segments.end_y(place, feature)
	for other in _lines_at(index, x, y):
		if _is_over_line(index, other):
			_put_on(index, other)
			return
	if _rolls.leads_back(index):
		_roll(index, place, feature)
	else:
		_find_cap_normal(index, place, feature)
		_end_event(index, place, _begin_event(index), WorldEvent.Kind.LEAVE)
		_fly_off(index, place, feature)


# Whether the ball is over the line of the segment, and gravity presses it there; finds the normal.
func _is_over_line(index: int, place: int) -> bool:
	var slack := REST_GAP / _segments.length(place)
	var share := _segments.share_of(place, _x[index], _y[index])
	_find_normal(index, place)
	var is_pressed := _gravity_x * _normal_x + _gravity_y * _normal_y < 0.0
	return is_pressed and share >= -slack and share <= 1.0 + slack


# The ball flies off a cap, along the circle about the end of the segment.
func _fly_off(index: int, place: int, feature: Impact.Feature) -> void:
	_left_surface[index] = place
	_left_feature[index] = feature


# From now on until _leave_frame a ball, whose flight begins now, is seen from the segment that it
# touches: THE LAWS OF CONTACT hold in the frame of reference of the surface. Its normal must be
# known where it turns.
func _enter_frame(index: int, surface: int) -> void:
	if not _moves:
		return
	_restart(index)
	_frame.enter(index, surface, ball(index), Vec2.new(_normal_x, _normal_y))
	if _touched_feature[index] == Impact.Feature.LINE:
		_frame.note_belt(surface)
	if _frame.turn != 0.0:
		_frame.hop_if_short(surface, _piles.since_last_touch)


func _leave_frame(index: int) -> void:
	if not _moves:
		return
	if _frame.turn != 0.0:
		_left_surface[index] = NOTHING
	# Where its last bounces were summed up, its flight begins later.
	var ahead := _start[index] - time
	_x[index] += _frame.x * ahead
	_y[index] += _frame.y * ahead
	_frame.leave(index)
	_go_on_from_here(index)


# Begins a flight anew in its midst.
func _go_on_from_here(index: int) -> void:
	var seconds := time - _start[index]
	_spins.slip_ends[index] -= seconds
	_restart(index)


# Call it before an event changes the ball; null where events are not kept.
func _begin_event(index: int) -> WorldEvent:
	if not keeps_events:
		return null
	var before := Vec2.new(_velocity_x[index] + _frame.x, _velocity_y[index] + _frame.y)
	return _log.begin(time, index, before, spin(index))


# Call it after the event has changed the ball. `other` is a surface, or a ball for Kind.BALL.
func _end_event(
	index: int, other: int, event: WorldEvent, kind: WorldEvent.Kind = WorldEvent.Kind.SEGMENT
) -> void:
	if not event:
		return
	var centre := Vec2.new(_x[index], _y[index])
	var after := Vec2.new(_velocity_x[index] + _frame.x, _velocity_y[index] + _frame.y)
	var normal := Vec2.new(_normal_x, _normal_y)
	var ball_after := Ball.new(centre, _radius[index], after, _mass[index], spin(index))
	_log.finish(event, kind, other, normal, ball_after)
