@tool
class_name LineEndsLayout
extends Container
## Arranges the five fields and the graph: the capped field large where there is room, else all six
## in two columns. Its children are the fields in the order of [enum LineEndsModel.Field], then the
## graph.

## A board narrower than this, in pixels, has two equal columns.
const NARROW := 620.0
const _GAP := 8.0


func _notification(what: int) -> void:
	if what == NOTIFICATION_SORT_CHILDREN:
		var places := _in_two_columns() if size.x < NARROW else _with_large_field()
		for i in mini(places.size(), get_child_count()):
			fit_child_in_rect(get_child(i) as Control, places[i])


func _in_two_columns() -> Array[Rect2]:
	var found: Array[Rect2] = []
	var cell := Vector2((size.x - 3.0 * _GAP) / 2.0, (size.y - 4.0 * _GAP) / 3.0)
	for i in 6:
		var corner := Vector2(i % 2, floori(i / 2.0)) * (cell + Vector2(_GAP, _GAP))
		found.append(Rect2(corner + Vector2(_GAP, _GAP), cell))
	return found


func _with_large_field() -> Array[Rect2]:
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
