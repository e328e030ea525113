@tool
class_name GameField
extends BoardPart
## The field of a level: its frame, its walls, the way of the target, and the pull of gravity.

const _WALL := 6.0
const _DOTS := 26
# The sign of gravity: so long, in pixels of the board.
const _PULL := 26.0

# Null before a level is shown.
var _level: GameLevel


## Shows [param level].
func show_level(level: GameLevel) -> void:
	_level = level
	queue_redraw()


func _draw() -> void:
	if not _level:
		return
	_draw_frame()
	_draw_track()
	for wall in _level.walls:
		var from := board.to_screen(wall.start)
		var to := board.to_screen(wall.end)
		var color := Palette.color(Palette.Role.INK)
		draw_line(from, to, color, _WALL, true)
		draw_circle(from, _WALL / 2.0, color, true, -1.0, true)
		draw_circle(to, _WALL / 2.0, color, true, -1.0, true)
	if _level.gravity.length() > 0.0:
		_draw_pull()


func _draw_frame() -> void:
	var corner := Vec2.new(GameLevel.FIELD_SIZE[0], GameLevel.FIELD_SIZE[1])
	var from := board.to_screen(Vec2.zero())
	var to := board.to_screen(corner)
	var field := Rect2(from, to - from).abs()
	draw_rect(field, Palette.drawn(Palette.FIELD))
	draw_rect(field, Palette.drawn(Palette.BORDER), false, 2.0)


# Where the target will be: dots, so that nobody takes it for a wall.
func _draw_track() -> void:
	var target := _level.target
	if target.speed == 0.0:
		return
	var length := TAU * target.circle if target.circle > 0.0 else target.from.distance_to(target.to)
	var color := Color(Palette.color(Palette.Role.B), 0.45)
	for dot in _DOTS:
		var place := target.place_at(length / absf(target.speed) * dot / (_DOTS - 1.0))
		draw_circle(board.to_screen(place), 1.6, color, true, -1.0, true)


func _draw_pull() -> void:
	var color := Palette.color(Palette.Role.QUIET)
	for column: float in [0.3, 0.5, 0.7]:
		var at := board.to_screen(Vec2.new(GameLevel.FIELD_SIZE[0] * column, 20.0))
		var tip := at + board.direction_to_screen(Vec2.new(0.0, 1.0)) * _PULL
		draw_line(at, tip, color, 2.0, true)
		for side: float in [-1.0, 1.0]:
			draw_line(tip, tip.lerp(at, 0.3) + Vector2(side * 5.0, 0.0), color, 2.0, true)
