@tool
extends EditorPlugin
## Puts the starters of the workshop in place when the project is opened or imported.

const _FILES := preload("files.gd")


# At the first opening the editor has found out already which files it is going to read. So it must
# look again after that, or the student would not find his files in its list.
func _enter_tree() -> void:
	var has_copied := not _FILES.put_starters().is_empty()
	# An import ends before it could look again, and the next opening sees them.
	if has_copied and DisplayServer.get_name() != "headless":
		var files := EditorInterface.get_resource_filesystem()
		files.filesystem_changed.connect(files.scan, CONNECT_ONE_SHOT)
