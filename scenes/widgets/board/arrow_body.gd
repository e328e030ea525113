@tool
class_name ArrowBody
extends Handle
## The shaft of an arrow as a handle: dragging it moves the arrow as it is, without turning it.

## Pixels beside the shaft that still count as touching it.
const REACH := 27.0

var _along := Vec2.new()


## Lies along the arrow from [param tail] to [param head]; asks to be moved by its tail.
func place_between(tail: Vec2, head: Vec2) -> void:
	_along = head.minus(tail)
	place(tail)


func _has_point(pixel: Vector2) -> bool:
	var shaft := _shaft()
	var nearest := Geometry2D.get_closest_point_to_segment(pixel, shaft[0], shaft[1])
	return pixel.distance_to(nearest) <= REACH and not _is_on_a_point(pixel)


func _draw() -> void:
	if Engine.is_editor_hint():
		return
	var shaft := _shaft()
	if has_focus():
		draw_line(shaft[0], shaft[1], Color(Palette.drawn(Palette.FOCUS), 0.35), 16.0)
	elif _is_hovered or _is_dragged:
		draw_line(shaft[0], shaft[1], Color(Palette.color(role), 0.15), 16.0)


func _follow_view() -> void:
	if Engine.is_editor_hint():
		return
	position = Vector2.ZERO
	size = _board.size
	queue_redraw()


# Heads and tails, also those of other arrows, come before the shaft on which they lie.
func _is_on_a_point(pixel: Vector2) -> bool:
	for handle in _board.handles():
		var is_point := handle is not ArrowBody
		if is_point and (handle as Handle).covers(get_global_transform() * pixel):
			return true
	return false


func _shaft() -> PackedVector2Array:
	return [_board.to_screen(_point), _board.to_screen(_point.plus(_along))]
