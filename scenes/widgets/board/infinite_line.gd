@tool
class_name InfiniteLine
extends BoardPart
## A straight line without ends: dashed, from one edge of the board to the other.

## A point that it goes through, in units of the plane.
@export var point := Vector2.ZERO:
	get:
		return _point.to_vector2()
	set(value):
		_point = Vec2.from_vector2(value)
		show_change()
## The direction in which it runs; any length above 0.
@export var direction := Vector2.ZERO:
	get:
		return _direction.to_vector2()
	set(value):
		_direction = Vec2.from_vector2(value).normalized()
		show_change()
## Its color.
@export var role := Palette.Role.QUIET
## Thickness in pixels.
@export_range(1.0, 12.0, 0.5, "suffix:px") var width := 2.0

var _point := Vec2.new()
var _direction := Vec2.new()


## Lays the line through [param at] along [param along], which may have any length; nothing is drawn
## for a zero direction.
func lay(at: Vec2, along: Vec2) -> void:
	_point = at.copy()
	_direction = along.normalized()
	visible = along.length() > 0.0
	queue_redraw()


func _draw() -> void:
	var middle := board.to_plane(board.size / 2.0)
	var along := middle.minus(_point).vector_projection(_direction)
	var nearest := board.to_screen(_point.plus(along))
	var reach := board.direction_to_screen(_direction) * board.size.length()
	draw_strokes(nearest - reach, nearest + reach, Palette.color(role), width)
