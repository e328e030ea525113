extends SceneTree
## Opens the lab in a window. Usage: godot --path . -s tools/draw/run_lab.gd [-- --lesson=ID]

const DirectDrawing := preload("res://tools/draw/direct_drawing.gd")


func _init() -> void:
	var main_scene: String = ProjectSettings.get_setting("application/run/main_scene")
	change_scene_to_file(main_scene)
	if DirectDrawing.can_help():
		root.add_child(DirectDrawing.new())
