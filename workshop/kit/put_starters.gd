@tool
extends EditorPlugin
## Puts the starters of the workshop in place when the project is opened or imported.

const _FILES := preload("files.gd")


# At the first opening the editor has found out already which files it is going to read. So it is
# told of these after that, or the student would not find his files in its list.
func _enter_tree() -> void:
	if _FILES.put_starters():
		var files := EditorInterface.get_resource_filesystem()
		files.filesystem_changed.connect(_tell, CONNECT_ONE_SHOT)


# In an order in which each file finds the classes that it names. (A second scan would not do: it
# may end while the editor still reads the first one's scripts, and an import ends before it.)
func _tell() -> void:
	for file in _FILES.of_student(_FILES.FOLDER):
		EditorInterface.get_resource_filesystem().update_file(_FILES.FOLDER.path_join(file))
