class_name LineEndsLayout
## Where the five fields and the graph lie on the board: the capped field large where there is room,
## else all six in two columns.

## A board narrower than this, in pixels, has two equal columns.
const NARROW := 620.0
const _GAP := 8.0


## Six rectangles in a board of [param size] pixels: the fields in the order of
## [enum LineEndsModel.Field], then the graph.
static func places(size: Vector2) -> Array[Rect2]:
	return _in_two_columns(size) if size.x < NARROW else _with_large_field(size)


static func _in_two_columns(size: Vector2) -> Array[Rect2]:
	var found: Array[Rect2] = []
	var cell := Vector2((size.x - 3.0 * _GAP) / 2.0, (size.y - 4.0 * _GAP) / 3.0)
	for i in 6:
		var corner := Vector2(i % 2, floori(i / 2.0)) * (cell + Vector2(_GAP, _GAP))
		found.append(Rect2(corner + Vector2(_GAP, _GAP), cell))
	return found


static func _with_large_field(size: Vector2) -> Array[Rect2]:
	var found: Array[Rect2] = []
	var cell := Vector2((size.x - 4.0 * _GAP) / 4.0, (size.y - 3.0 * _GAP) / 2.0)
	for i in 4:
		var corner := Vector2(i % 2, floori(i / 2.0)) * (cell + Vector2(_GAP, _GAP))
		found.append(Rect2(corner + Vector2(_GAP, _GAP), cell))
	var left := 2.0 * cell.x + 3.0 * _GAP
	var graph_height := minf(size.y * 0.32, 200.0)
	var wide := size.x - left - _GAP
	var high := size.y - graph_height - 3.0 * _GAP
	found.append(Rect2(left, _GAP, wide, high))
	found.append(Rect2(left, high + 2.0 * _GAP, wide, graph_height))
	return found
