@tool
class_name DimensionLine
extends BoardPart
## A length between two points as in a technical drawing: a line with a tip at both ends, drawn
## beside what it measures, and its label.

const _TIP := 11.0
const _FONT_SIZE := 20

## One end of what it measures, in units of the plane.
@export var from := Vector2.ZERO:
	get:
		return _from.to_vector2()
	set(value):
		_from = Vec2.from_vector2(value)
		show_change()
## The other end.
@export var to := Vector2.ZERO:
	get:
		return _to.to_vector2()
	set(value):
		_to = Vec2.from_vector2(value)
		show_change()
## The side on which it is drawn: a direction of any length above 0.
@export var side := Vector2.ZERO:
	get:
		return _side.to_vector2()
	set(value):
		_side = Vec2.from_vector2(value).normalized()
		show_change()
## The label beside it, such as `a = 40`, as it is to be read.
@export var label := ""
## Where the label is on the way from the first point to the last.
@export_range(0.0, 1.0, 0.05) var label_share := 0.5
## Its color, here and in formulas.
@export var role := Palette.Role.INK
## How far beside the two points it is drawn.
@export_range(0.0, 200.0, 1.0, "suffix:px") var offset := 0.0

var _from := Vec2.new()
var _to := Vec2.new()
var _side := Vec2.new()


## Measures from [param first] to [param last], in units of the plane; drawn on the side to which
## [param towards] points.
func lay(first: Vec2, last: Vec2, towards: Vec2) -> void:
	_from = first.copy()
	_to = last.copy()
	_side = towards.normalized()
	show_change()


func spanned_points() -> Array[Vec2]:
	return [_from, _to]


## Pixels that the label takes up beside the line.
func label_room() -> float:
	var extent := text_extent(label, _FONT_SIZE)
	return absf(_side.x) * extent.x + absf(_side.y) * drawn_size(_FONT_SIZE) + 16.0


## Where the middle of its label is about to be, in the board's pixels.
func label_pixel() -> Vector2:
	var beside := board.direction_to_screen(_side) * (offset + label_room() / 2.0)
	return board.to_screen(_from.lerped(_to, label_share)) + beside


func _draw() -> void:
	var color := Palette.color(role)
	var beside := board.direction_to_screen(_side)
	var first := board.to_screen(_from) + beside * offset
	var last := board.to_screen(_to) + beside * offset
	if offset > 0.0:
		var faint := Color(color, 0.45)
		draw_line(board.to_screen(_from), first + beside * 6.0, faint, 1.5, true)
		draw_line(board.to_screen(_to), last + beside * 6.0, faint, 1.5, true)
	draw_line(first, last, color, Palette.stroke(2.5), true)
	_draw_tip(first, last, color)
	_draw_tip(last, first, color)
	if label:
		_draw_label(_in_visible_part(first, last), beside, color)


func _draw_tip(tip: Vector2, other: Vector2, color: Color) -> void:
	var length := minf(_TIP, tip.distance_to(other) / 2.0)
	if length < 1.0:
		return
	var neck := tip + tip.direction_to(other) * length
	var across := (neck - tip).orthogonal() * 0.38
	var corners: PackedVector2Array = [tip, neck + across, neck - across]
	draw_primitive(corners, [color], [])


func _draw_label(middle: Vector2, beside: Vector2, color: Color) -> void:
	var extent := Vector2(text_extent(label, _FONT_SIZE).x, 0.0)
	var reach := label_room() / 2.0
	var at := kept_on_board(middle + beside * reach, extent, Vector2(6.0, 18.0))
	draw_text(label, at, color, _FONT_SIZE)


# The place of the label in what the board shows of the line between two points in its own pixels.
func _in_visible_part(first: Vector2, last: Vector2) -> Vector2:
	var low := 0.0
	var high := 1.0
	var way := last - first
	for axis: int in 2:
		if way[axis] != 0.0:
			var at_start := -first[axis] / way[axis]
			var at_end := (board.size[axis] - first[axis]) / way[axis]
			low = maxf(low, minf(at_start, at_end))
			high = minf(high, maxf(at_start, at_end))
	return first + way * lerpf(low, high, label_share)
