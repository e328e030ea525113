extends SceneTree
## Takes each lesson's picture from build/pictures/ into docs/pictures/, and a small one as its
## card.
## Usage: godot --headless --path . -s tools/draw/keep_pictures.gd -- LESSON ...

const CARD_SIZE := Vector2i(480, 364)
## The board, without the panel: what can be told apart on a card.
const BOARD := Rect2i(0, 56, 830, 630)


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
		picture = picture.get_region(BOARD)
		picture.resize(CARD_SIZE.x, CARD_SIZE.y, Image.INTERPOLATE_LANCZOS)
		error = picture.save_png(ProjectSettings.globalize_path(lesson.card_path()))
	print("%s: %s" % [lesson.id, error_string(error)])
	return error
