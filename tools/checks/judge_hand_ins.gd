extends SceneTree
## Judges hand-ins: each folder inside a folder is one, with the files that a student writes. Prints
## a line for each exercise that is begun, with fields between tabs.
## Usage: godot --headless --path . -s tools/checks/judge_hand_ins.gd -- FOLDER [NAME ...]

const HandIn := preload("hand_in.gd")


func _initialize() -> void:
	var arguments := OS.get_cmdline_user_args()
	if not arguments or not DirAccess.dir_exists_absolute(arguments[0]):
		printerr("usage: judge_hand_ins.gd -- FOLDER [NAME ...]")
		quit(2)
		return
	WorkshopFiles.put_starters()
	var names := arguments.slice(1)
	if not names:
		names = DirAccess.get_directories_at(arguments[0])
	print("hand-in\texercise\tverdict\tmistake\tfile\tline\tprobe\tsentence")
	for hand_in_name in names:
		var hand_in := HandIn.new(arguments[0].path_join(hand_in_name))
		hand_in.judge()
		for row in hand_in.rows():
			print("%s\t%s" % [hand_in_name, row])
	quit()
