@tool
class_name LineEndsLayout
extends Container
## Arranges the fields and the graph: the field that the step is about is large, the other ones that
## can be seen are small. Its children are the fields in the order of [enum LineEndsModel.Field],
## then the graph, which lies below the large field. A narrow board has room for one small row only:
## with more fields all are equally large.

## On a board narrower than this, in pixels, the small fields lie below the large one.
const NARROW := 620.0
const _GAP := 8.0
# Between the words of a field and the title of the one below.
const _ROW_GAP := 24.0
# What the large field and the graph take of the board.
const _LARGE_SHARE := 0.56
const _GRAPH_SHARE := 0.32
const _HIGHEST_GRAPH := 200.0

## The place of the large field among the children.
@export_range(0, 4) var active := 4:
	set(value):
		active = value
		queue_sort()


func _notification(what: int) -> void:
	if what != NOTIFICATION_SORT_CHILDREN:
		return
	var small := _small_ones()
	var board := Rect2(Vector2.ZERO, size).grow(-_GAP)
	var large := board
	if size.x < NARROW and small.size() > 2:
		_lay_in_columns(small + _large_ones(), board, 2)
		return
	if size.x < NARROW:
		if small:
			large = board.grow_side(SIDE_BOTTOM, -board.size.y * (1.0 - _LARGE_SHARE))
			_lay_in_columns(small, _below(large, board), small.size())
	elif small:
		large = board.grow_side(SIDE_LEFT, -board.size.x * (1.0 - _LARGE_SHARE))
		_lay_in_columns(small, _left_of(large, board), 1 if small.size() < 3 else 2)
	_lay_large(large)


# The fields that can be seen, without the large one.
func _small_ones() -> Array[Control]:
	var found: Array[Control] = []
	for i in get_child_count() - 1:
		var field := get_child(i) as Control
		if i != active and field.visible:
			found.append(field)
	return found


# The field that the step is about, and the graph if it can be seen.
func _large_ones() -> Array[Control]:
	var found: Array[Control] = [get_child(active) as Control]
	var graph := get_child(-1) as Control
	if graph.visible:
		found.append(graph)
	return found


func _lay_large(place: Rect2) -> void:
	var graph := get_child(-1) as Control
	var high := place.size.y
	if graph.visible:
		var graph_height := minf(size.y * _GRAPH_SHARE, _HIGHEST_GRAPH)
		high -= graph_height + _GAP
		var corner := Vector2(place.position.x, place.end.y - graph_height)
		fit_child_in_rect(graph, Rect2(corner, Vector2(place.size.x, graph_height)))
	fit_child_in_rect(
		get_child(active) as Control, Rect2(place.position, Vector2(place.size.x, high))
	)


func _lay_in_columns(fields: Array[Control], place: Rect2, columns: int) -> void:
	var rows := ceilf(float(fields.size()) / columns)
	var gaps := Vector2(columns - 1, rows - 1.0) * Vector2(_GAP, _ROW_GAP)
	var cell := (place.size - gaps) / Vector2(columns, rows)
	for i in fields.size():
		var corner := (
			Vector2(i % columns, floori(float(i) / columns)) * (cell + Vector2(_GAP, _ROW_GAP))
		)
		fit_child_in_rect(fields[i], Rect2(place.position + corner, cell))


static func _below(large: Rect2, board: Rect2) -> Rect2:
	return board.grow_side(SIDE_TOP, -large.size.y - _GAP)


static func _left_of(large: Rect2, board: Rect2) -> Rect2:
	return board.grow_side(SIDE_RIGHT, -large.size.x - _GAP)
