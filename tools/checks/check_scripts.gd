extends SceneTree
## Loads every script of the project with Godot's warnings turned into errors, and fails when one
## does not load.
## Usage: godot --headless --path . -s tools/checks/check_scripts.gd [-- --with-addons]

const WITH_ADDONS := "--with-addons"
const WARNINGS := "debug/gdscript/warnings/"
const KIT := "res://workshop/kit"
const WARN := 1
const ERROR := 2


func _init() -> void:
	if _turn_warnings_into_errors():
		# Godot takes the settings over in a deferred call. That call comes before the first
		# process_frame only if this frame has a physics step, so one frame may be too short.
		await ProjectSettings.settings_changed
	var failed := 0
	var scripts := _scripts_below("res://")
	for path: String in scripts:
		if not _passes(path):
			print("%s does not pass Godot's check" % path.trim_prefix("res://"))
			failed += 1
	print("Godot's check: %d scripts, %d failed" % [scripts.size(), failed])
	quit(1 if failed > 0 or scripts.is_empty() else 0)


func _passes(path: String) -> bool:
	var own: GDScript = get_script()
	if path == own.resource_path:
		# Loading the script that runs would change it while it runs.
		var copy := GDScript.new()
		copy.source_code = own.source_code
		return copy.reload() == OK
	# Not from the cache: what was loaded before the settings changed is checked too.
	var script := ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE) as GDScript
	return script != null and (script.can_instantiate() or script.is_abstract())


## Warnings that the project has switched off stay off. Returns whether a setting has changed.
func _turn_warnings_into_errors() -> bool:
	var changed := WITH_ADDONS in OS.get_cmdline_user_args()
	if changed:
		ProjectSettings.set_setting(WARNINGS + "directory_rules", {})
	for property: Dictionary in ProjectSettings.get_property_list():
		var setting: String = property["name"]
		if setting.begins_with(WARNINGS) and is_same(ProjectSettings.get_setting(setting), WARN):
			ProjectSettings.set_setting(setting, ERROR)
			changed = true
	return changed


func _scripts_below(folder: String) -> PackedStringArray:
	var found := PackedStringArray()
	if folder == "res://addons" and WITH_ADDONS not in OS.get_cmdline_user_args():
		return found
	if folder == "res://workshop":
		# What a student writes is his own affair.
		return _scripts_below(KIT)
	if folder == "res://build" or FileAccess.file_exists(folder.path_join(".gdignore")):
		return found
	for file: String in DirAccess.get_files_at(folder):
		if file.get_extension() == "gd":
			found.append(folder.path_join(file))
	for inner: String in DirAccess.get_directories_at(folder):
		if not inner.begins_with("."):
			found.append_array(_scripts_below(folder.path_join(inner)))
	return found
