extends LabTest
## The copy of the smallest lesson with which `./lab new_lesson` begins a lesson.

const LessonCopy := preload("res://tools/lessons/lesson_copy.gd")

const _NEW_INDEX := "scenes/lessons/lesson_index.gd"

var _copy := LessonCopy.new("my_lesson")
var _files := _copy.files()


func test_an_id_that_no_lesson_can_have_is_refused() -> void:
	for id: String in ["", "MyLesson", "my lesson", "my-lesson", "lesson_2", "../up"]:
		assert_string_contains(LessonCopy.new(id).problem(), "not '%s'" % id)
	for id: String in ["dot_product", "smallest_lesson"]:
		assert_eq(LessonCopy.new(id).problem(), "there is a lesson '%s' already" % id)
	assert_eq(_copy.problem(), "")


func test_the_copy_has_the_files_of_a_lesson_and_its_test() -> void:
	var folder := "scenes/lessons/l%02d_my_lesson/" % (LessonIndex.FOLDERS.size() + 1)
	assert_eq(
		_files.keys(),
		(
			[
				folder + "lesson.tres",
				folder + "my_lesson.gd",
				folder + "my_lesson.tscn",
				"tests/integration/lessons/my_lesson/test_my_lesson.gd",
				_NEW_INDEX,
			]
			as Array[String]
		)
	)
	assert_string_contains(_file("lesson.tres"), '&"my_lesson"\ntitle = "My lesson"\n')
	assert_string_contains(_file("my_lesson.tscn"), 'path="res://%smy_lesson.gd"' % folder)
	assert_string_contains(_file("my_lesson.tscn"), '[node name="MyLesson" type="Control"')


func test_the_copy_does_not_speak_of_the_smallest_lesson() -> void:
	for path: String in _files:
		if path != _NEW_INDEX:
			assert_does_not_contain(_files[path], "mallest")
			assert_does_not_contain(_files[path], "new_lesson")


func test_the_copy_has_no_uid_of_the_old_scene_and_script() -> void:
	var old := FileAccess.get_file_as_string(
		"res://scenes/lessons/smallest_lesson/smallest_lesson.tscn"
	)
	var copied := _file("my_lesson.tscn")
	assert_eq(old.count(' uid="uid://'), 5)
	assert_eq(copied.count(' uid="uid://'), 3, "the board, its grid and the vector keep theirs")
	assert_string_starts_with(copied, "[gd_scene format=3]\n")


func test_the_index_ends_with_the_new_lesson() -> void:
	var old := FileAccess.get_file_as_string("res://" + _NEW_INDEX)
	var line := '\t"%s",\n' % _copy.folder
	assert_string_contains(_files[_NEW_INDEX], line + "]\n")
	assert_eq(_files[_NEW_INDEX].replace(line, ""), old)


func assert_does_not_contain(text: String, part: String) -> void:
	assert_eq(text.count(part), 0, part)


func _file(file: String) -> String:
	for path: String in _files:
		if path.get_file() == file:
			return _files[path]
	return ""
