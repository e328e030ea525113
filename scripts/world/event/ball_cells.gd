class_name BallCells
extends RefCounted
## Which balls are near a ball: the plane is laid out in square cells, each with a list of its
## balls. No cell is smaller than the largest ball, so a ball can touch only balls in its own cell
## and the eight around it.
##
## The plane has no end, but the table has: cells whose columns or rows differ by a multiple of the
## table's size share an entry. So some balls are looked at in vain; no answer changes.

# A table has at least this many columns, so that the nine cells around a ball are nine entries.
const _FEWEST_COLUMNS := 4

## The edge of a cell, in pixels.
var size := 1.0
## How many columns and rows the table has.
var columns := 0
## The first ball of each cell, -1 for none.
var first: PackedInt32Array = []
## The ball behind each ball in its cell, -1 for none.
var next: PackedInt32Array = []
## Nine cells for each cell: itself and those around it.
var neighbors: PackedInt32Array = []
## The cell of each ball.
var cell: PackedInt32Array = []
## Which border each ball crosses next: -1 or 1 for a column, -2 or 2 for a row.
var border: PackedInt32Array = []
## The nine cells around a ball, as places in [member neighbors].
var all_neighbors: PackedInt32Array = [0, 1, 2, 3, 4, 5, 6, 7, 8]
## Of the nine cells around a ball, the three that were not around it before it crossed a border, as
## places in [member neighbors]: for each of the borders from -2 to 2.
var new_neighbors: Array[PackedInt32Array] = [
	PackedInt32Array([0, 1, 2]),
	PackedInt32Array([0, 3, 6]),
	PackedInt32Array(),
	PackedInt32Array([2, 5, 8]),
	PackedInt32Array([6, 7, 8]),
]

var _previous: PackedInt32Array = []
# Column and row of each ball in the plane, of any size and sign.
var _column: PackedInt64Array = []
var _row: PackedInt64Array = []


## The edge of cells for these balls, in pixels: about one ball a cell, and no cell smaller than the
## largest ball. Of each ball x and y of its centre, its radius, and 1 where there is one.
static func size_for(
	places: PackedFloat64Array, radii: PackedFloat64Array, is_there: PackedByteArray
) -> float:
	var low := Vec2.new(INF, INF)
	var high := Vec2.new(-INF, -INF)
	var largest := 0.0
	for ball in is_there.size():
		if is_there[ball] == 1:
			var x := places[2 * ball]
			var y := places[2 * ball + 1]
			low.set_xy(minf(low.x, x), minf(low.y, y))
			high.set_xy(maxf(high.x, x), maxf(high.y, y))
			largest = maxf(largest, radii[ball])
	var area := (high.x - low.x) * (high.y - low.y)
	return maxf(2.0 * largest, sqrt(area / is_there.count(1)))


## Makes an empty table for this many balls, with cells of [param new_size] pixels.
func lay_out(new_size: float, balls: int) -> void:
	size = new_size
	columns = _FEWEST_COLUMNS
	while columns * columns < balls:
		columns *= 2
	first.resize(columns * columns)
	first.fill(-1)
	cell.clear()
	make_room(balls)
	_find_neighbors()


## Makes room for this many balls; new ones are in no cell.
func make_room(balls: int) -> void:
	var old := cell.size()
	for numbers: PackedInt32Array in [next, _previous, cell, border]:
		numbers.resize(balls)
	_column.resize(balls)
	_row.resize(balls)
	for ball in range(old, balls):
		cell[ball] = -1


## Takes the layout of a snapshot, whose [method arrays] are put back next.
func take_layout(old_size: float, old_columns: int) -> void:
	size = old_size
	if columns != old_columns:
		columns = old_columns
		_find_neighbors()


## Enters a ball with its centre at this place.
func put(ball: int, x: float, y: float) -> void:
	_column[ball] = floori(x / size)
	_row[ball] = floori(y / size)
	_enter(ball)


## Takes a ball out; one that is in no cell stays so.
func remove(ball: int) -> void:
	if cell[ball] < 0:
		return
	if _previous[ball] >= 0:
		next[_previous[ball]] = next[ball]
	else:
		first[cell[ball]] = next[ball]
	if next[ball] >= 0:
		_previous[next[ball]] = _previous[ball]
	cell[ball] = -1


## Seconds until a ball with this flight leaves its cell; notes over which border.
func time_to_leave(
	ball: int,
	x: float,
	y: float,
	velocity_x: float,
	velocity_y: float,
	pull_x: float,
	pull_y: float
) -> float:
	var column := INF
	var row := INF
	if pull_x == 0.0 and pull_y == 0.0:
		# The steps of _time_to_border, written out for the commonest case.
		if velocity_x > 0.0:
			column = maxf(((_column[ball] + 1) * size - x) / velocity_x, 0.0)
		elif velocity_x < 0.0:
			column = maxf((_column[ball] * size - x) / velocity_x, 0.0)
		if velocity_y > 0.0:
			row = maxf(((_row[ball] + 1) * size - y) / velocity_y, 0.0)
		elif velocity_y < 0.0:
			row = maxf((_row[ball] * size - y) / velocity_y, 0.0)
	else:
		column = _time_to_border(_column[ball], x, velocity_x, pull_x)
		row = _time_to_border(_row[ball], y, velocity_y, pull_y)
	if column <= row:
		border[ball] = 1 if velocity_x + pull_x * column > 0.0 else -1
		return column
	border[ball] = 2 if velocity_y + pull_y * row > 0.0 else -2
	return row


## Moves a ball over the border that [method time_to_leave] has noted: out of one list and into
## another. The steps of [method remove] and [method put] are written out: among 1000 balls nothing
## happens more often.
func cross(ball: int) -> void:
	var old := cell[ball]
	var before := _previous[ball]
	var after := next[ball]
	if before >= 0:
		next[before] = after
	else:
		first[old] = after
	if after >= 0:
		_previous[after] = before
	var over := border[ball]
	var place := old
	if over == 1 or over == -1:
		_column[ball] += over
		place = neighbors[9 * old + 4 + over]
	else:
		over >>= 1
		_row[ball] += over
		place = neighbors[9 * old + 4 + 3 * over]
	var pushed := first[place]
	cell[ball] = place
	_previous[ball] = -1
	next[ball] = pushed
	first[place] = ball
	if pushed >= 0:
		_previous[pushed] = ball


## All arrays that change while balls move, to be kept and put back.
func arrays() -> Array:
	return [first, next, cell, _previous, _column, _row, border]


func _enter(ball: int) -> void:
	var place := posmod(_row[ball], columns) * columns + posmod(_column[ball], columns)
	cell[ball] = place
	_previous[ball] = -1
	next[ball] = first[place]
	if first[place] >= 0:
		_previous[first[place]] = ball
	first[place] = ball


# The first time at which the coordinate crosses a border of its cell outwards.
func _time_to_border(line: int, from: float, velocity: float, pull: float) -> float:
	if pull == 0.0:
		if velocity > 0.0:
			return maxf(((line + 1) * size - from) / velocity, 0.0)
		if velocity < 0.0:
			return maxf((line * size - from) / velocity, 0.0)
		return INF
	var below := FreeFlight.time_to_fall(from - line * size, velocity, pull)
	var above := FreeFlight.time_to_fall((line + 1) * size - from, -velocity, -pull)
	return minf(below, above)


func _find_neighbors() -> void:
	neighbors.clear()
	for row in columns:
		for column in columns:
			for down: int in [-1, 0, 1]:
				for across: int in [-1, 0, 1]:
					var other_row := posmod(row + down, columns)
					neighbors.append(other_row * columns + posmod(column + across, columns))
