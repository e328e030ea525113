class_name PlotMark
extends RefCounted
## The marks of a plot: each number gives another shape and colour, so that neither stands alone.

## Pixels from the middle of a mark to its corners.
const RADIUS := 7.0

# Corners of each shape on a circle: how many, the angle of the first in degrees, and how far in
# each second one lies (1: not at all).
const _SHAPES: Array[Vector3] = [
	Vector3(24, 0, 1.0),
	Vector3(4, 45, 1.0),
	Vector3(3, -90, 1.0),
	Vector3(4, 0, 1.0),
	Vector3(3, 90, 1.0),
	Vector3(10, -90, 0.45),
	Vector3(6, 0, 1.0),
	Vector3(8, 0, 0.4),
	Vector3(5, -90, 1.0),
]
const _ROLES: Array[Palette.Role] = [
	Palette.Role.PROJECTION,
	Palette.Role.B,
	Palette.Role.REST,
	Palette.Role.A,
	Palette.Role.UNIT,
	Palette.Role.INK,
	Palette.Role.WRONG,
]


## The colour of the mark with this number.
static func color(number: int) -> Color:
	return Palette.color(_ROLES[number % _ROLES.size()])


## Draws the mark with this number; hollow where it stands for what one compares with.
static func draw(canvas: CanvasItem, number: int, middle: Vector2, is_hollow: bool) -> void:
	var corners := _corners(number, middle)
	canvas.draw_colored_polygon(corners, Palette.PAPER if is_hollow else color(number))
	corners.append(corners[0])
	canvas.draw_polyline(corners, color(number), 2.5 if is_hollow else 1.0, true)


static func _corners(number: int, middle: Vector2) -> PackedVector2Array:
	var shape := _SHAPES[number % _SHAPES.size()]
	var corners: PackedVector2Array = []
	for i in int(shape.x):
		var radius := RADIUS * (shape.z if i % 2 == 1 else 1.15)
		var angle := deg_to_rad(shape.y) + TAU * i / shape.x
		corners.append(middle + Vector2.from_angle(angle) * radius)
	return corners
