extends LabTest
## Which part of a lesson's picture its card shows.

const KeepPictures := preload("res://tools/draw/keep_pictures.gd")

const _PANEL := Color8(238, 235, 227)
const _WIDTH := 400
const _HEIGHT := 200


# A board that is wide or narrow, above one or two lines of help with a letter in them.
func test_a_card_shows_the_board_without_panel_and_help_line(
	extent: Vector2i = use_parameters([Vector2i(260, 114), Vector2i(242, 88)])
) -> void:
	var picture := Image.create(_WIDTH, _HEIGHT, false, Image.FORMAT_RGB8)
	picture.fill(_PANEL)
	var board := Rect2i(Vector2i(0, KeepPictures.BOARD_TOP), extent)
	picture.fill_rect(board, Palette.PAPER)
	picture.fill_rect(Rect2i(_WIDTH - 8, KeepPictures.BOARD_TOP, 8, 90), Palette.GRID)
	picture.fill_rect(Rect2i(14, _HEIGHT - 20, 100, 10), Palette.color(Palette.Role.INK))
	assert_eq(KeepPictures.board_in(picture), board)
