class_name SegmentGrid
extends SegmentCells
## Segments in a uniform grid. A flight is followed from cell to cell, so that the cost of a
## prediction does not grow with the number of segments.
##
## Each cell lists the segments that a ball with its centre in the cell might touch. A straight
## flight goes from cell to cell by Amanatides and Woo, A Fast Voxel Traversal Algorithm, 1987; a
## parabola is cut into pieces of about a cell, and the cells around each piece are looked at. A few
## segments are scanned instead, which is faster and gives the same impact.

# Up to this number of segments are scanned.
const _FEW := 8

# When a straight flight enters and leaves the grid, in seconds from its start.
var _entered := 0.0
var _left := 0.0


## See [method SegmentScan.first_impact].
func first_impact(
	x: float,
	y: float,
	velocity_x: float,
	velocity_y: float,
	radius: float,
	horizon: float,
	skipped: int = -1
) -> bool:
	_ask(x, y, velocity_x, velocity_y, radius, horizon, skipped)
	if size() <= _FEW:
		for place in size():
			_try(place)
		return index >= 0
	_prepare(radius)
	_walk()
	return index >= 0


## See [method SegmentScan.first_accelerated_impact].
func first_accelerated_impact(
	x: float,
	y: float,
	velocity_x: float,
	velocity_y: float,
	pull_x: float,
	pull_y: float,
	radius: float,
	horizon: float,
	skipped: int = -1
) -> bool:
	if size() <= _FEW:
		return super.first_accelerated_impact(
			x, y, velocity_x, velocity_y, pull_x, pull_y, radius, horizon, skipped
		)
	_ask(x, y, velocity_x, velocity_y, radius, horizon, skipped)
	_ask_accelerated(pull_x, pull_y)
	_prepare(radius)
	_follow_parabola()
	_end_contact()
	return index >= 0


# Goes along the straight flight from cell to cell until an impact lies before the next border. The
# number of the cell, and how many are left in each direction, are counted on: a prediction passes
# about six cells. It is one long function because calls cost time: cut in two after the first cell
# is found, a prediction takes 1.05 times as long, and with a function for the borders of both axes
# 1.12 times.
func _walk() -> void:
	_entered = 0.0
	_left = time
	if not _is_between(_low_x, _low_x + _columns * _cell, _x, _velocity_x):
		return
	if not _is_between(_low_y, _low_y + _rows * _cell, _y, _velocity_y):
		return
	var column := clampi(floori((_x + _velocity_x * _entered - _low_x) / _cell), 0, _columns - 1)
	var row := clampi(floori((_y + _velocity_y * _entered - _low_y) / _cell), 0, _rows - 1)
	var cell := row * _columns + column
	# Seconds until the next border is crossed, and from one border to the next.
	var next_x := INF
	var next_y := INF
	var between_x := INF
	var between_y := INF
	var step_x := 1
	var step_y := _columns
	var columns_left := _columns - 1 - column
	var rows_left := _rows - 1 - row
	if _velocity_x > 0.0:
		next_x = (_low_x + (column + 1) * _cell - _x) / _velocity_x
		between_x = _cell / _velocity_x
	elif _velocity_x < 0.0:
		next_x = (_low_x + column * _cell - _x) / _velocity_x
		between_x = -_cell / _velocity_x
		step_x = -1
		columns_left = column
	if _velocity_y > 0.0:
		next_y = (_low_y + (row + 1) * _cell - _y) / _velocity_y
		between_y = _cell / _velocity_y
	elif _velocity_y < 0.0:
		next_y = (_low_y + row * _cell - _y) / _velocity_y
		between_y = -_cell / _velocity_y
		step_y = -_columns
		rows_left = row
	while true:
		_try_cell(cell)
		if next_x < next_y:
			if next_x >= time or columns_left == 0:
				return
			columns_left -= 1
			cell += step_x
			next_x += between_x
		else:
			if next_y >= time or rows_left == 0:
				return
			rows_left -= 1
			cell += step_y
			next_y += between_y


func _try_cell(cell: int) -> void:
	var entry := _first_entry[cell]
	while entry >= 0:
		var place := _entry_segment[entry]
		if _tried[place] != _question:
			_tried[place] = _question
			_try(place)
		entry = _entry_next[entry]


# Narrows the stretch of time in which the flight is in the grid to the one in which a coordinate is
# between two borders; false if it never is.
func _is_between(low: float, high: float, from: float, velocity: float) -> bool:
	if velocity == 0.0:
		return from >= low and from <= high
	var one := (low - from) / velocity
	var other := (high - from) / velocity
	_entered = maxf(_entered, minf(one, other))
	_left = minf(_left, maxf(one, other))
	return _entered <= _left


