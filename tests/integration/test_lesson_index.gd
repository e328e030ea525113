extends LabTest
## The index of lessons against what lies in their folders.

const _LESSONS := "res://scenes/lessons/"
const _SERVICES := "res://scenes/widgets/services/"
# The methods of a lesson that use a service for it.
const _CALLS: Dictionary[String, PackedStringArray] = {
	"steps": ["tell_steps("],
	"code": ["tell_code("],
	"options": ["add_switch(", "offer_presets("],
	"mistakes": ["offer_mistakes("],
	"question": ["offer_questions("],
}


func test_the_index_names_every_folder_once_and_no_other() -> void:
	var folders := Array(DirAccess.get_directories_at(_LESSONS)).filter(
		func(folder: String) -> bool: return folder != "smallest_lesson"
	)
	folders.sort()
	assert_eq(Array(LessonIndex.FOLDERS), folders)


func test_folders_are_numbered_in_order_without_a_hole() -> void:
	for i: int in LessonIndex.FOLDERS.size():
		assert_string_starts_with(LessonIndex.FOLDERS[i], "l%02d_" % (i + 1))


func test_ids_are_snake_case_without_a_number_and_unique() -> void:
	var snake_case := RegEx.create_from_string("^[a-z]+(_[a-z]+)*$")
	var seen: Array[String] = []
	for id: String in LessonIndex.ids():
		assert_not_null(snake_case.search(id), "“%s” is snake_case" % id)
		assert_does_not_have(seen, id)
		seen.append(id)


func test_every_folder_is_named_after_its_lesson() -> void:
	for i: int in LessonIndex.FOLDERS.size():
		assert_string_ends_with(LessonIndex.FOLDERS[i], LessonIndex.ids()[i])


func test_every_lesson_has_its_scene_card_title_and_summary() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		assert_true(ResourceLoader.exists(lesson.scene_path()), lesson.scene_path())
		assert_true(ResourceLoader.exists(lesson.card_path()), lesson.card_path())
		assert_ne(lesson.title, "", lesson.id)
		assert_ne(lesson.summary, "", lesson.id)


func test_every_need_is_a_service_named_once() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		for need: String in lesson.needs:
			assert_true(ResourceLoader.exists(_SERVICES + need + ".tscn"), need)
			assert_eq(lesson.needs.count(need), 1, need)


func test_the_index_finds_each_lesson_by_id_and_says_its_place() -> void:
	for i: int in LessonIndex.ids().size():
		var lesson := LessonIndex.find(LessonIndex.ids()[i])
		assert_eq(LessonIndex.number_of(lesson), i + 1)
	assert_null(LessonIndex.find("no_such_lesson"))


# A lesson uses a service if one of its scripts names the service's class, or calls the method with
# which a lesson uses it.
func test_lessons_need_exactly_the_services_that_their_scripts_use() -> void:
	var classes := _service_classes()
	assert_gt(classes.size(), 5, "services were found")
	for lesson: LessonInfo in LessonIndex.lessons():
		var code := _code_in(lesson.resource_path.get_base_dir())
		var used := classes.keys().filter(
			func(need: String) -> bool:
				var calls: PackedStringArray = _CALLS.get(need, PackedStringArray())
				var is_called := func(method: String) -> bool: return code.contains(method)
				return Array(calls).any(is_called) or _names(code, classes[need])
		)
		var needed := Array(lesson.needs)
		needed.sort()
		assert_eq(used, needed, "needs of " + lesson.id)


# The class of each service, by its name in `needs`, in the order of the names.
func _service_classes() -> Dictionary[String, String]:
	var found: Dictionary[String, String] = {}
	for file: String in DirAccess.get_files_at(_SERVICES):
		if file.get_extension() == "tscn":
			var service := (load(_SERVICES + file) as PackedScene).instantiate()
			var script: Script = service.get_script()
			found[file.get_basename()] = script.get_global_name()
			service.free()
	found.sort()
	return found


func _code_in(folder: String) -> String:
	var text_or_comment := RegEx.create_from_string('(?m)"(?:[^"\\\\]|\\\\.)*"|#.*$')
	var code := ""
	for file: String in DirAccess.get_files_at(folder):
		if file.get_extension() == "gd":
			var source := FileAccess.get_file_as_string(folder.path_join(file))
			code += text_or_comment.sub(source, "", true)
	return code


func _names(code: String, class_title: String) -> bool:
	return RegEx.create_from_string("\\b%s\\b" % class_title).search(code) != null
