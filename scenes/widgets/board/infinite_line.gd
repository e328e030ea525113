class_name InfiniteLine
extends BoardPart
## A straight line without ends: dashed, from one edge of the board to the other.

## Its colour.
@export var role := Palette.Role.QUIET
## Thickness in pixels.
@export_range(1.0, 12.0, 0.5, "suffix:px") var width := 2.0

var _point := Vec2.new()
var _direction := Vec2.new()


## Lays the line through [param point] along [param direction], which may have any length; nothing
## is drawn for a zero direction.
func lay(point: Vec2, direction: Vec2) -> void:
	_point = point.copy()
	_direction = direction.normalized()
	visible = direction.length() > 0.0
	queue_redraw()


func _draw() -> void:
	var middle := board.to_plane(board.size / 2.0)
	var along := middle.minus(_point).vector_projection(_direction)
	var nearest := board.to_screen(_point.plus(along))
	var reach := _direction.to_vector2() * board.size.length()
	draw_strokes(nearest - reach, nearest + reach, Palette.color(role), width)
