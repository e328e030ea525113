extends "res://addons/gut/hook_script.gd"
## Runs before the first test. From this line on the runner itself watches the engine's errors.


func run() -> void:
	DirAccess.make_dir_recursive_absolute("res://build/test")
	var marker := FileAccess.open("res://build/.gdignore", FileAccess.WRITE)
	marker.close()
	print("=== first test")
