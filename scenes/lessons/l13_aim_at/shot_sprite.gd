@tool
class_name ShotSprite
extends BoardPart
## The sprite of a shot, a dart: it has to be turned so that it points where it flies.

# In pixels, at every scale.
const _LENGTH := 15.0
const _HALF_WIDTH := 6.0

## Where its middle is, in units of the plane. 32 bits; [method lay] keeps all digits.
@export var center := Vector2.ZERO:
	get:
		return _center.to_vector2()
	set(value):
		lay(Vec2.from_vector2(value), degrees)
## How far it is turned, in degrees, from the x axis to the y axis.
@export_range(-180.0, 180.0, 0.001, "suffix:°") var degrees := 0.0:
	set(value):
		degrees = value
		show_change()
## Its colour.
@export var role := Palette.Role.PROJECTION
## Only the outline: where it was, or will be.
@export var is_ghost := false

var _center := Vec2.new()


## Shows it at [param middle], in units of the plane, turned by [param angle] degrees.
func lay(middle: Vec2, angle: float) -> void:
	_center = middle.copy()
	degrees = angle


## Where its middle is, in units of the plane.
func at() -> Vec2:
	return _center.copy()


func spanned_points() -> Array[Vec2]:
	return [_center]


func _draw() -> void:
	var middle := board.to_screen(_center)
	var along := board.direction_to_screen(Vec2.unit_degrees(degrees))
	var side := along.orthogonal() * _HALF_WIDTH
	var tail := middle - along * _LENGTH
	var corners: PackedVector2Array = [
		middle + along * _LENGTH, tail + side, middle - along * _LENGTH * 0.6, tail - side
	]
	var color := Palette.color(role)
	if not is_ghost:
		draw_primitive(corners.slice(0, 3), [color, color, color], [])
		draw_primitive([corners[0], corners[2], corners[3]], [color, color, color], [])
	corners.append(corners[0])
	draw_polyline(corners, color, Palette.stroke(2.0), true)
