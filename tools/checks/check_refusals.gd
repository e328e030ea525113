extends SceneTree
## Finds dropped refusals. A method of ours that refuses something returns a String, "" when all is
## well. Its answer must be asserted, shown, or passed to [method Refusal.push].
##
## Godot says which statements drop the value of a call, but not the value's type. So the name
## decides: it is a finding if a script of the project declares a method of this name with
## `-> String`. Godot does not look behind `await`.
##
## Usage: godot --headless --path . -s tools/checks/check_refusals.gd

const SETTING := "debug/gdscript/warnings/return_value_discarded"
const ERROR := 2

# The end of the declaration of a function: its name, and the type that it returns.
const _DECLARATION := r"(?ms)^(?:static )?func (\w+)\(.*?\) ->\s*([\w\[\], .]+):"

# A statement or a lambda that begins with the call of one of these methods: only names, dots and
# closed parentheses come before it. Scripts without one are not compiled, which saves seconds.
const _CALL := r"(?m)^\t+(?:.*: |\. )?(?:[^\s(=]|\([^()\n]*\))*?\b(%s)\("


func _init() -> void:
	ProjectSettings.set_setting(SETTING, ERROR)
	# Godot takes the setting over in a deferred call; see check_scripts.gd.
	await ProjectSettings.settings_changed
	var sources: Dictionary[String, String] = {}
	_read_scripts_below("res://", sources)
	var names := _names_of_methods_that_return_a_string(sources)
	var dropped := DroppedValues.new()
	OS.add_logger(dropped)
	var one_call := RegEx.create_from_string(_CALL % "|".join(names))
	for path in sources:
		if one_call.search(sources[path]):
			ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
	OS.remove_logger(dropped)
	var failed := 0
	for place in dropped.names:
		if dropped.names[place] in names:
			print("%s: the answer of %s() is dropped" % [place, dropped.names[place]])
			failed += 1
	print("Refusals: %d scripts, %d dropped" % [sources.size(), failed])
	quit(1 if failed > 0 or sources.is_empty() else 0)


func _names_of_methods_that_return_a_string(
	sources: Dictionary[String, String]
) -> PackedStringArray:
	var names: Dictionary[String, bool] = {}
	var declaration := RegEx.create_from_string(_DECLARATION)
	for path in sources:
		for found in declaration.search_all(sources[path]):
			if found.get_string(2) == "String":
				names[found.get_string(1)] = true
	return PackedStringArray(names.keys())


# The scripts of the project without its addons, and what is written in them.
func _read_scripts_below(folder: String, sources: Dictionary[String, String]) -> void:
	if folder in ["res://addons", "res://build"] or _is_ignored(folder):
		return
	for file in DirAccess.get_files_at(folder):
		if file.get_extension() == "gd":
			var path := folder.path_join(file)
			sources[path] = FileAccess.get_file_as_string(path)
	for inner in DirAccess.get_directories_at(folder):
		if not inner.begins_with("."):
			_read_scripts_below(folder.path_join(inner), sources)


func _is_ignored(folder: String) -> bool:
	return FileAccess.file_exists(folder.path_join(".gdignore"))


## Notes where Godot says that a value is dropped.
class DroppedValues:
	extends Logger

	## The names of the called functions by `file:line`.
	var names: Dictionary[String, String] = {}

	var _message := RegEx.create_from_string(
		r'function "(\w+)\(\)" returns a value that will be discarded'
	)

	func _log_error(
		_function: String,
		file: String,
		line: int,
		code: String,
		rationale: String,
		_editor_notify: bool,
		_error_type: int,
		_backtraces: Array[ScriptBacktrace]
	) -> void:
		var found := _message.search(code + rationale)
		if found:
			names["%s:%d" % [file.trim_prefix("res://"), line]] = found.get_string(1)
