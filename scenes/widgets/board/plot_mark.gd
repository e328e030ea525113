class_name PlotMark
extends RefCounted
## The marks of a plot: each number gives another shape and color, so that neither is the only sign.

## Pixels from the middle of a mark to its corners.
const RADIUS := 7.0

# Corners of each shape on a circle: how many, the angle of the first in degrees, how far out they
# lie, and each second one, as shares of the radius.
const _SHAPES: Array[Vector4] = [
	Vector4(24, 0, 1.0, 1.0),
	Vector4(4, 45, 1.2, 1.2),
	Vector4(3, -90, 1.25, 1.25),
	Vector4(4, 0, 1.25, 1.25),
	Vector4(3, 90, 1.25, 1.25),
	Vector4(10, -90, 1.35, 0.6),
	Vector4(6, 0, 1.1, 1.1),
	Vector4(8, 0, 1.35, 0.5),
	Vector4(5, -90, 1.15, 1.15),
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


## The color of the mark with this number.
static func color(number: int) -> Color:
	return Palette.color(_ROLES[number % _ROLES.size()])


## Draws the mark with this number; hollow for what the lab is compared with. A full mark has a rim
## of the board's color, so that marks which lie on each other can be told apart.
static func draw(canvas: CanvasItem, number: int, middle: Vector2, is_hollow: bool) -> void:
	var corners := _corners(number, middle)
	var outline := corners.duplicate()
	outline.append(corners[0])
	if not is_hollow:
		canvas.draw_polyline(outline, Palette.drawn(Palette.PAPER), 4.0, true)
	canvas.draw_colored_polygon(
		corners, Palette.drawn(Palette.PAPER) if is_hollow else color(number)
	)
	canvas.draw_polyline(outline, color(number), 2.5 if is_hollow else 1.0, true)


static func _corners(number: int, middle: Vector2) -> PackedVector2Array:
	var shape := _SHAPES[number % _SHAPES.size()]
	var corners: PackedVector2Array = []
	for i in int(shape.x):
		var radius := RADIUS * (shape.w if i % 2 == 1 else shape.z)
		var angle := deg_to_rad(shape.y) + TAU * i / shape.x
		corners.append(middle + Vector2.from_angle(angle) * radius)
	return corners
