extends RefCounted
## What in a pack is used, found from the pack's own content: compiled scripts, scenes, its list of
## classes. It knows nothing of how the list of files for the export came about.

const CompiledScript := preload("compiled_script.gd")
const Pack := preload("pack.gd")

## What the engine itself reads from a pack.
const ENGINE_FILES: PackedStringArray = [
	"project.binary",
	".godot/global_script_class_cache.cfg",
	".godot/uid_cache.bin",
	"input_actions.bin"
]
# What the script reads that knows the student's files; without `res://`.
const _READS_STARTERS := "res://workshop/kit/files.gd"
const _READ_BY_IT: PackedStringArray = [
	"answer_key.txt",
	"workshop/starters/my_vec2.gd",
	"workshop/starters/my_line.gd",
	"workshop/starters/my_impact.gd",
	"workshop/starters/my_bounce.gd",
	"workshop/starters/my_aim.gd",
]
const _CARD := "res://scenes/shell/lesson_card.gd"

## Every resource in the pack by its path in the project, such as `res://scripts/vec2.gd`; sorted.
var resources: PackedStringArray
## Files of the pack that nothing in it uses; without `res://`.
var unused: PackedStringArray
## Scripts that are not in the form that is known; by their paths.
var unreadable: PackedStringArray
## Classes that the pack lists and does not hold, by their paths.
var missing_classes: PackedStringArray

var _pack: Pack
# For each resource the files of the pack that it consists of; the last holds its content.
var _files: Dictionary[String, PackedStringArray] = {}
var _class_paths: Dictionary[String, String] = {}
var _reached: Dictionary[String, bool] = {}


## [param starts]: where the demo starts, in `res://`; the pack's lessons are starts, too.
func _init(pack: Pack, starts: PackedStringArray) -> void:
	_pack = pack
	for file: String in pack.sizes:
		if file.get_extension() in ["remap", "import"]:
			_note_resource(file)
	resources = PackedStringArray(_files.keys())
	resources.sort()
	_read_classes()
	_walk(starts)
	_note_unused()


func _note_resource(pointer: String) -> void:
	var config := ConfigFile.new()
	config.parse(_pack.bytes_of(pointer).get_string_from_utf8())
	var files: PackedStringArray = [pointer]
	for key: String in config.get_section_keys("remap"):
		if key.begins_with("path"):
			var path: String = config.get_value("remap", key)
			files.append(path.trim_prefix("res://"))
	_files["res://" + pointer.get_basename()] = files


func _read_classes() -> void:
	var config := ConfigFile.new()
	config.parse(_pack.bytes_of(ENGINE_FILES[1]).get_string_from_utf8())
	for entry: Dictionary in config.get_value("", "list", []):
		var path: String = entry["path"]
		_class_paths[entry["class"]] = path
		if not _files.has(path):
			missing_classes.append(path)


func _walk(starts: PackedStringArray) -> void:
	var waiting := starts.duplicate()
	for path: String in resources:
		if path.get_file() == "lesson.tres":
			waiting.append(path)
	while not waiting.is_empty():
		var path := waiting[-1]
		waiting.remove_at(waiting.size() - 1)
		if _files.has(path) and not _reached.has(path):
			_reached[path] = true
			waiting.append_array(_used_by(path))


func _used_by(path: String) -> PackedStringArray:
	if path.get_extension() == "gd":
		return _used_by_script(path)
	var used: PackedStringArray = []
	if path.get_extension() in ["tscn", "tres"]:
		var copy := _copy_of(path)
		for dependency: String in ResourceLoader.get_dependencies(copy):
			used.append(dependency.get_slice("::", dependency.get_slice_count("::") - 1))
		if path.get_file() == "lesson.tres":
			used.append_array(_used_by_lesson(path, load(copy) as LessonInfo))
		DirAccess.remove_absolute(copy)
	return used


func _used_by_script(path: String) -> PackedStringArray:
	var script := CompiledScript.new(_pack.bytes_of(_files[path][-1]))
	if not script.is_valid:
		unreadable.append(path)
	var used := script.strings
	for word: String in script.names:
		if _class_paths.has(word):
			used.append(_class_paths[word])
	return used


func _used_by_lesson(path: String, lesson: LessonInfo) -> PackedStringArray:
	var used: PackedStringArray = [path.get_base_dir().path_join("%s.tscn" % lesson.id)]
	for need: String in lesson.needs:
		used.append(LessonFrame.SERVICE_SCENE % need)
	if _files.has(_CARD):
		used.append(path.get_base_dir().path_join("card.png"))
	return used


# The engine reads dependencies from files only.
func _copy_of(path: String) -> String:
	var inner := _files[path][-1]
	var file := FileAccess.create_temp(FileAccess.WRITE, "pack", inner.get_extension(), true)
	file.store_buffer(_pack.bytes_of(inner))
	file.close()
	return file.get_path()


func _note_unused() -> void:
	var icon: String = ProjectSettings.get_setting("application/config/icon")
	var used := ENGINE_FILES + PackedStringArray([icon.trim_prefix("res://")])
	for path: String in _reached:
		used.append_array(_files[path])
	if _reached.has(_READS_STARTERS):
		used.append_array(_READ_BY_IT)
	for file: String in _pack.sizes:
		if not file in used:
			unused.append(file)
