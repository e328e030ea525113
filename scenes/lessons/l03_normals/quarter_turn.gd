@tool
class_name QuarterTurn
extends BoardPart
## The way of a vector's head while it is turned by +90 degrees: an arc with a tip, and the angle.

const _TIP := 13.0
const _PIECES := 32
# Shares of the quarter turn between which the arc is drawn: both arrows keep their tips free.
const _FROM := 0.06
const _TO := 0.78

## Where the vector begins, in units of the plane. 32 bits; [method lay] keeps all digits.
@export var tail := Vector2.ZERO:
	get:
		return _tail.to_vector2()
	set(value):
		lay(Vec2.from_vector2(value), _vector)
## The vector before the turn, in units of the plane; nothing is drawn for a short one.
@export var vector := Vector2.ZERO:
	get:
		return _vector.to_vector2()
	set(value):
		lay(_tail, Vec2.from_vector2(value))
## Colour of the arc.
@export var role := Palette.Role.QUIET

var _tail := Vec2.new()
var _vector := Vec2.new()


## Turns the vector [param turned] about its tail [param at], in units of the plane.
func lay(at: Vec2, turned: Vec2) -> void:
	_tail = at.copy()
	_vector = turned.copy()
	show_change()


func spanned_points() -> Array[Vec2]:
	return [_tail, _tail.plus(_vector), _tail.plus(Vec2.new(-_vector.y, _vector.x))]


func _draw() -> void:
	if board.to_screen(_tail).distance_to(_pixel(0.0)) < 4.0 * _TIP:
		return
	var color := Palette.color(role)
	var points: PackedVector2Array = []
	for i in _PIECES + 1:
		points.append(_pixel(lerpf(_FROM, _TO, float(i) / _PIECES)))
	draw_polyline(points, color, 2.0, true)
	var tip := _pixel(_TO + 0.02)
	var back := tip.direction_to(points[_PIECES - 2]) * _TIP
	var side := back.orthogonal() * 0.4
	var corners: PackedVector2Array = [tip, tip + back + side, tip + back - side]
	draw_primitive(corners, [color], [])
	var outwards := board.to_screen(_tail).direction_to(_pixel(0.5))
	draw_text(Conventions.in_unit("+90°"), _pixel(0.5) + outwards * 28.0, color, 18)


# Where the head is after `share` of the quarter turn.
func _pixel(share: float) -> Vector2:
	var turned := _vector.copy()
	turned.rotate_degrees(90.0 * share)
	return board.to_screen(_tail.plus(turned))
