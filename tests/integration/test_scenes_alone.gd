extends ScreenTest
## Every scene can be run by itself, as F6 in the editor does. A lesson's scene then opens the
## lesson in its lesson frame.

const _FOLDERS: PackedStringArray = ["res://scenes", "res://tests/support", "res://workshop"]
const _FRAMES := "10"


func test_a_lesson_that_runs_alone_is_opened_in_its_frame() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		get_tree().change_scene_to_file(lesson.scene_path())
		await student.settle()
		await student.settle()
		assert_not_null(frame(), lesson.id)
		assert_same(frame().lesson_info, lesson, lesson.id)
		assert_eq(frame().lesson.services.size(), lesson.needs.size(), lesson.id)
		get_tree().current_scene.free()
		await student.settle()


func test_no_scene_complains_when_it_runs_alone() -> void:
	var scenes: PackedStringArray = []
	for folder: String in _FOLDERS:
		scenes.append_array(SourceCode.files_below(folder, ["tscn"]))
	assert_gt(scenes.size(), 25, "scenes were found")
	for scene: String in scenes:
		assert_eq(_complaints_of(scene), PackedStringArray(), scene)


func test_a_scene_that_complains_is_found() -> void:
	assert_ne(_complaints_of("res://tests/data/no_such_scene.tscn"), PackedStringArray())


# The errors and warnings that Godot prints when it runs the scene for some frames.
func _complaints_of(scene: String) -> PackedStringArray:
	var arguments: PackedStringArray = ["--headless", "--quit-after", _FRAMES, "--path"]
	arguments.append_array([ProjectSettings.globalize_path("res://"), scene])
	var said := []
	OS.execute(OS.get_executable_path(), arguments, said, true)
	var complaints: PackedStringArray = []
	var output: String = said[0]
	for line: String in output.split("\n"):
		if line.contains("ERROR:") or line.contains("WARNING:"):
			complaints.append(line)
	return complaints
