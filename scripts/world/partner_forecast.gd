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

# The event of each ball, wherever it will be by then. In the queue stands when it comes into another
# cell, if that is earlier.
var _event_time: PackedFloat64Array = []
var _event_low: PackedFloat64Array = []
var _event_kind: PackedInt32Array = []
var _event_with: PackedInt32Array = []
var _cross_time: PackedFloat64Array = []

# The ball that is looking for a partner: where it is now, and what it has found.
var _asker := 0
var _asker_x := 0.0
var _asker_y := 0.0
var _asker_velocity_x := 0.0
var _asker_velocity_y := 0.0
var _asker_pull_x := 0.0
var _asker_pull_y := 0.0
var _asker_radius := 0.0
var _partner := NOTHING
var _partner_seconds := INF


## When the present flight of a ball ends, in seconds; INF if nothing ever happens to it. It may end
## earlier, where another ball is changed from outside.
func flight_end(index: int) -> float:
	return minf(_event_time[index], _touch_time[index])


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


# A ball comes into another cell: of the nine around it now three are new, and only their balls can
# be met before what was foreseen.
func _cross(index: int) -> void:
	_cells.cross(index)
	var new_neighbors := _cells.new_neighbors(index)
	_forecast_crossing(index)
	var horizon := (_event_time[index] - time) + (_event_low[index] - _time_low)
	_ask(index, horizon)
	var first := _cells.first
	var next := _cells.next
	var neighbors := _cells.neighbors
	var around := 9 * _cells.cell[index]
	for place in new_neighbors:
		var other := first[neighbors[around + place]]
		while other >= 0:
			_try_partner(other)
			other = next[other]
	if _partner >= 0:
		_release_partner(index)
		_meet_partner(index)
	else:
		_queue.change(index, minf(_event_time[index], _cross_time[index]))


# Chooses the ball's next event, and takes its partner away from others where it is another ball.
func _forecast_event(index: int) -> void:
	_release_partner(index)
	if _balls_there > 1:
		_ask(index, (_touch_time[index] - time) + (_touch_low[index] - _time_low))
		_try_all_partners(index)
		if _partner >= 0:
			_meet_partner(index)
			return
	_set_event(index, _touch_time[index], _touch_low[index], _touch_kind[index], _touched[index])


# The ball and the partner that it has found will do nothing before they meet.
func _meet_partner(index: int) -> void:
	var event_time := time + _partner_seconds
	var part := event_time - time
	var low := (time - (event_time - part)) + (_partner_seconds - part) + _time_low
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
	_queue.change(index, event_time)


# The other ball of an impact that is off looks again at the time at which it would have been.
func _release_partner(index: int) -> void:
	if _event_kind[index] == MEET:
		_event_kind[_event_with[index]] = LOOK_AGAIN


# Where the ball is now that looks for a partner, to be met within so many seconds.
func _ask(index: int, horizon: float) -> void:
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
	_partner_seconds = horizon


func _try_all_partners(index: int) -> void:
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
	var velocity_x := _velocity_x[other]
	var velocity_y := _velocity_y[other]
	var dx := _asker_x - _x[other]
	var dy := _asker_y - _y[other]
	if pull_x == 0.0 and pull_y == 0.0:
		dx -= velocity_x * flown
		dy -= velocity_y * flown
	else:
		dx -= (velocity_x + 0.5 * pull_x * flown) * flown
		dy -= (velocity_y + 0.5 * pull_y * flown) * flown
		velocity_x += pull_x * flown
		velocity_y += pull_y * flown
	velocity_x = _asker_velocity_x - velocity_x
	velocity_y = _asker_velocity_y - velocity_y
	var reach := _asker_radius + _radius[other]
	var seconds := 0.0
	if pull_x == _asker_pull_x and pull_y == _asker_pull_y:
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
		other != _asker
		and _meets_under_pull(
			dx, dy, velocity_x, velocity_y, _asker_pull_x - pull_x, _asker_pull_y - pull_y, reach
		)
	):
		seconds = _accelerated.time
	else:
		return
	if seconds < _partner_seconds and time + seconds < _event_time[other]:
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
	return super() + ([_event_time, _event_low, _cross_time] as Array[PackedFloat64Array])


func _int_arrays() -> Array[PackedInt32Array]:
	return super() + ([_event_kind, _event_with] as Array[PackedInt32Array])
