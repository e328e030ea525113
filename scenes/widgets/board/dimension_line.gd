class_name DimensionLine
extends BoardPart
## A length between two points as in a technical drawing: a line with a tip at both ends, drawn
## beside what it measures, and its label.

const _TIP := 11.0
const _FONT_SIZE := 20

## What stands beside it, such as `a = 40`, as it is to be read.
@export var label := ""
## Its colour, here and in formulas.
@export var role := Palette.Role.INK
## How far beside the two points it is drawn.
@export_range(0.0, 200.0, 1.0, "suffix:px") var offset := 0.0

var _from := Vec2.new()
var _to := Vec2.new()
var _side := Vec2.new()


## Measures from [param from] to [param to], in units of the plane; drawn on the side to which
## [param side] points.
func lay(from: Vec2, to: Vec2, side: Vec2) -> void:
	_from = from.copy()
	_to = to.copy()
	_side = side.normalized()
	queue_redraw()


## Pixels that the label takes up beside the line.
func label_room() -> float:
	var extent := ThemeDB.fallback_font.get_string_size(
		label, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE
	)
	return absf(_side.x) * extent.x + absf(_side.y) * _FONT_SIZE + 16.0


func _draw() -> void:
	var color := Palette.color(role)
	var side := _side.to_vector2()
	var from := board.to_screen(_from) + side * offset
	var to := board.to_screen(_to) + side * offset
	if offset > 0.0:
		var faint := Color(color, 0.45)
		draw_line(board.to_screen(_from), from + side * 6.0, faint, 1.5, true)
		draw_line(board.to_screen(_to), to + side * 6.0, faint, 1.5, true)
	draw_line(from, to, color, 2.5, true)
	_draw_tip(from, to, color)
	_draw_tip(to, from, color)
	if label:
		_draw_label(_middle_of_visible_part(from, to), side, color)


func _draw_tip(tip: Vector2, other: Vector2, color: Color) -> void:
	var length := minf(_TIP, tip.distance_to(other) / 2.0)
	if length < 1.0:
		return
	var neck := tip + tip.direction_to(other) * length
	var across := (neck - tip).orthogonal() * 0.38
	var corners: PackedVector2Array = [tip, neck + across, neck - across]
	draw_primitive(corners, [color], [])


func _draw_label(middle: Vector2, side: Vector2, color: Color) -> void:
	var extent := ThemeDB.fallback_font.get_string_size(
		label, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE
	)
	var reach := label_room() / 2.0
	var room := Rect2(Vector2.ZERO, board.size).grow_individual(
		-extent.x / 2.0 - 6.0, -18.0, -extent.x / 2.0 - 6.0, -18.0
	)
	draw_text(label, (middle + side * reach).clamp(room.position, room.end), color, _FONT_SIZE)


# The middle of what the board shows of the line between two points in its own pixels.
func _middle_of_visible_part(from: Vector2, to: Vector2) -> Vector2:
	var first := 0.0
	var last := 1.0
	var way := to - from
	for axis: int in 2:
		if way[axis] != 0.0:
			var at_start := -from[axis] / way[axis]
			var at_end := (board.size[axis] - from[axis]) / way[axis]
			first = maxf(first, minf(at_start, at_end))
			last = minf(last, maxf(at_start, at_end))
	return from + way * (first + last) / 2.0
