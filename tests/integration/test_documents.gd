extends LabTest
## Checks the paths, links, calls and lesson ids in the documents.

## A text in backticks counts as a path of the project if it begins with one of these folders.
const _PATH := "`((?:scripts|scenes|tests|tools|docs|benchmarks|assets|addons)/[\\w./]*)`"
## What "Adding a lesson" calls the lesson that is to be made.
const _PLACEHOLDER := "my_lesson"
## The classes of the variables that the list of queries uses.
const _VARIABLES: Dictionary[String, String] = {
	"ball": "Ball",
	"segment": "LineSegment",
	"velocity": "Vec2",
}
const _LINK := '\\]\\((?!https?:)([^)#]+)\\)|src="([^"]+)"'


func test_every_path_in_backticks_exists() -> void:
	var checked := 0
	for document in _documents():
		for path in _found(document, _PATH):
			if path.contains(_PLACEHOLDER):
				continue
			assert_true(_exists(path), "%s names `%s`" % [document, path])
			checked += 1
	assert_gt(checked, 10, "paths were found")


func test_every_link_and_picture_exists() -> void:
	for document in _documents():
		for target in _found(document, _LINK):
			var path := document.get_base_dir().path_join(target)
			assert_true(_exists(path), "%s links to %s" % [document, target])


func test_the_readme_lists_the_lessons_in_their_order() -> void:
	var listed := _found("README.md", "\\| `(\\w+)` \\| .+ \\|")
	assert_eq(listed, _ids())


func test_every_lesson_has_its_section_for_teachers() -> void:
	var sections := _found("docs/model.md", "(?m)^## `(\\w+)`")
	assert_eq(sections, _ids())


# Those of the lessons, and that of the game.
func _ids() -> PackedStringArray:
	var found: PackedStringArray = []
	for lesson in LessonIndex.all():
		found.append(lesson.id)
	return found


func _documents() -> PackedStringArray:
	var found: PackedStringArray = ["README.md"]
	for file: String in SourceCode.files_below("res://docs", ["md"]):
		found.append(file.trim_prefix("res://"))
	return found


func test_every_call_in_the_list_of_queries_exists() -> void:
	var calls := _found("docs/collision_queries.md", "`(\\w+\\.\\w+)\\(")
	assert_gt(calls.size(), 20, "calls are found")
	for listed in calls:
		var owner_name := listed.get_slice(".", 0)
		owner_name = _VARIABLES.get(owner_name, owner_name)
		assert_has(_methods_of(owner_name), listed.get_slice(".", 1), listed)


func _methods_of(class_name_wanted: String) -> PackedStringArray:
	var found: PackedStringArray = []
	for global_class: Dictionary in ProjectSettings.get_global_class_list():
		if global_class["class"] == class_name_wanted:
			var path: String = global_class["path"]
			for method: Dictionary in (load(path) as GDScript).get_script_method_list():
				var method_name: String = method["name"]
				found.append(method_name)
	return found


func _found(document: String, pattern: String) -> PackedStringArray:
	var found: PackedStringArray = []
	var text := FileAccess.get_file_as_string("res://" + document)
	assert_ne(text, "", document + " can be read")
	for hit in RegEx.create_from_string(pattern).search_all(text):
		var groups := Array(hit.strings.slice(1)).filter(
			func(group: String) -> bool: return group != ""
		)
		found.append_array(PackedStringArray(groups))
	return found


func _exists(path: String) -> bool:
	var full := "res://" + path.simplify_path()
	return FileAccess.file_exists(full) or DirAccess.dir_exists_absolute(full)
