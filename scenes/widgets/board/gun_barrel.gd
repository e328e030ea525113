@tool
class_name GunBarrel
extends BoardPart
## A barrel that turns about its mount: a tube from there to the nozzle, where the bullet leaves.

# The tube is this share of its length thick, in pixels within these bounds.
const _THICKNESS := 0.24
const _THINNEST := 8.0
const _THICKEST := 26.0
# The disc of the mount, and how long the muzzle's ring is, both in thicknesses.
const _MOUNT := 0.95
const _RING := 0.45

## Where it is mounted, in units of the plane. 32 bits; [method lay] keeps all digits.
@export var mount := Vector2.ZERO:
	get:
		return _mount.to_vector2()
	set(value):
		lay(Vec2.from_vector2(value), _nozzle)
## The middle of its open end, in units of the plane.
@export var nozzle := Vector2.RIGHT:
	get:
		return _nozzle.to_vector2()
	set(value):
		lay(_mount, Vec2.from_vector2(value))
## Colour of the barrel.
@export var role := Palette.Role.INK
## Only the outline: a barrel that stands wrong, or will stand so.
@export var is_ghost := false

var _mount := Vec2.new()
var _nozzle := Vec2.new(1.0, 0.0)


## Shows a barrel from [param its_mount] to [param its_nozzle], in units of the plane. Where both
## are one place there is only the mount.
func lay(its_mount: Vec2, its_nozzle: Vec2) -> void:
	_mount = its_mount.copy()
	_nozzle = its_nozzle.copy()
	show_change()


func spanned_points() -> Array[Vec2]:
	return [_mount, _nozzle]


func _draw() -> void:
	var from := board.to_screen(_mount)
	var to := board.to_screen(_nozzle)
	var length := from.distance_to(to)
	var thick := clampf(_THICKNESS * length, _THINNEST, _THICKEST)
	var along := from.direction_to(to)
	_draw_tube(from, to, along.orthogonal() * thick * 0.42)
	if length > thick:
		_draw_tube(to - along * thick * _RING, to, along.orthogonal() * thick * 0.62)
	_draw_mount(from, thick * _MOUNT)


func _draw_tube(from: Vector2, to: Vector2, side: Vector2) -> void:
	var corners: PackedVector2Array = [from + side, to + side, to - side, from - side]
	if not is_ghost and side and from != to:
		var paper := Palette.drawn(Palette.PAPER)
		var fill := Palette.color(role).lerp(paper, 0.55)
		draw_primitive(corners, [fill, fill, fill, fill], [])
	corners.append(corners[0])
	_draw_outline(corners)


func _draw_mount(middle: Vector2, radius: float) -> void:
	var color := Palette.color(role)
	if not is_ghost:
		var fill := color.lerp(Palette.drawn(Palette.PAPER), 0.7)
		draw_circle(middle, radius, fill, true, -1.0, true)
	draw_circle(middle, radius, color, false, Palette.stroke(2.0), true)


func _draw_outline(corners: PackedVector2Array) -> void:
	var color := Palette.color(role)
	for i in corners.size() - 1:
		if is_ghost:
			draw_strokes(corners[i], corners[i + 1], color, 2.0)
		else:
			draw_line(corners[i], corners[i + 1], color, Palette.stroke(2.0), true)
