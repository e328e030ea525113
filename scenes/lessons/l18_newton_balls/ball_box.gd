@tool
class_name BallBox
extends BoardPart
## The four walls around the balls.

## The corner at the lower right, in units of the plane; the box lies around the origin.
@export var corner := Vector2.ONE


func spanned_points() -> Array[Vec2]:
	return [Vec2.from_vector2(corner), Vec2.from_vector2(-corner)]


func _draw() -> void:
	var low := board.to_screen(Vec2.from_vector2(-corner))
	var high := board.to_screen(Vec2.from_vector2(corner))
	draw_rect(Rect2(low, high - low).abs(), Palette.color(Palette.Role.INK), false, 3.0)
