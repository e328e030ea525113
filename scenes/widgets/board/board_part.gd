@tool
class_name BoardPart
extends Node2D
## What is drawn on a [Board]: finds the board above it and is drawn again when the view changes.

## The board that this part lies on: the nearest one above it in the tree.
var board: Board


func _enter_tree() -> void:
	var above := get_parent()
	while above and not above is Board:
		above = above.get_parent()
	board = above as Board if above else _board_of_its_own()
	board.view_changed.connect(queue_redraw)
	_span()


func _exit_tree() -> void:
	board.view_changed.disconnect(queue_redraw)


## Points between which this part lies, in units of the plane: the editor shows them all.
func spanned_points() -> Array[Vec2]:
	return []


## Draws the part anew after a change.
func show_change() -> void:
	queue_redraw()
	_span()


## A text with a rim of the board's color, so that it reads on top of lines; [param middle] is its
## center.
func draw_text(text: String, middle: Vector2, color: Color, font_size: int = 20) -> void:
	var font := ThemeDB.fallback_font
	var extent := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size)
	var start := middle + Vector2(-extent.x / 2.0, font_size * 0.36)
	var rim := Palette.drawn(Palette.PAPER)
	draw_string_outline(font, start, text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size, 8, rim)
	draw_string(font, start, text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size, color)


## A line of short strokes from [param from] to [param to], in the board's pixels, as thick as lines
## of [param width] are drawn now.
func draw_strokes(from: Vector2, to: Vector2, color: Color, width: float) -> void:
	draw_dashed_line(from, to, color, Palette.stroke(width), 9.0, true, true)


# A scene of parts that is opened or run alone has no board: they are drawn around the origin.
func _board_of_its_own() -> Board:
	if not board:
		board = Board.new()
		add_child(board, false, INTERNAL_MODE_FRONT)
	return board


func _span() -> void:
	if Engine.is_editor_hint() and board:
		board.span(spanned_points())
