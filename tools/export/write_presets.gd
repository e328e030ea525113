extends SceneTree
## Writes export_presets.cfg from what each demo needs now, where it is stale.
## Usage: godot --headless --path . -s tools/export/write_presets.gd

const Demos := preload("demos.gd")
const Presets := preload("presets.gd")


func _init() -> void:
	var problems: PackedStringArray = []
	for demo: String in Demos.names():
		problems.append_array(Demos.needed_by(demo).problems)
	for problem: String in problems:
		print("lab: " + problem)
	if problems.is_empty() and Presets.staleness():
		Presets.wanted().save(Presets.FILE)
		print("lab: %s was stale and has been written anew" % Presets.FILE.get_file())
	quit(mini(problems.size(), 1))
