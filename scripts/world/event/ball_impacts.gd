class_name BallImpacts
extends BounceLaws
## What an impact of two balls does to them: the law is in _exchange. _collide_fast writes it out
## once more for the commonest case; a test compares them to the last bit.


# Two balls meet.
func _collide(one: int, other: int) -> void:
	if _uses_cells and _bounciness == 1.0 and not keeps_events and _is_weightless():
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
		_collide_in_pile(one, other)
	else:
		_push(one, other)
	_forecast(one)
	_forecast(other)


# What _collide_by_laws does for two balls of a crowd, for C = 1, without gravity and without
# events, written out.
func _collide_fast(one: int, other: int) -> void:
	impacts += 1
	var flown := (time - _start[one]) + (_time_low - _start_low[one])
	var one_velocity_x := _velocity_x[one]
	var one_velocity_y := _velocity_y[one]
	var one_x := _x[one] + one_velocity_x * flown
	var one_y := _y[one] + one_velocity_y * flown
	flown = (time - _start[other]) + (_time_low - _start_low[other])
	var other_velocity_x := _velocity_x[other]
	var other_velocity_y := _velocity_y[other]
	var other_x := _x[other] + other_velocity_x * flown
	var other_y := _y[other] + other_velocity_y * flown
	var dx := one_x - other_x
	var dy := one_y - other_y
	var distance := sqrt(dx * dx + dy * dy)
	var normal_x := dx / distance if distance > 0.0 else 0.0
	var normal_y := dy / distance if distance > 0.0 else 0.0
	var approach := (
		(other_velocity_x - one_velocity_x) * normal_x
		+ (other_velocity_y - one_velocity_y) * normal_y
	)
	if approach > 0.0:
		var share := (approach + approach) / (_mass[one] + _mass[other])
		one_velocity_x += share * _mass[other] * normal_x
		one_velocity_y += share * _mass[other] * normal_y
		other_velocity_x -= share * _mass[one] * normal_x
		other_velocity_y -= share * _mass[one] * normal_y
		_lasting_speed[one] = NAN
		_lasting_speed[other] = NAN
	_last_meeting[one] = time
	_last_meeting[other] = time
	_left_surface[one] = NOTHING
	_left_surface[other] = NOTHING
	_x[one] = one_x
	_y[one] = one_y
	_velocity_x[one] = one_velocity_x
	_velocity_y[one] = one_velocity_y
	_start[one] = time
	_start_low[one] = _time_low
	_x[other] = other_x
	_y[other] = other_y
	_velocity_x[other] = other_velocity_x
	_velocity_y[other] = other_velocity_y
	_start[other] = time
	_start_low[other] = _time_low
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
func _collide_in_pile(one: int, other: int) -> void:
	var pull_x := _pull_x[one] - _pull_x[other]
	var pull_y := _pull_y[one] - _pull_y[other]
	var is_pressed := pull_x * _normal_x + pull_y * _normal_y < 0.0
	_piles.note_meeting(one, other, is_pressed, time)
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
	_piles.hop_off(index, _normal_x, _normal_y, pressure, part)
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
		speed = BallPiles.hop_speed(speed, approach, pressure)
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
	_lasting_speed[one] = NAN
	_lasting_speed[other] = NAN


# After the push of another ball: a ball that lay on something may be lifted off it, or driven into
# it.
func _leave_support(index: int) -> void:
	_left_surface[index] = NOTHING
	var surface := _support[index]
	if surface == NOTHING or surface == ON_BALLS:
		return
	_touched_feature[index] = _rolled_end[index]
	if surface >= 0 and _rolled_end[index] == Impact.Feature.LINE:
		_touched_feature[index] = _segments.nearest_feature(surface, _x[index], _y[index])
	_find_contact(index, surface)
	var speed := _velocity_x[index] * _normal_x + _velocity_y[index] * _normal_y
	var pressure := -(_gravity_x * _normal_x + _gravity_y * _normal_y)
	var is_slow := _bounciness < 1.0 and -speed <= 0.5 * pressure * BallPiles.LEAST_HOP
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
