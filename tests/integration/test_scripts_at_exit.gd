extends LabTest
## A script that extends another of the project's scripts and makes itself by its class's name,
## `Name.new(...)` instead of `new(...)`, is still in use when Godot ends: Godot then reports leaks.

const _CODE_FOLDERS: PackedStringArray = ["res://scripts", "res://scenes"]

var _class_name := RegEx.create_from_string("(?m)^class_name (\\w+)")
var _base_name := RegEx.create_from_string("(?m)^extends (\\w+)")


func test_no_derived_script_makes_itself_by_its_own_name() -> void:
	var sources := _sources()
	assert_gt(sources.size(), 40, "scripts were found")
	var titles := sources.map(_title)
	for source: String in sources:
		var base := _base_name.search(source)
		if base and base.get_string(1) in titles:
			var itself := _title(source) + ".new("
			assert_false(source.contains(" " + itself), itself)


func _title(source: String) -> String:
	var found := _class_name.search(source)
	return found.get_string(1) if found else ""


func _sources() -> Array:
	var sources := []
	for folder: String in _CODE_FOLDERS:
		_add_sources(folder, sources)
	return sources


func _add_sources(folder: String, sources: Array) -> void:
	for file: String in DirAccess.get_files_at(folder):
		if file.get_extension() == "gd":
			sources.append(FileAccess.get_file_as_string(folder.path_join(file)))
	for inner: String in DirAccess.get_directories_at(folder):
		_add_sources(folder.path_join(inner), sources)
