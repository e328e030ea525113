@tool
class_name BallView
extends BoardPart
## A ball on the board, in its true size; filled, or an outline where it only shows a place.

## Where its center is, in units of the plane. 32 bits; [method lay] keeps all digits.
@export var center := Vector2.ZERO:
	get:
		return _center.to_vector2()
	set(value):
		lay(Vec2.from_vector2(value), radius)
## Its radius, in units of the plane.
@export_range(0.0, 1000.0, 0.001, "or_greater") var radius := 1.0:
	set(value):
		radius = value
		show_change()
## Colour of the ball.
@export var role := Palette.Role.INK
## The label above it, such as `old`.
@export var label := "":
	set(value):
		label = value
		queue_redraw()
## Only the outline, dashed: a place where the ball was, will be or should be.
@export var is_ghost := false

var _center := Vec2.new()


## Shows a ball of radius [param its_radius] with its center at [param to], in units of the plane.
func lay(to: Vec2, its_radius: float) -> void:
	_center = to.copy()
	radius = its_radius


## Where its center is, in units of the plane.
func at() -> Vec2:
	return _center.copy()


func spanned_points() -> Array[Vec2]:
	return [_center.minus(Vec2.new(radius, radius)), _center.plus(Vec2.new(radius, radius))]


func _draw() -> void:
	var middle := board.to_screen(_center)
	# In 32 bits a circle larger than 1e6 pixels is drawn wrongly.
	var pixels := clampf(radius * board.pixels_per_unit, 1.5, 1e6)
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
