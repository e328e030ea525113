class_name PartnerForecast
extends TouchForecast
## The next event of each ball: its touch of a wall or a segment, or an impact with another ball,
## whichever comes first.
##
## Each ball has one event at a time (Lubachevsky, How to Simulate Billiards and Similar Systems,
## 1991). Two balls that are to meet have the same one. When a ball finds an earlier partner, the
## partner it takes away from a third ball leaves that one a note to look again at the time of the
## lost impact. A ball that will do something else before a possible impact is no partner: it looks
## again when it has done so, and finds the impact then.

# From so many balls on, each looks only around its own cell.
const _MANY_BALLS := 16

var _queue := EventQueue.new()
var _cells := BallCells.new()
var _uses_cells := false
var _balls_there := 0

# The event of each ball; its time stands in the queue.
var _event_kind: PackedInt32Array = []
var _event_with: PackedInt32Array = []
var _cross_time: PackedFloat64Array = []

# The ball that is looking for a partner: where it is now, and what it has found.
var _asker := 0
var _asker_x := 0.0
var _asker_y := 0.0
var _asker_velocity_x := 0.0
var _asker_velocity_y := 0.0
var _asker_radius := 0.0
var _partner := NOTHING
var _partner_seconds := INF


## When the present flight of a ball ends, in seconds; INF if nothing ever happens to it. It may end
## earlier, where another ball is changed from outside.
func flight_end(index: int) -> float:
	return minf(_queue.times[index], _touch_time[index])


# Works out all that is next for a ball whose flight begins now.
func _forecast(index: int) -> void:
	_forecast_touch(index)
	if _uses_cells:
		_forecast_crossing(index)
	_forecast_event(index)


# When a ball comes into another cell, from where it is now.
func _forecast_crossing(index: int) -> void:
	var flown := (time - _start[index]) + (_time_low - _start_low[index])
	var pull_x := _pull_x[index]
	var pull_y := _pull_y[index]
	var velocity_x := _velocity_x[index] + pull_x * flown
	var velocity_y := _velocity_y[index] + pull_y * flown
	var x := _x[index] + 0.5 * (_velocity_x[index] + velocity_x) * flown
	var y := _y[index] + 0.5 * (_velocity_y[index] + velocity_y) * flown
	var seconds := _cells.time_to_leave(index, x, y, velocity_x, velocity_y, pull_x, pull_y)
	_cross_time[index] = time + seconds


# Chooses the ball's next event, and takes its partner away from others where it is another ball.
func _forecast_event(index: int) -> void:
	_release_partner(index)
	var event_time := _touch_time[index]
	var low := _touch_low[index]
	var kind := _touch_kind[index]
	var with := _touched[index]
	if _uses_cells and _cross_time[index] < event_time:
		event_time = _cross_time[index]
		low = _time_low
		kind = CROSS
		with = NOTHING
	if _balls_there > 1:
		_find_partner(index, (event_time - time) + (low - _time_low))
		if _partner >= 0:
			var sum := time + _partner_seconds
			var part := sum - time
			low = (time - (sum - part)) + (_partner_seconds - part) + _time_low
			event_time = sum + low
			low -= event_time - sum
			kind = MEET
			with = _partner
			_release_partner(with)
			_set_event(with, event_time, low, MEET, index)
	_set_event(index, event_time, low, kind, with)


func _set_event(index: int, event_time: float, low: float, kind: int, with: int) -> void:
	_event_kind[index] = kind
	_event_with[index] = with
	_queue.change(index, event_time, low)


# The other ball of an impact that is off looks again at the time at which it would have been.
func _release_partner(index: int) -> void:
	if _event_kind[index] == MEET:
		_event_kind[_event_with[index]] = LOOK_AGAIN


# The ball with which this one collides first, within so many seconds from now.
func _find_partner(index: int, horizon: float) -> void:
	var flown := (time - _start[index]) + (_time_low - _start_low[index])
	_asker = index
	_asker_velocity_x = _velocity_x[index] + _pull_x[index] * flown
	_asker_velocity_y = _velocity_y[index] + _pull_y[index] * flown
	_asker_x = _x[index] + 0.5 * (_velocity_x[index] + _asker_velocity_x) * flown
	_asker_y = _y[index] + 0.5 * (_velocity_y[index] + _asker_velocity_y) * flown
	_asker_radius = _radius[index]
	_partner = NOTHING
	_partner_seconds = horizon
	if not _uses_cells:
		for other in _x.size():
			if _is_there[other] == 1:
				_try_partner(other)
		return
	var first := _cells.first
	var next := _cells.next
	var neighbors := _cells.neighbors
	var around := 9 * _cells.cell[index]
	for place in range(around, around + 9):
		var other := first[neighbors[place]]
		while other >= 0:
			_try_partner(other)
			other = next[other]


# Takes the other ball as partner if both meet before all that was found. As StraightImpact does it,
# with the cheapest reasons against it first.
func _try_partner(other: int) -> void:
	var flown := (time - _start[other]) + (_time_low - _start_low[other])
	var pull_x := _pull_x[other]
	var pull_y := _pull_y[other]
	var end_x := _velocity_x[other] + pull_x * flown
	var end_y := _velocity_y[other] + pull_y * flown
	var dx := _asker_x - (_x[other] + 0.5 * (_velocity_x[other] + end_x) * flown)
	var dy := _asker_y - (_y[other] + 0.5 * (_velocity_y[other] + end_y) * flown)
	var velocity_x := _asker_velocity_x - end_x
	var velocity_y := _asker_velocity_y - end_y
	var reach := _asker_radius + _radius[other]
	pull_x = _pull_x[_asker] - pull_x
	pull_y = _pull_y[_asker] - pull_y
	var seconds := 0.0
	if pull_x == 0.0 and pull_y == 0.0:
		var approach := -(dx * velocity_x + dy * velocity_y)
		if not approach > 0.0:
			return
		var excess := dx * dx + dy * dy - reach * reach
		if excess > 0.0:
			if excess > 2.0 * approach * _partner_seconds:
				return
			var offset := dx * velocity_y - dy * velocity_x
			var speed_squared := velocity_x * velocity_x + velocity_y * velocity_y
			var discriminant := reach * reach * speed_squared - offset * offset
			if not discriminant > 0.0:
				return
			seconds = excess / (approach + sqrt(discriminant))
	elif (
		other != _asker and _meets_under_pull(dx, dy, velocity_x, velocity_y, pull_x, pull_y, reach)
	):
		seconds = _accelerated.time
	else:
		return
	if seconds < _partner_seconds and time + seconds < _queue.times[other]:
		_partner_seconds = seconds
		_partner = other


# One of both lies or slides on something: seen from the other ball it is pulled.
func _meets_under_pull(
	dx: float,
	dy: float,
	velocity_x: float,
	velocity_y: float,
	pull_x: float,
	pull_y: float,
	reach: float
) -> bool:
	_accelerated.set_flight(dx, dy, velocity_x, velocity_y, pull_x, pull_y, reach)
	return _accelerated.with_point(0.0, 0.0, _partner_seconds)


func _float_arrays() -> Array[PackedFloat64Array]:
	return super() + ([_cross_time] as Array[PackedFloat64Array])


func _int_arrays() -> Array[PackedInt32Array]:
	return super() + ([_event_kind, _event_with] as Array[PackedInt32Array])
