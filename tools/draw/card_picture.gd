extends RefCounted
## The picture on a lesson's card: the board alone, without any text. At the size of a card no text
## could be read, and a picture without words is the same in every language.

## Size of the picture, and of the window that it is drawn in.
const SIZE := Vector2i(480, 364)
## Width of the board that is drawn so small, in its own pixels: what lies on it keeps apart.
const BOARD_WIDTH := 640.0
## Pixels that stay free around what the board is fitted to.
const MARGIN := 44.0
## What is beside the drawing, and says little without its text.
const _BESIDE: PackedStringArray = ["PanelContainer", "Plot"]
## What a plot has above and below its field: the marks of the legend and the titles of the axes.
const _ABOVE_PLOT := 196.0
const _BELOW_PLOT := 36.0
## Too small to be seen.
const _NO_SIZE := Transform2D(Vector2(1e-4, 0.0), Vector2(0.0, 1e-4), Vector2.ZERO)


## From now on nothing that is written can be seen.
static func hide_text() -> void:
	var font := FontVariation.new()
	font.base_font = ThemeDB.fallback_font
	font.variation_transform = _NO_SIZE
	ThemeDB.fallback_font = font
	ThemeDB.get_project_theme().default_font = font


## Gives the board of the lesson in [param frame] the whole window, and takes away what would be an
## empty card without its text.
static func show_board_alone(frame: LessonFrame) -> void:
	var window := frame.get_window()
	window.content_scale_factor *= SIZE.x / BOARD_WIDTH / window.get_final_transform().get_scale().x
	var board := frame.lesson.board
	board.margin = MARGIN
	for kind in _BESIDE:
		for part: Control in board.find_children("*", kind, true, false):
			part.modulate = Color.TRANSPARENT
	for plot: LogPlot in board.find_children("*", "LogPlot", true, false):
		plot.offset_top -= _ABOVE_PLOT
		plot.offset_bottom += _BELOW_PLOT
	for part: Control in frame.find_children("*", "Control", true, false):
		if not part.is_ancestor_of(board) and not board.is_ancestor_of(part) and part != board:
			part.hide()
