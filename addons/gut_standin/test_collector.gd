extends RefCounted
## Finds the test scripts, and the tests in them.

const CollectedScript := preload("collected_script.gd")
const TestScript := preload("test.gd")

var scripts: Array[CollectedScript] = []


## All scripts below [param folder] that are named like tests; with [param select], only those whose
## path contains it.
func add_folder(folder: String, prefix: String, suffix: String, deep: bool, select: String) -> void:
	for path: String in _files_below(folder, prefix, suffix, deep):
		if select.is_empty() or path.containsn(select):
			add_script(path)


func add_script(path: String) -> void:
	var script := load(path) as GDScript
	if not _is_test(script):
		print("[WARNING]: Ignoring script %s because it does not extend GutTest" % path)
		return
	scripts.append(CollectedScript.from(path, script))
	var constants := script.get_script_constant_map()
	for name: String in constants:
		if name.begins_with("Test") and constants[name] is GDScript:
			var inner: GDScript = constants[name]
			if _is_test(inner):
				scripts.append(CollectedScript.from(path, inner, name))


func _is_test(script: GDScript) -> bool:
	var base := script
	while base != null:
		if base == TestScript:
			return script.can_instantiate()
		base = base.get_base_script()
	return false


func _files_below(folder: String, prefix: String, suffix: String, deep: bool) -> PackedStringArray:
	var found := PackedStringArray()
	for file: String in DirAccess.get_files_at(folder):
		if file.begins_with(prefix) and file.ends_with(suffix):
			found.append(folder.path_join(file))
	if deep:
		for inner: String in DirAccess.get_directories_at(folder):
			found.append_array(_files_below(folder.path_join(inner), prefix, suffix, deep))
	found.sort()
	return found
