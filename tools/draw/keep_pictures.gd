extends SceneTree
## Takes each lesson's picture from build/pictures/ into docs/pictures/, and that of its card to the
## lesson.
## Usage: godot --headless --path . -s tools/draw/keep_pictures.gd -- LESSON ...

const CardPicture := preload("card_picture.gd")


func _init() -> void:
	var failed := 0
	for id: String in OS.get_cmdline_user_args():
		failed += 0 if _keep(LessonIndex.find(id)) == OK else 1
	quit(mini(failed, 1))


func _keep(lesson: LessonInfo) -> Error:
	var card := "%s_%dx%d" % [lesson.id, CardPicture.SIZE.x, CardPicture.SIZE.y]
	var error := _copy(lesson.id, "res://docs/pictures/%s.png" % lesson.id)
	if error == OK:
		error = _copy(card, lesson.card_path())
	print("%s: %s" % [lesson.id, error_string(error)])
	return error


func _copy(drawn: String, kept: String) -> Error:
	return DirAccess.copy_absolute(
		ProjectSettings.globalize_path("res://build/pictures/%s.png" % drawn),
		ProjectSettings.globalize_path(kept)
	)