# Cuts the parabola into pieces of about a cell, and looks at the cells around each.
func _follow_parabola() -> void:
	var pull := absf(_pull_x) + absf(_pull_y)
	var begin := 0.0
	while begin < time:
		var x := _x + (_velocity_x + 0.5 * _pull_x * begin) * begin
		var y := _y + (_velocity_y + 0.5 * _pull_y * begin) * begin
		if not _is_inside(x, y):
			begin = _next_entrance(begin)
			if not begin < time:
				return
		var speed := absf(_velocity_x + _pull_x * begin) + absf(_velocity_y + _pull_y * begin)
		# In this time it moves by at most two cells. If it never moves, one look is enough.
		var step := 2.0 * _cell / (speed + sqrt(2.0 * _cell * pull))
		if not step < INF:
			step = 0.0
		var end := minf(begin + step, time)
		_try_around_piece(begin, end)
		if end <= begin:
			return
		begin = end


func _try_around_piece(begin: float, end: float) -> void:
	var x_range := _range_of(_x, _velocity_x, _pull_x, begin, end)
	var y_range := _range_of(_y, _velocity_y, _pull_y, begin, end)
	var last_column := mini(floori((x_range[1] - _low_x) / _cell), _columns - 1)
	var last_row := mini(floori((y_range[1] - _low_y) / _cell), _rows - 1)
	for row in range(maxi(floori((y_range[0] - _low_y) / _cell), 0), last_row + 1):
		for column in range(maxi(floori((x_range[0] - _low_x) / _cell), 0), last_column + 1):
			var entry := _first_entry[row * _columns + column]
			while entry >= 0:
				var place := _entry_segment[entry]
				if _tried[place] != _question:
					_tried[place] = _question
					_try_accelerated(place)
				entry = _entry_next[entry]


# The smallest and the largest coordinate in a piece of the flight: at its ends, or where it turns.
func _range_of(
	from: float, velocity: float, pull: float, begin: float, end: float
) -> PackedFloat64Array:
	var one := from + (velocity + 0.5 * pull * begin) * begin
	var other := from + (velocity + 0.5 * pull * end) * end
	var smallest := minf(one, other)
	var largest := maxf(one, other)
	if pull != 0.0:
		var turn := -velocity / pull
		if turn > begin and turn < end:
			var extreme := from + 0.5 * velocity * turn
			smallest = minf(smallest, extreme)
			largest = maxf(largest, extreme)
	return [smallest, largest]


func _is_inside(x: float, y: float) -> bool:
	var slack := 1e-3 * _cell
	if x < _low_x - slack or x > _low_x + _columns * _cell + slack:
		return false
	return y >= _low_y - slack and y <= _low_y + _rows * _cell + slack


# The first time after `begin` at which the parabola comes to the border of the grid; INF for never.
func _next_entrance(begin: float) -> float:
	var found := INF
	for border: float in [_low_x, _low_x + _columns * _cell]:
		found = minf(found, _entrance(_x - border, _velocity_x, _pull_x, begin))
	for border: float in [_low_y, _low_y + _rows * _cell]:
		found = minf(found, _entrance(_y - border, _velocity_y, _pull_y, begin))
	return found


# The first root of from + velocity t + pull t²/2 after `begin` at which the flight is in the grid.
func _entrance(from: float, velocity: float, pull: float, begin: float) -> float:
	var found := INF
	for root: float in Quadratic.roots(0.5 * pull, velocity, from):
		if root > begin and root < found:
			var x := _x + (_velocity_x + 0.5 * _pull_x * root) * root
			var y := _y + (_velocity_y + 0.5 * _pull_y * root) * root
			if _is_inside(x, y):
				found = root
	return found


## See [method SegmentScan.places_near].
func places_near(x: float, y: float, ball_radius: float) -> PackedInt32Array:
	if size() <= _FEW:
		return super.places_near(x, y, ball_radius)
	_prepare(ball_radius)
	var places: PackedInt32Array = []
	var column := clampi(floori((x - _low_x) / _cell), 0, _columns - 1)
	var row := clampi(floori((y - _low_y) / _cell), 0, _rows - 1)
	var entry := _first_entry[row * _columns + column]
	while entry >= 0:
		if _is_there[_entry_segment[entry]] == 1:
			places.append(_entry_segment[entry])
		entry = _entry_next[entry]
	places.sort()
	return places
