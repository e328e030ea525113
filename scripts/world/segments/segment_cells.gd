class_name SegmentCells
extends SegmentScan
## The cells of a uniform grid, each with the segments that a ball with its centre in the cell might
## touch. They are laid out at the first question about a flight, and again after a change.

# The edge of a cell as a share of the one that would give each segment a cell of its own.
const _CELL_SHARE := 0.5
# A segment is entered a little beyond the reach of the largest ball, by this share of a cell: then
# rounding at the border of a cell cannot hide it.
const _MARGIN := 1e-6

var _cell := 1.0
var _low_x := 0.0
var _low_y := 0.0
var _columns := 0
var _rows := 0
var _reach := 0.0
var _is_stale := true
# Linked lists: the first entry of each cell, and for each entry its segment and the next entry.
var _first_entry: PackedInt32Array = []
var _entry_segment: PackedInt32Array = []
var _entry_next: PackedInt32Array = []
# Counts the questions: a segment that is in several cells is tried once for each question.
var _question := 0
var _tried: PackedInt64Array = []


## See [method SegmentScan.put].
func put(place: int, new_segment: LineSegment) -> void:
	super.put(place, new_segment)
	_is_stale = true


func _prepare(radius: float) -> void:
	if _is_stale or radius > _reach:
		_build(maxf(radius, _reach))
	_question += 1


func _build(reach: float) -> void:
	_is_stale = false
	_reach = reach
	_lay_out()
	_first_entry.resize(_columns * _rows)
	_first_entry.fill(-1)
	_entry_segment.clear()
	_entry_next.clear()
	_tried.resize(size())
	_tried.fill(0)
	for place in size():
		if _is_there[place] == 1:
			_enter(place)


# Chooses the place of the grid and the size of its cells.
func _lay_out() -> void:
	_low_x = INF
	_low_y = INF
	var high_x := -INF
	var high_y := -INF
	for place in size():
		if _is_there[place] == 1:
			_low_x = minf(_low_x, minf(_start_x[place], _end_x[place]))
			_low_y = minf(_low_y, minf(_start_y[place], _end_y[place]))
			high_x = maxf(high_x, maxf(_start_x[place], _end_x[place]))
			high_y = maxf(high_y, maxf(_start_y[place], _end_y[place]))
	if not _low_x < INF:
		_low_x = 0.0
		_low_y = 0.0
		high_x = 0.0
		high_y = 0.0
	var width := high_x - _low_x + 2.0 * _reach
	var height := high_y - _low_y + 2.0 * _reach
	_cell = _CELL_SHARE * sqrt(width * height / size())
	# No cell smaller than the largest ball, no more than a few for each segment where all lie in
	# one row, and none so small that places in it could not be told apart.
	var digits := 1e-12 * (absf(_low_x) + absf(_low_y) + absf(high_x) + absf(high_y))
	_cell = maxf(maxf(_cell, _reach), maxf(_CELL_SHARE * maxf(width, height) / size(), digits))
	_low_x -= _reach + _MARGIN * _cell
	_low_y -= _reach + _MARGIN * _cell
	_columns = ceili((high_x + _reach + _MARGIN * _cell - _low_x) / _cell)
	_rows = ceili((high_y + _reach + _MARGIN * _cell - _low_y) / _cell)
	_columns = maxi(_columns, 1)
	_rows = maxi(_rows, 1)


# Lists a segment in all cells that its neighbourhood may touch, row by row.
func _enter(place: int) -> void:
	var reach := _reach + _MARGIN * _cell
	var top := minf(_start_y[place], _end_y[place]) - reach
	var bottom := maxf(_start_y[place], _end_y[place]) + reach
	var first_row := clampi(floori((top - _low_y) / _cell), 0, _rows - 1)
	var last_row := clampi(floori((bottom - _low_y) / _cell), 0, _rows - 1)
	for row in range(first_row, last_row + 1):
		var row_top := _low_y + row * _cell - reach
		var between := _columns_between(place, row_top, row_top + _cell + 2.0 * reach, reach)
		for column in range(between[0], between[1] + 1):
			_entry_segment.append(place)
			_entry_next.append(_first_entry[row * _columns + column])
			_first_entry[row * _columns + column] = _entry_segment.size() - 1


# The first and the last column that the part of a segment between two heights reaches.
func _columns_between(place: int, top: float, bottom: float, reach: float) -> PackedInt32Array:
	var one := _start_x[place]
	var other := _end_x[place]
	var rise := _end_y[place] - _start_y[place]
	if rise != 0.0:
		var slope := (other - one) / rise
		var at_top := _start_x[place] + (top - _start_y[place]) * slope
		var at_bottom := _start_x[place] + (bottom - _start_y[place]) * slope
		var smallest := maxf(minf(one, other), minf(at_top, at_bottom))
		var largest := minf(maxf(one, other), maxf(at_top, at_bottom))
		one = minf(smallest, largest)
		other = maxf(smallest, largest)
	var first := floori((minf(one, other) - reach - _low_x) / _cell)
	var last := floori((maxf(one, other) + reach - _low_x) / _cell)
	return [clampi(first, 0, _columns - 1), clampi(last, 0, _columns - 1)]
