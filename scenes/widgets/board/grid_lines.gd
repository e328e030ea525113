@tool
class_name GridLines
extends BoardPart
## What a [Grid] shows: paper, lines at every step, axes with numbers where there is room.

## Also draw the axes with their numbers, not just the lines.
var axes := true
## Also draw the lines, not just the paper.
var has_lines := true


func _draw() -> void:
	draw_rect(Rect2(Vector2.ZERO, board.size), Palette.drawn(Palette.PAPER))
	if has_lines:
		_draw_lines()
	if axes:
		_draw_axes()


func _draw_lines() -> void:
	var origin := board.to_screen(Vec2.new())
	for x in _line_positions(origin.x, board.size.x):
		draw_line(Vector2(x, 0.0), Vector2(x, board.size.y), Palette.drawn(Palette.GRID), 1.0)
	for y in _line_positions(origin.y, board.size.y):
		draw_line(Vector2(0.0, y), Vector2(board.size.x, y), Palette.drawn(Palette.GRID), 1.0)


func _draw_axes() -> void:
	var origin := board.to_screen(Vec2.new())
	var extent := board.size
	draw_line(Vector2(0.0, origin.y), Vector2(extent.x, origin.y), Palette.drawn(Palette.AXIS), 1.5)
	draw_line(Vector2(origin.x, 0.0), Vector2(origin.x, extent.y), Palette.drawn(Palette.AXIS), 1.5)
	_draw_tip(Vector2(extent.x - 2.0, origin.y), Vector2.RIGHT)
	_draw_tip(Vector2(origin.x, _y_end(2.0)), Vector2.DOWN * board.y_sign())
	var quiet := Palette.color(Palette.Role.QUIET)
	draw_text_at("x", Vector2(extent.x - 14.0, origin.y - 16.0), quiet, 18)
	draw_text_at("y", Vector2(origin.x - 16.0, _y_end(16.0)), quiet, 18)
	_draw_numbers(origin)


func _draw_numbers(origin: Vector2) -> void:
	var quiet := Palette.color(Palette.Role.QUIET)
	var step := board.grid_step * board.pixels_per_unit
	var every := 2 if step >= 32.0 else 5
	for x in _line_positions(origin.x, board.size.x - 60.0):
		var place := roundi((x - origin.x) / step)
		if place % every == 0 and place != 0 and x > 24.0:
			var text := NumberText.short(place * board.grid_step)
			draw_text_at(text, Vector2(x, origin.y + 16.0), quiet, 15)
	for y in _line_positions(origin.y, board.size.y - 16.0):
		var place := roundi((y - origin.y) / step)
		if place % every == 0 and place != 0 and y > 16.0 and absf(y - _y_end(0.0)) > 60.0:
			var text := NumberText.short(place * board.grid_step * board.y_sign())
			draw_text_at(text, Vector2(origin.x - 8.0 - 4.0 * text.length(), y), quiet, 15)


func _draw_tip(at: Vector2, direction: Vector2) -> void:
	var side := direction.orthogonal() * 5.0
	var back := at - direction * 11.0
	draw_colored_polygon(
		PackedVector2Array([at, back + side, back - side]), Palette.drawn(Palette.AXIS)
	)


# A place this many pixels before the end of the y axis towards which y grows.
func _y_end(pixels: float) -> float:
	return pixels if board.is_y_up else board.size.y - pixels


# Where lines cross one axis, in pixels from 0 to `length`, counted out from the origin.
func _line_positions(origin: float, length: float) -> PackedFloat32Array:
	var positions: PackedFloat32Array = []
	var step := board.grid_step * board.pixels_per_unit
	for place in range(ceili(-origin / step), floori((length - origin) / step) + 1):
		positions.append(origin + place * step)
	return positions
