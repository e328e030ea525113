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

# Shorter by some last places.
const _JUST_CLEAR := 1.0 - 1.0 / 2.0 ** 46

# The nine cells around a ball, as places in [member BallCells.neighbors].
var _all_neighbors: PackedInt32Array = [0, 1, 2, 3, 4, 5, 6, 7, 8]
var _gravity_x := 0.0
var _gravity_y := 0.0
var _queue := EventQueue.new()
var _cells := BallCells.new()
var _uses_cells := false
var _balls_there := 0

# The event of each ball, wherever it will be by then. In the queue stands when it comes into
# another cell, if that is earlier.
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
	if _balls_there > 1:
		_ask(index)
		if _uses_cells:
			_forecast_crossing(index)
	_choose_event(index)


# When the ball that was asked about last comes into another cell.
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


# A ball comes into another cell: of the nine around it now three are new, and only their balls can
# be met before what was foreseen.
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


# Looks for a partner once more, while the flight goes on.
func _forecast_event(index: int) -> void:
	_ask(index)
	_choose_event(index)


# Chooses the next event of the ball that was asked about last, and takes its partner away from
# others where it is another ball.
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


# The ball and the partner that it has found will do nothing before they meet.
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


# The other ball of an impact that is off looks again at the time at which it would have been.
func _release_partner(index: int) -> void:
	if _event_kind[index] == MEET:
		_event_kind[_event_with[index]] = LOOK_AGAIN


# Where the ball is now that looks for a partner.
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
		_try_cells(9 * _cells.cell[index], _all_neighbors)
		return
	for other in _x.size():
		if _is_there[other] == 1:
			_try_partner(other)


# All balls of these cells. Where nothing pulls, what [method _try_partner] does is written out: a
# world of many balls spends most of its time here. A test compares both ways to the last bit.
func _try_cells(around: int, cells: PackedInt32Array) -> void:
	var first := _cells.first
	var next := _cells.next
	var neighbors := _cells.neighbors
	var is_pulled := _gravity_x != 0.0 or _gravity_y != 0.0
	for place in cells:
		var other := first[neighbors[around + place]]
		while other >= 0:
			if is_pulled:
				_try_partner(other)
				other = next[other]
				continue
			var flown := (time - _start[other]) + (_time_low - _start_low[other])
			var velocity_x := _velocity_x[other]
			var velocity_y := _velocity_y[other]
			var dx := _asker_x - _x[other] - velocity_x * flown
			var dy := _asker_y - _y[other] - velocity_y * flown
			velocity_x = _asker_velocity_x - velocity_x
			velocity_y = _asker_velocity_y - velocity_y
			var approach := -(dx * velocity_x + dy * velocity_y)
			if approach > 0.0:
				var reach := _asker_radius + _radius[other]
				var excess := dx * dx + dy * dy - reach * reach
				if excess <= 0.0:
					_take_partner(other, 0.0)
				elif excess <= 2.0 * approach * _partner_seconds:
					var offset := dx * velocity_y - dy * velocity_x
					var speed_squared := velocity_x * velocity_x + velocity_y * velocity_y
					var discriminant := reach * reach * speed_squared - offset * offset
					if discriminant > 0.0:
						_take_partner(other, excess / (approach + sqrt(discriminant)))
			other = next[other]


# Takes the other ball as partner if both meet before all that was found, as StraightImpactFinder does it.
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
			if _meets_under_pull(dx, dy, velocity_x, velocity_y, pull_x, pull_y, reach):
				_take_partner(other, _accelerated.time)
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
	var distance := sqrt(dx * dx + dy * dy)
	# As SegmentScan does it for a ball that lies on something.
	if absf(distance - reach) <= SegmentScan.TOUCH:
		var away := (velocity_x * dx + velocity_y * dy) / distance
		var around := (velocity_x * dy - velocity_y * dx) / distance
		var inwards := -(pull_x * dx + pull_y * dy) / distance - around * around / distance
		if inwards > 0.0 and away * away <= 2.0 * inwards * SegmentScan.TOUCH:
			_accelerated.time = 2.0 * maxf(away, 0.0) / inwards
			return true
		if away > 0.0:
			# Taken as just clear of each other, which spares the question whether they are.
			reach = distance * _JUST_CLEAR
	_accelerated.set_flight(dx, dy, velocity_x, velocity_y, pull_x, pull_y, reach)
	return _accelerated.with_point(0.0, 0.0, _partner_seconds)


func _float_arrays() -> Array[PackedFloat64Array]:
	return super() + ([_event_time, _event_low, _cross_time] as Array[PackedFloat64Array])


func _int_arrays() -> Array[PackedInt32Array]:
	return super() + ([_event_kind, _event_with] as Array[PackedInt32Array])
