@tool
class_name TankHull
extends BoardPart
## The hull of a tank from above, with its tracks and an arrow at its front.

# How wide it is, as a share of its length, and how wide a track is.
const _WIDTH := 0.62
const _TRACK := 0.18

## Its middle, in units of the plane. 32 bits; [method lay] keeps all digits.
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
## How long it is, in units of the plane.
@export_range(1.0, 1000.0, 0.001, "or_greater") var length := 64.0:
	set(value):
		length = value
		show_change()
## Its colour.
@export var role := Palette.Role.A

var _center := Vec2.new()


## Shows it at [param middle], in units of the plane, turned by [param angle] degrees.
func lay(middle: Vec2, angle: float) -> void:
	_center = middle.copy()
	degrees = angle


## Its middle, in units of the plane.
func at() -> Vec2:
	return _center.copy()


func spanned_points() -> Array[Vec2]:
	var half := Vec2.unit_degrees(degrees).scaled(length / 2.0)
	return [_center.minus(half), _center.plus(half)]


func _draw() -> void:
	var middle := board.to_screen(_center)
	var half := length / 2.0 * board.pixels_per_unit
	var along := board.direction_to_screen(Vec2.unit_degrees(degrees)) * half
	var across := along.orthogonal() * _WIDTH
	var color := Palette.color(role)
	var paper := Palette.drawn(Palette.PAPER)
	for side: float in [-1.0, 1.0]:
		var track := across * side * (1.0 - _TRACK)
		_draw_box(middle + track, along * 1.06, across * _TRACK, color.lerp(paper, 0.35))
	_draw_box(middle, along, across * (1.0 - 2.0 * _TRACK), color.lerp(paper, 0.72))
	var tip := middle + along * 0.92
	var back := middle + along * 0.62
	var corners: PackedVector2Array = [tip, back + across * 0.3, back - across * 0.3]
	draw_primitive(corners, [color], [])


func _draw_box(middle: Vector2, along: Vector2, across: Vector2, fill: Color) -> void:
	var corners: PackedVector2Array = [
		middle + along + across,
		middle + along - across,
		middle - along - across,
		middle - along + across
	]
	draw_primitive(corners, [fill, fill, fill, fill], [])
	corners.append(corners[0])
	draw_polyline(corners, Palette.color(role), Palette.stroke(1.5), true)
