@tool
class_name QuarterTurn
extends BoardPart
## The way of a vector's head while it is turned by +90 degrees: an arc with a tip, and the angle.

const _TIP := 13.0
const _PIECES := 32
# The tips of both arrows stay free.
const _FROM := 0.06
const _TO := 0.9

## Colour of the arc.
@export var role := Palette.Role.QUIET

var _tail := Vec2.new()
var _vector := Vec2.new()


## Turns [param vector] about [param tail], in units of the plane.
func lay(tail: Vec2, vector: Vec2) -> void:
	_tail = tail.copy()
	_vector = vector.copy()
	queue_redraw()


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
	draw_text("+90°", _pixel(0.5) + outwards * 28.0, color, 18)


# Where the head is after `share` of the quarter turn.
func _pixel(share: float) -> Vector2:
	var turned := _vector.copy()
	turned.rotate_degrees(90.0 * share)
	return board.to_screen(_tail.plus(turned))
