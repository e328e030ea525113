class_name BallView
extends BoardPart
## A ball on the board, in its true size; filled, or an outline where it only shows a place.

## Colour of the ball.
@export var role := Palette.Role.INK
## What stands in its middle, such as `old`.
@export var label := ""
## Only the outline, dashed: a place where the ball was, will be or should be.
@export var is_ghost := false

var _centre := Vec2.new()
var _radius := 1.0


## Shows a ball of [param radius] with its centre at [param centre], both in units of the plane.
func lay(centre: Vec2, radius: float) -> void:
	_centre = centre.copy()
	_radius = radius
	queue_redraw()


func _draw() -> void:
	var middle := board.to_screen(_centre)
	# 32-bit drawing knows no larger circles than 1e6 pixels.
	var pixels := clampf(_radius * board.pixels_per_unit, 1.5, 1e6)
	var color := Palette.color(role)
	if is_ghost:
		for i in 16:
			draw_arc(middle, pixels, TAU * i / 16.0, TAU * (i + 0.55) / 16.0, 6, color, 2.0, true)
	else:
		draw_circle(middle, pixels, Color(color, 0.22), true, -1.0, true)
		draw_circle(middle, pixels, color, false, 2.5, true)
	draw_circle(middle, 2.5, color, true, -1.0, true)
	if label:
		draw_text(tr(label), middle + Vector2(0.0, -pixels - 14.0), color, 18)
