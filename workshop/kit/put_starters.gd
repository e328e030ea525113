@tool
extends EditorPlugin
## Puts the starters of the workshop in place when the project is opened or imported.

const _FILES := preload("files.gd")


# Comes before the editor reads the project: so it finds them by itself.
func _enter_tree() -> void:
	_FILES.put_starters()
