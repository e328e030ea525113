class_name BallEvents
extends BallBounces
## What an event does to the balls it happens to: bounces, collisions, sliding off.

## A ball that slides off the end of a segment goes on on another one if that is as near as this, in
## pixels, and as level, in radians.
const SEAM := 1e-9
## Bounces that pile up on another ball, on which nothing lies still, end in hops of this time, in
## seconds, in which no speed is lost any more: 0.006 px high at 500 px/s^2.
const LEAST_HOP := 1e-2


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
		_slide_off(index)
		_forecast(index)
	elif kind == FOLLOW_CAP:
		_follow_cap(index)
		_forecast(index)


# The segment ends under a sliding ball: another one goes on there, or the ball leaves.
func _slide_off(index: int) -> void:
	_restart(index)
	var old := _support[index]
	_find_normal(index, old)
	_set_free(index)
	for place in _segments.places_near(_x[index], _y[index], _radius[index]):
		if place != old and _goes_on(index, place):
			_put_on(index, place)
			return
	_find_normal(index, old)
	_end_event(index, old, _begin_event(index), WorldEvent.Kind.LEAVE)
	_roll(index, old, _touched_feature[index] as Impact.Feature)


# Whether the ball touches this segment, too, and moves along it, pressed on it.
func _goes_on(index: int, place: int) -> bool:
	var distance := absf(_segments.signed_distance(place, _x[index], _y[index]))
	if absf(distance - _radius[index]) > SEAM:
		return false
	var slack := SEAM / _segments.length(place)
	var velocity_x := _velocity_x[index]
	var velocity_y := _velocity_y[index]
	# It must lie ahead: the ball comes from one of its ends.
	var ahead := SEAM * signf(velocity_x * velocity_x + velocity_y * velocity_y)
	var share := _segments.share_of(
		place, _x[index] + ahead * velocity_x, _y[index] + ahead * velocity_y
	)
	if share < -slack or share > 1.0 + slack:
		return false
	_find_normal(index, place)
	if _gravity_x * _normal_x + _gravity_y * _normal_y >= 0.0:
		return false
	var across := velocity_x * _normal_x + velocity_y * _normal_y
	return absf(across) <= SEAM * sqrt(_squared_speed(index))


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
	_forget_surface(one)
	_forget_surface(other)
	_forecast(one)
	_forecast(other)


# Each of both has an event of its own.
func _exchange_with_events(one: int, other: int) -> void:
	var event := _begin_event(one)
	var event_of_other := _begin_event(other)
	_exchange(one, other)
	_end_event(one, other, event, WorldEvent.Kind.BALL)
	_normal_x = -_normal_x
	_normal_y = -_normal_y
	_end_event(other, one, event_of_other, WorldEvent.Kind.BALL)


# Newton's laws along the normal, as in BallBounce.
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
		# Rounding must not let them meet once more at once.
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


# How fast to leave where bounces may pile up: not so slowly that the hop is shorter than LEAST_HOP,
# but no faster than it came, unless it did not come at all.
func _hop_speed(speed: float, approach: float, pressure: float) -> float:
	var least := 0.5 * pressure * LEAST_HOP
	if speed >= least:
		return speed
	return minf(approach, least) if approach > 1e-3 * least else least


# After a push: a ball that lay on something may be lifted off it or driven into it.
func _forget_surface(index: int) -> void:
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
		# A push of a hop is lost in the line at once.
		_put_on(index, surface)
		return
	_set_free(index)
	if speed > 0.0 and _is_line(index, surface):
		_left_surface[index] = surface
		_left_speed[index] = speed
		return
	if speed <= 0.0:
		impacts += 1
		_leave(index, surface, -speed, _begin_event(index))
