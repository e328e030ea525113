@tool
class_name SurfaceView
extends BoardPart
## A surface that can move: a thick line; on a belt with strokes that run along it.

const _WIDTH := 5.0
# Between two strokes of a belt, in units of the plane, and how long they are, in pixels.
const _BETWEEN := 25.0
const _HATCH_LENGTH := 9.0
const _MOST_STROKES := 400.0

## Where it begins, in units of the plane. 32 bits; [method lay] keeps all digits.
@export var from := Vector2.ZERO:
	get:
		return _from.to_vector2()
	set(value):
		lay(Vec2.from_vector2(value), _to)
## Where it ends, in units of the plane.
@export var to := Vector2.ZERO:
	get:
		return _to.to_vector2()
	set(value):
		lay(_from, Vec2.from_vector2(value))
## Its color.
@export var role := Palette.Role.INK
## Fainter: where it is at another moment.
@export var is_ghost := false
## It runs along itself, as its strokes show.
@export var is_belt := false

## How far a belt has run, in units of the plane.
var run := 0.0:
	set(value):
		run = value
		queue_redraw()

var _from := Vec2.new()
var _to := Vec2.new()


## Lays it from one point to another, both in units of the plane.
func lay(start: Vec2, end: Vec2) -> void:
	_from = start.copy()
	_to = end.copy()
	show_change()


func spanned_points() -> Array[Vec2]:
	return [_from, _to]


func _draw() -> void:
	var color := Palette.color(role)
	var start := board.to_screen(_from)
	var end := board.to_screen(_to)
	if is_ghost:
		draw_strokes(start, end, Color(color, 0.5), 2.5)
		return
	draw_line(start, end, color, Palette.stroke(_WIDTH), true)
	if is_belt:
		_draw_strokes_of_belt(start, end, color)


# They lean as the ends of a belt that is drawn along.
func _draw_strokes_of_belt(start: Vector2, end: Vector2, color: Color) -> void:
	var length := _from.distance_to(_to)
	if length > _BETWEEN * _MOST_STROKES:
		return
	var below := (end - start).normalized().orthogonal() * -_HATCH_LENGTH
	below *= signf(below.y * board.y_sign() + 1e-9) * board.y_sign()
	var at := fposmod(run, _BETWEEN)
	while at <= length:
		var top := start.lerp(end, at / length)
		draw_line(top, top + below, color, Palette.stroke(3.0), true)
		at += _BETWEEN
