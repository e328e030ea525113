extends SceneTree
## Makes a class of hand-ins to grade: all of tests/data/hand_ins, and those that are hard.
## Usage: godot --headless --path . -s tests/support/make_class.gd -- FOLDER

const _MEGABYTES := 100


func _initialize() -> void:
	var folder := OS.get_cmdline_user_args()[0]
	var hard := HardHandIns.new(folder)
	hard.make_all(_MEGABYTES)
	for name in DirAccess.get_directories_at(HandIns.FOLDER):
		for file in DirAccess.get_files_at(HandIns.FOLDER.path_join(name)):
			var path := name.path_join(file)
			hard.put(path, FileAccess.get_file_as_bytes(HandIns.FOLDER.path_join(path)))
	quit()
