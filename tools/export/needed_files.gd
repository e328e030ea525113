extends RefCounted
## All files that some files need, worked out from the scripts and scenes themselves: Godot's own
## list of what a script depends on is empty.
##
## Followed are class names and paths in scripts, what scenes and resources name, and from a
## lesson's [LessonInfo] its scene and its services.

const WrittenCode := preload("written_code.gd")

## Paths with a place for a name, which the [LessonInfo] fills: only those can be followed.
const _FILLED_BY_LESSONS: PackedStringArray = [
	LessonIndex.LESSON_FILE, LessonIndex.GAME_FILE, LessonFrame.SERVICE_SCENE
]

## What is needed, the files at the start included; sorted.
var files: PackedStringArray
## A sentence for each path that cannot be followed; empty when all is well.
var problems: PackedStringArray

var _class_paths: Dictionary[String, String] = {}
var _found: Dictionary[String, bool] = {}


## [param starts]: paths in `res://`.
func _init(starts: PackedStringArray) -> void:
	for global_class: Dictionary in ProjectSettings.get_global_class_list():
		_class_paths[global_class["class"]] = global_class["path"]
	var waiting := starts.duplicate()
	while not waiting.is_empty():
		var path := waiting[-1]
		waiting.remove_at(waiting.size() - 1)
		if not _found.has(path):
			_found[path] = true
			waiting.append_array(_named_in(path))
	files = PackedStringArray(_found.keys())
	files.sort()


func _named_in(path: String) -> PackedStringArray:
	if not ResourceLoader.exists(path):
		problems.append("%s is needed and is not there" % path)
		return []
	if path.get_extension() == "gd":
		return _named_in_script(path)
	var named: PackedStringArray = []
	for dependency: String in ResourceLoader.get_dependencies(path):
		named.append(dependency.get_slice("::", dependency.get_slice_count("::") - 1))
	if path.get_extension() == "tres" and load(path) is LessonInfo:
		named.append_array(_brought_by_frame(load(path) as LessonInfo))
	return named


func _brought_by_frame(lesson: LessonInfo) -> PackedStringArray:
	var brought: PackedStringArray = [lesson.scene_path()]
	for need: String in lesson.needs:
		brought.append(LessonFrame.SERVICE_SCENE % need)
	return brought


func _named_in_script(path: String) -> PackedStringArray:
	var named: PackedStringArray = []
	var code := FileAccess.get_file_as_string(path)
	for word: String in WrittenCode.names_in(code):
		if _class_paths.has(word):
			named.append(_class_paths[word])
	for string: String in WrittenCode.strings_in(code):
		named.append_array(_named_by_string(string, path))
	return named


func _named_by_string(string: String, script: String) -> PackedStringArray:
	if string.begins_with("uid://"):
		return [ResourceUID.uid_to_path(string)]
	if not string.begins_with("res://"):
		var beside := script.get_base_dir().path_join(string)
		return [beside] if string.get_extension() and ResourceLoader.exists(beside) else []
	if not string.contains("%"):
		return [string]
	if not string in _FILLED_BY_LESSONS:
		problems.append("%s: it cannot be told which files “%s” names" % [script, string])
	return []
