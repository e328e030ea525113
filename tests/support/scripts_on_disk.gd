class_name ScriptsOnDisk
extends RefCounted
## The scripts that lie on disk, whether or not they parse.

const SKIPPED := ["res://addons", "res://build"]


## The paths of all `test_*.gd` below [param folder]; folders that Godot ignores are left out.
static func tests_below(folder: String) -> PackedStringArray:
	var found := PackedStringArray()
	if folder in SKIPPED or FileAccess.file_exists(folder.path_join(".gdignore")):
		return found
	for file: String in DirAccess.get_files_at(folder):
		if file.begins_with("test_") and file.ends_with(".gd"):
			found.append(folder.path_join(file))
	for inner: String in DirAccess.get_directories_at(folder):
		if not inner.begins_with("."):
			found.append_array(tests_below(folder.path_join(inner)))
	return found
