extends LabTest
## The files that a demo needs, worked out from small cases in tests/data/export/ and from the
## lessons.

const Demos := preload("res://tools/export/demos.gd")
const NeededFiles := preload("res://tools/export/needed_files.gd")

const _FOLDER := "res://tests/data/export/"


func test_classes_paths_parents_and_what_scenes_name_are_followed() -> void:
	var needed := NeededFiles.new([_FOLDER + "start.gd"])
	var wanted: PackedStringArray = [
		"res://assets/icons/next_impact.svg",
		"res://scripts/lesson/exercise.gd",
		"res://scripts/lesson/lesson_info.gd",
		_FOLDER + "beside.gd",
		_FOLDER + "board.tscn",
		_FOLDER + "start.gd",
	]
	for file: String in wanted:
		assert_has(needed.files, file)
	assert_does_not_have(needed.files, "res://scripts/world/event/event_world.gd")
	assert_does_not_have(needed.files, "res://scripts/shapes/ball.gd")
	assert_does_not_have(needed.files, "res://scenes/widgets/board/plot.gd")
	assert_eq(needed.problems, PackedStringArray())


func test_what_cannot_be_followed_is_said() -> void:
	var problems := "\n".join(NeededFiles.new([_FOLDER + "astray.gd"]).problems)
	assert_string_contains(
		problems, "astray.gd: it cannot be told which files “res://assets/sounds"
	)
	assert_string_contains(problems, "not_there.tscn is needed and is not there")


func test_a_lesson_needs_its_scene_and_its_services() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		var files := NeededFiles.new([lesson.resource_path]).files
		assert_has(files, lesson.scene_path())
		for need: String in lesson.needs:
			assert_has(files, LessonFrame.SERVICE_SCENE % need)
		assert_does_not_have(files, lesson.card_path())


func test_only_a_lesson_with_a_guess_in_its_scene_needs_the_guess() -> void:
	var guess := "res://scenes/widgets/board/guess.gd"
	for lesson: LessonInfo in LessonIndex.lessons():
		var scene := FileAccess.get_file_as_string(lesson.scene_path())
		var files := NeededFiles.new([lesson.resource_path]).files
		assert_eq(guess in files, scene.contains(guess), lesson.id)


func test_a_demo_has_the_lesson_the_theme_and_no_start_screen() -> void:
	for demo: String in LessonIndex.ids():
		var needed := Demos.needed_by(demo)
		assert_eq(needed.problems, PackedStringArray(), demo)
		assert_has(needed.files, LessonIndex.find(demo).resource_path)
		assert_has(needed.files, "res://assets/theme.tres")
		assert_does_not_have(needed.files, "res://scenes/shell/start_screen.tscn", demo)


func test_the_lab_has_every_lesson_with_its_card() -> void:
	var files := Demos.needed_by(Demos.LAB).files
	assert_has(files, "res://scenes/shell/start_screen.tscn")
	assert_does_not_have(files, "res://scenes/shell/demo.tscn")
	for lesson: LessonInfo in LessonIndex.lessons():
		assert_has(files, lesson.scene_path())
		assert_has(files, lesson.card_path())
