@tool
extends Control
## The picture on the card of the workshop: the lab's arrow, and beside it, dashed, that of the
## student's code, whose lines stand in a corner.

const _STEPS := 8
const _LINES: Array[float] = [0.26, 0.34, 0.2]
const _ORIGIN := Vector2(0.14, 0.84)
const _LAB := Vector2(0.86, 0.5)
const _OWN := Vector2(0.66, 0.2)


func _draw() -> void:
	draw_rect(Rect2(Vector2.ZERO, size), Palette.drawn(Palette.PAPER))
	_draw_grid()
	_draw_arrow(_LAB, Palette.Role.PROJECTION, false)
	_draw_arrow(_OWN, Palette.Role.B, true)
	for i in _LINES.size():
		var start := Vector2(0.08 + 0.05 * signf(i), 0.12 + 0.1 * i) * size
		var end := start + Vector2(_LINES[i] * size.x, 0.0)
		draw_line(start, end, Palette.color(Palette.Role.QUIET), _width())


func _draw_grid() -> void:
	var step := size.x / _STEPS
	var grid := Palette.drawn(Palette.GRID)
	for i in range(1, _STEPS):
		draw_line(Vector2(step * i, 0.0), Vector2(step * i, size.y), grid, 1.0)
		if step * i < size.y:
			draw_line(Vector2(0.0, step * i), Vector2(size.x, step * i), grid, 1.0)


func _draw_arrow(head: Vector2, role: Palette.Role, is_dashed: bool) -> void:
	var from := _ORIGIN * size
	var to := head * size
	var along := from.direction_to(to) * _width() * 3.5
	var side := along.orthogonal() * 0.5
	var color := Palette.color(role)
	if is_dashed:
		draw_dashed_line(from, to - along, color, _width(), _width() * 2.0, true, true)
	else:
		draw_line(from, to - along, color, _width(), true)
	draw_colored_polygon(PackedVector2Array([to, to - along + side, to - along - side]), color)


# As thick as the arrows on the other cards.
func _width() -> float:
	return Palette.stroke(maxf(size.x / 60.0, 2.0))
