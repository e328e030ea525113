@tool
extends Control
## The picture on the card of the rubric: lines, of which the first ones are reached.

const _LENGTHS: Array[float] = [0.52, 0.4, 0.6, 0.46]
const _REACHED := 2


func _draw() -> void:
	draw_rect(Rect2(Vector2.ZERO, size), Palette.drawn(Palette.PAPER))
	for i in _LENGTHS.size():
		_draw_line(Vector2(0.16 * size.x, size.y * (i + 0.7) / (_LENGTHS.size() + 0.4)), i)


func _draw_line(at: Vector2, i: int) -> void:
	var radius := size.y * 0.075
	var width := Palette.stroke(maxf(size.x / 80.0, 2.0))
	var right := Palette.color(Palette.Role.RIGHT)
	var quiet := Palette.color(Palette.Role.QUIET)
	if i < _REACHED:
		draw_circle(at, radius, right, true, -1.0, true)
		var hook := Vector2(-radius * 0.1, radius * 0.45)
		var paper := Palette.drawn(Palette.PAPER)
		draw_line(at + Vector2(-radius * 0.5, 0.0), at + hook, paper, width * 0.8, true)
		draw_line(at + hook, at + Vector2(radius * 0.5, -radius * 0.45), paper, width * 0.8, true)
	else:
		draw_arc(at, radius, 0.0, TAU, 32, quiet, width * 0.7, true)
	var start := at + Vector2(radius * 2.2, 0.0)
	draw_line(start, start + Vector2(_LENGTHS[i] * size.x, 0.0), quiet, width * 1.6)
