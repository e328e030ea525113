extends SceneTree
## Starts the lab as a user does, saves what is on the screen, and fails when that is blank.
## Usage: godot --path . --resolution 1280x720 --fixed-fps 60 -s tools/draw_picture.gd
## -- --picture=FILE [--lesson=ID]

## Half a second: what moves into place has arrived.
const FRAMES := 30
const FEWEST_COLORS := 16
const ARGUMENT := "--picture="


func _init() -> void:
	var main_scene: String = ProjectSettings.get_setting("application/run/main_scene")
	change_scene_to_file(main_scene)
	for frame: int in FRAMES:
		await process_frame
	await RenderingServer.frame_post_draw
	var picture := root.get_texture().get_image()
	var colors := _count_colors(picture)
	print("%dx%d, %d colors" % [picture.get_width(), picture.get_height(), colors])
	var saved := picture.save_png(_path())
	quit(0 if saved == OK and colors >= FEWEST_COLORS and picture.get_size() == root.size else 1)


func _path() -> String:
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with(ARGUMENT):
			return argument.trim_prefix(ARGUMENT)
	return ""


## Of every fourth pixel in each direction.
func _count_colors(picture: Image) -> int:
	var seen := {}
	for y: int in range(0, picture.get_height(), 4):
		for x: int in range(0, picture.get_width(), 4):
			seen[picture.get_pixel(x, y)] = true
	return seen.size()
