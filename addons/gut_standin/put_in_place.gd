@tool
extends EditorPlugin
## Puts the stand-in into addons/gut while GUT is not installed there: without a file at the path of
## GUT's base class, every test would be an error in the editor.
##
## The Asset Library installs no file over one that exists. So the stand-in makes room for GUT while
## the Asset Library is open.

const STAND_IN := "res://addons/gut_standin/as_gut"
const PLACE := "res://addons/gut"
const PLUGIN := "res://addons/gut/plugin.cfg"
const ASSET_LIBRARY := "Asset"
const RELOAD := "GUT is installed. Project > Reload Current Project shows its panel."

var _has_made_room := false


func _enter_tree() -> void:
	_put()
	main_screen_changed.connect(_on_main_screen_changed)


func _on_main_screen_changed(screen_name: String) -> void:
	if screen_name.begins_with(ASSET_LIBRARY):
		_make_room()
	elif _has_made_room:
		_has_made_room = false
		_put()
		if not _is_stand_in():
			EditorInterface.get_editor_toaster().push_toast(RELOAD)


## Does nothing where GUT is.
func _put() -> void:
	if FileAccess.file_exists(PLUGIN) and not _is_stand_in():
		return
	DirAccess.make_dir_recursive_absolute(PLACE)
	for file: String in _files():
		var text := FileAccess.get_file_as_string(STAND_IN.path_join(file))
		if text != FileAccess.get_file_as_string(PLACE.path_join(file)):
			DirAccess.copy_absolute(STAND_IN.path_join(file), PLACE.path_join(file))


func _make_room() -> void:
	if not _is_stand_in():
		return
	_has_made_room = true
	for file: String in DirAccess.get_files_at(PLACE):
		if file.trim_suffix(".uid") in _files():
			DirAccess.remove_absolute(PLACE.path_join(file))


func _is_stand_in() -> bool:
	return FileAccess.get_file_as_string(PLUGIN).contains("stand-in")


func _files() -> PackedStringArray:
	return DirAccess.get_files_at(STAND_IN)
