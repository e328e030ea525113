@tool
class_name FramePath
extends BoardPart
## Where a ball is frame by frame: its rim and its middle for each frame, joined by a line.

## Colour of the path.
@export var role := Palette.Role.QUIET
## What stands at the end of the path.
@export var label := ""

var _places: Array[Vec2] = []
var _radius := 1.0


## Shows the [param places] of a ball of [param radius], in order; units of the plane.
func lay(places: Array[Vec2], radius: float) -> void:
	_places = places
	_radius = radius
	queue_redraw()


func _draw() -> void:
	var color := Palette.color(role)
	var pixels: PackedVector2Array = []
	for place in _places:
		var middle := board.to_screen(place)
		pixels.append(middle)
		draw_circle(middle, 3.0, color, true, -1.0, true)
		var rim := _radius * board.pixels_per_unit
		draw_circle(middle, rim, Color(color, 0.25), false, 1.5, true)
	if pixels.size() > 1:
		draw_polyline(pixels, Color(color, 0.6), 2.0, true)
	if label and not pixels.is_empty():
		var inside := Rect2(Vector2.ZERO, board.size).grow(-30.0)
		var beside := pixels[-1] + Vector2(0.0, -18.0)
		draw_text(tr(label), beside.clamp(inside.position, inside.end), color, 22)
