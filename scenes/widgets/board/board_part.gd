@tool
class_name BoardPart
extends Node2D
## What is drawn on a [Board]: finds the board above it and is drawn again when the view changes.

## Emitted when a text is drawn: what it says, the room of its letters on the board and their size,
## both in pixels.
signal text_drawn(text: String, letters: Rect2, font_size: int)

## No text on a board is drawn with smaller letters than this, in pixels.
const SMALLEST_TEXT := 14

const _SHARE_ON_SMALL := 0.7
const _RIM := 8
const _RIM_ON_SMALL := 5
# A stroke of a dashed line, and the gap behind it, in pixels.
const _STROKE := 9.0
# A piece of a way that is longer than this is dashed from its own beginning.
const _LONG_PIECE := 200.0

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


## How large a text of [param font_size] is drawn: on a small board with smaller letters, as what it
## names is smaller there, too.
func drawn_size(font_size: int) -> int:
	if not board.is_small():
		return font_size
	return maxi(roundi(font_size * _SHARE_ON_SMALL), mini(SMALLEST_TEXT, font_size))


## The extent of a text as [method draw_text] draws it.
func text_extent(text: String, font_size: int) -> Vector2:
	var drawn := drawn_size(font_size)
	return ThemeDB.fallback_font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, drawn)


## The place nearest to [param middle] at which a text or mark of this [param extent] lies on the
## part of the board that no card covers, [param margin] from its edges.
func kept_on_board(middle: Vector2, extent: Vector2, margin: Vector2) -> Vector2:
	var inside := extent / 2.0 + margin
	var room := board.free_area().grow_individual(-inside.x, -inside.y, -inside.x, -inside.y)
	return middle.clamp(room.position, room.end.max(room.position))


## A text with a rim of the board's color, so that it reads on top of lines; [param middle] is its
## center. One that would be cut off by an edge of the board or of a strip on it moves inside.
func draw_text(text: String, middle: Vector2, color: Color, font_size: int = 20) -> void:
	var extent := text_extent(text, font_size)
	if Rect2(middle - extent / 2.0, extent).intersects(Rect2(Vector2.ZERO, board.size)):
		middle = kept_on_board(middle, extent, Vector2.ZERO)
	draw_text_at(text, middle, color, font_size)


## The same just where [param middle] is, such as a number beside its grid line.
func draw_text_at(text: String, middle: Vector2, color: Color, font_size: int = 20) -> void:
	var font := ThemeDB.fallback_font
	var drawn := drawn_size(font_size)
	var start := middle + Vector2(-text_extent(text, font_size).x / 2.0, drawn * 0.36)
	var rim := _RIM_ON_SMALL if board.is_small() else _RIM
	var paper := Palette.drawn(Palette.PAPER)
	draw_string_outline(font, start, text, HORIZONTAL_ALIGNMENT_LEFT, -1, drawn, rim, paper)
	draw_string(font, start, text, HORIZONTAL_ALIGNMENT_LEFT, -1, drawn, color)
	var letters := Vector2(text_extent(text, font_size).x, drawn * 0.72)
	text_drawn.emit(text, Rect2(start - Vector2(0.0, letters.y), letters), drawn)


## A line of short strokes from [param from] to [param to], in the board's pixels, as thick as lines
## of [param width] are drawn now.
func draw_strokes(from: Vector2, to: Vector2, color: Color, width: float) -> void:
	draw_dashed_line(from, to, color, Palette.stroke(width), _STROKE, true, true)


## A way of short strokes through [param places], in units of the plane. The strokes go on from
## piece to piece: a curved way has pieces shorter than a stroke.
func draw_way_of_strokes(places: Array[Vec2], color: Color, width: float) -> void:
	var reached := 0.0
	for i in range(1, places.size()):
		var from := board.to_screen(places[i - 1])
		var to := board.to_screen(places[i])
		_draw_strokes_from(reached, from, to, color, width)
		reached += from.distance_to(to)


# The strokes of a piece that begins `reached` pixels along its way. A long one is a straight line.
func _draw_strokes_from(
	reached: float, from: Vector2, to: Vector2, color: Color, width: float
) -> void:
	var length := from.distance_to(to)
	if length > _LONG_PIECE:
		draw_strokes(from, to, color, width)
		return
	var at := -fmod(reached, 2.0 * _STROKE)
	while at < length:
		var begins := maxf(at, 0.0)
		var ends := minf(at + _STROKE, length)
		if ends > begins:
			var start := from.move_toward(to, begins)
			var stop := from.move_toward(to, ends)
			draw_line(start, stop, color, Palette.stroke(width), true)
		at += 2.0 * _STROKE


# A scene of parts that is opened or run alone has no board: they are drawn around the origin.
func _board_of_its_own() -> Board:
	if not board:
		board = Board.new()
		add_child(board, false, INTERNAL_MODE_FRONT)
	return board


func _span() -> void:
	if Engine.is_editor_hint() and board:
		board.span(spanned_points())
