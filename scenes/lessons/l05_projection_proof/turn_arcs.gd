@tool
class_name TurnArcs
extends BoardPart
## The paths that the heads of vectors from the origin take while they are turned: dashed arcs.

const _STROKES := 24

var _heads: Array[Vec2] = []
var _turn := 0.0


## Draws an arc from each of [param heads], in units, by [param turn] radians, clockwise on screen.
func lay(heads: Array[Vec2], turn: float) -> void:
	_heads.clear()
	for head in heads:
		_heads.append(head.copy())
	_turn = turn
	queue_redraw()


func _draw() -> void:
	for head in _heads:
		_draw_arc(head)


func _draw_arc(head: Vec2) -> void:
	var centre := board.to_screen(Vec2.new())
	var radius := centre.distance_to(board.to_screen(head))
	var start := head.angle_radians()
	var stroke := _turn / _STROKES
	for i in _STROKES:
		var from := start + stroke * i
		draw_arc(centre, radius, from, from + stroke * 0.5, 4, Palette.AXIS, 1.5, true)
