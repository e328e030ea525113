extends SceneTree
## Takes each lesson's picture from build/pictures/ into docs/pictures/, and a small one as its
## card.
## Usage: godot --headless --path . -s tools/draw/keep_pictures.gd -- LESSON ...

## A card's picture is at most as large.
const CARD_SIZE := Vector2i(480, 364)
## Where the board begins, below the head.
const BOARD_TOP := 56


func _init() -> void:
	var failed := 0
	for id: String in OS.get_cmdline_user_args():
		failed += 0 if _keep(LessonIndex.find(id)) == OK else 1
	quit(mini(failed, 1))


func _keep(lesson: LessonInfo) -> Error:
	var picture := Image.new()
	var drawn := ProjectSettings.globalize_path("res://build/pictures/%s.png" % lesson.id)
	var kept := ProjectSettings.globalize_path("res://docs/pictures/%s.png" % lesson.id)
	var error := picture.load(drawn)
	if error == OK:
		error = picture.save_png(kept)
	if error == OK:
		picture = _card(picture)
		error = picture.save_png(ProjectSettings.globalize_path(lesson.card_path()))
	print("%s: %s" % [lesson.id, error_string(error)])
	return error


# The board, without the panel and the help line: what can be told apart on a card.
func _card(picture: Image) -> Image:
	var board := board_in(picture)
	var card := picture.get_region(board)
	var scale := minf(float(CARD_SIZE.x) / board.size.x, float(CARD_SIZE.y) / board.size.y)
	var extent := Vector2i((Vector2(board.size) * scale).round())
	card.resize(extent.x, extent.y, Image.INTERPOLATE_LANCZOS)
	return card


## Where the board is in the picture of a lesson. Panel and help line have one color; at the panel's
## right edge its scroll bar may be.
static func board_in(picture: Image) -> Rect2i:
	var bottom := picture.get_height()
	var panel := picture.get_pixel(0, bottom - 1)
	while bottom > BOARD_TOP and picture.get_pixel(0, bottom - 1) == panel:
		bottom -= 1
	var right := picture.get_width() - 20
	while right > 0 and picture.get_pixel(right - 1, BOARD_TOP + 1) == panel:
		right -= 1
	return Rect2i(0, BOARD_TOP, right, bottom - BOARD_TOP)
