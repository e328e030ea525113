extends SceneTree
## Begins a lesson as a copy of the smallest one.
## Usage: godot --headless --path . -s tools/lessons/new_lesson.gd -- ID

const LessonCopy := preload("lesson_copy.gd")


func _init() -> void:
	var copy := LessonCopy.new(" ".join(OS.get_cmdline_user_args()))
	var problem := copy.problem()
	if problem:
		printerr("lab: " + problem)
		quit(2)
		return
	var files := copy.files()
	for path: String in files:
		DirAccess.make_dir_recursive_absolute("res://" + path.get_base_dir())
		FileAccess.open("res://" + path, FileAccess.WRITE).store_string(files[path])
		print("written: " + path)
	quit()
