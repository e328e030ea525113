extends SceneTree
## Prints the id of every lesson, in order, a line each after `lesson `.
## Usage: godot --headless --path . -s tools/shared/lesson_ids.gd


func _init() -> void:
	for id: String in LessonIndex.ids():
		print("lesson " + id)
	quit()
