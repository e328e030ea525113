@tool
class_name BoardText
extends BoardPart
## A short name beside a point of the board.

## The text; the same in every language.
@export var text := ""
## Colour of the text.
@export var role := Palette.Role.INK

var _point := Vec2.new()
var _direction := Vec2.new()


## Writes beside [param point], in the direction [param towards].
func lay(point: Vec2, towards: Vec2) -> void:
	_point = point.copy()
	_direction = towards.normalized()
	queue_redraw()


func _draw() -> void:
	var middle := board.to_screen(_point) + board.direction_to_screen(_direction) * 20.0
	draw_text(text, middle, Palette.color(role), 18)
