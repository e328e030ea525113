class_name BallRolls
extends BallRests
## How a ball that gravity alone holds on the round end of a segment slides over it, without
## friction, until it flies off, comes onto the line, or is back where it started.
##
## [CapSlide] tells where it is at any time, on a circle that no constant pull follows. For the
## search of what it meets on the way it is taken as a chain of short flights under a constant pull,
## each between two exact places.

## A short flight is nowhere farther off the circle than this, in pixels.
const OFF_CIRCLE := 1e-8
## Bounces on an end that are no higher than this, in pixels, are left out: the ball slides.
const LOWEST_HOP := 1e-9
## A ball this near to the line, in seconds, is on it.
const LINE_TIME := 1e-9

# The slide of each ball on an end, and when it began.
var _rolls: Array[CapSlide] = []
var _roll_start: PackedFloat64Array = []
var _roll_start_low: PackedFloat64Array = []
# Seconds until the ball comes onto the line; INF if the slide ends before.
var _line_time: PackedFloat64Array = []


# Whether bounces that leave a round end with this normal speed are over: the normal must be known.
func _is_hop_over(index: int, speed: float, pressure: float) -> bool:
	var pressed := pressure - _pull_around(index)
	return pressed > 0.0 and speed * speed <= 2.0 * pressed * LOWEST_HOP


# How strongly a ball that goes round a point is pulled outwards, in px/s^2.
func _pull_around(index: int) -> float:
	var around := _velocity_x[index] * _normal_y - _velocity_y[index] * _normal_x
	return around * around / _radius[index]


# From now on the ball slides over an end, if gravity holds it there; else it is free.
func _roll(index: int, place: int, feature: Impact.Feature) -> void:
	var roll := CapSlide.new()
	var x := _segments.end_x(place, feature)
	var y := _segments.end_y(place, feature)
	_set_free(index)
	var problem := roll.start(
		x, y, _x[index], _y[index], _velocity_x[index], _velocity_y[index], _gravity_x, _gravity_y
	)
	if problem or roll.end_time == 0.0:
		_never_come_back(index, place)
		return
	_rolls[index] = roll
	_roll_start[index] = time
	_roll_start_low[index] = _time_low
	_support[index] = place
	_rolled_end[index] = feature
	_line_time[index] = _time_to_line(roll, place)
	_begin_piece(index, 0.0)


# When the centre stands over the line, on either side; not where it starts from there.
func _time_to_line(roll: CapSlide, place: int) -> float:
	var found := INF
	for side: float in [-1.0, 1.0]:
		var seconds := roll.time_to_direction(
			side * _segments.normal_x(place), side * _segments.normal_y(place)
		)
		if seconds > LINE_TIME:
			found = minf(found, seconds)
	return found


# One piece of the chain: from the exact place at so many seconds to the one at its end.
func _begin_piece(index: int, seconds: float) -> void:
	var roll := _rolls[index]
	roll.move_to(seconds)
	_x[index] = roll.position_x
	_y[index] = roll.position_y
	_velocity_x[index] = roll.velocity_x
	_velocity_y[index] = roll.velocity_y
	var piece := minf(_piece_seconds(index), minf(roll.end_time, _line_time[index]) - seconds)
	roll.move_to(seconds + piece)
	_pull_x[index] = 2.0 * ((roll.position_x - _x[index]) / piece - _velocity_x[index]) / piece
	_pull_y[index] = 2.0 * ((roll.position_y - _y[index]) / piece - _velocity_y[index]) / piece
	_piece[index] = piece


# A flight with the same start, velocity and end as the slide is off it by jerk t^3 / 40 at most.
# The jerk grows with the speed, so the one at the end of the piece counts.
func _piece_seconds(index: int) -> float:
	var gravity := sqrt(_gravity_x * _gravity_x + _gravity_y * _gravity_y)
	var speed := sqrt(_squared_speed(index))
	var seconds := 0.0
	for estimate in 2:
		var turning := (speed + gravity * seconds) / _radius[index]
		var jerk := (3.0 * gravity + _radius[index] * turning * turning) * turning
		seconds = pow(40.0 * OFF_CIRCLE / maxf(jerk, gravity * OFF_CIRCLE), 1.0 / 3.0)
	return seconds


# A piece is over: the next one begins, or the slide has come to its end.
func _follow_cap(index: int) -> void:
	_restart(index)
	var roll := _rolls[index]
	var place := _support[index]
	var seconds := (time - _roll_start[index]) + (_time_low - _roll_start_low[index])
	var end := minf(roll.end_time, _line_time[index])
	if end - seconds > LINE_TIME:
		_begin_piece(index, seconds)
		return
	roll.move_to(end)
	_x[index] = roll.position_x
	_y[index] = roll.position_y
	_velocity_x[index] = roll.velocity_x
	_velocity_y[index] = roll.velocity_y
	_end_roll(index, place, roll)


func _end_roll(index: int, place: int, roll: CapSlide) -> void:
	var feature := _rolled_end[index] as Impact.Feature
	_set_free(index)
	if _is_over_line(index, place):
		_find_normal(index, place)
		_put_on(index, place)
	elif roll.ending == CapSlide.Ending.RETURNS:
		_roll(index, place, feature)
	else:
		_find_end_normal(index, place, feature)
		_end_event(index, place, _begin_event(index), WorldEvent.Kind.LEAVE)
		_never_come_back(index, place)


# Whether the ball has come from the end onto the line, or back to it, and gravity presses it there.
func _is_over_line(index: int, place: int) -> bool:
	var slack := REST_GAP / _segments.length(place)
	var share := _segments.share_of(place, _x[index], _y[index])
	_find_normal(index, place)
	var is_pressed := _gravity_x * _normal_x + _gravity_y * _normal_y < 0.0
	return is_pressed and share >= -slack and share <= 1.0 + slack


# The unit normal of a round end, towards the ball.
func _find_end_normal(index: int, place: int, feature: Impact.Feature) -> void:
	var dx := _x[index] - _segments.end_x(place, feature)
	var dy := _y[index] - _segments.end_y(place, feature)
	var distance := sqrt(dx * dx + dy * dy)
	_normal_x = dx / distance if distance > 0.0 else 0.0
	_normal_y = dy / distance if distance > 0.0 else 0.0


# A ball that has flown off an end falls past the segment.
func _never_come_back(index: int, place: int) -> void:
	_left_surface[index] = place
	_left_speed[index] = INF


func _float_arrays() -> Array[PackedFloat64Array]:
	return super() + ([_roll_start, _roll_start_low, _line_time] as Array[PackedFloat64Array])
