extends SceneTree
## Prints the id of every lesson, in order, and that of the game, a line each after `lesson `; then
## the names of demos of something else after `demo `.
## Usage: godot --headless --path . -s tools/shared/lesson_ids.gd


func _init() -> void:
	for lesson in LessonIndex.all():
		print("lesson " + lesson.id)
	print("demo workshop")
	quit()
