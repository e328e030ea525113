@tool
class_name TurnArcs
extends BoardPart
## The ways of the heads of vectors from the origin while they are turned: dashed arcs.

const _STROKES := 24

## The heads before the turn, in units of the plane. 32 bits; [method lay] keeps all digits.
@export var heads: PackedVector2Array = []:
	get:
		var rounded: PackedVector2Array = []
		for head in _heads:
			rounded.append(head.to_vector2())
		return rounded
	set(value):
		var exact: Array[Vec2] = []
		for head in value:
			exact.append(Vec2.from_vector2(head))
		lay(exact, _turn)
## The turn in degrees; positive is from the x axis to the y axis.
@export_range(-180.0, 180.0, 0.001, "suffix:°") var turn_degrees := 0.0:
	get:
		return Vec2.rad_to_deg(_turn)
	set(value):
		lay(_heads, Vec2.deg_to_rad(value))

var _heads: Array[Vec2] = []
var _turn := 0.0


## Draws an arc from each of [param from], in units of the plane, by [param turn] radians, from
## the x axis to the y axis.
func lay(from: Array[Vec2], turn: float) -> void:
	var copies: Array[Vec2] = []
	for head in from:
		copies.append(head.copy())
	_heads = copies
	_turn = turn
	show_change()


func spanned_points() -> Array[Vec2]:
	return _heads


func _draw() -> void:
	for head in _heads:
		_draw_arc(head)


func _draw_arc(head: Vec2) -> void:
	var center := board.to_screen(Vec2.new())
	var radius := center.distance_to(board.to_screen(head))
	var start := head.angle_radians() * board.y_sign()
	var stroke := _turn / _STROKES * board.y_sign()
	for i in _STROKES:
		var from := start + stroke * i
		draw_arc(
			center, radius, from, from + stroke * 0.5, 4, Palette.drawn(Palette.AXIS), 1.5, true
		)
