extends Node
## Lets Godot draw straight into the window instead of into a picture of its own that is then copied
## there. Without a graphics card that copy takes a third of every frame.
##
## The window cannot be read back by `get_texture()` then, so this is for those who look at it:
## `./lab run` and the benchmark of the frame rate.
## [br][br]
## In Godot 4.6 the engine's own switch needs two things besides. It swaps the window's buffers only
## for viewports that are copied, so a second one, two pixels large, is. And it leaves the picture
## upside down, so the canvas is turned over. Other versions may differ: there nothing is done.

const _ENGINE := "4.6."
const _RENDERER := "llvmpipe"
const _CORNER := Rect2(0.0, 0.0, 2.0, 2.0)

var _corner := SubViewport.new()


## Whether it is known to work here, and to be worth it: a processor draws.
static func can_help() -> bool:
	var engine: String = Engine.get_version_info()["string"]
	var renderer := RenderingServer.get_video_adapter_name()
	return engine.begins_with(_ENGINE) and renderer.begins_with(_RENDERER)


func _ready() -> void:
	# Whatever else has to be done in a frame is done by then.
	process_priority = 1000
	_corner.disable_3d = true
	_corner.size = _CORNER.size
	_corner.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	add_child(_corner)
	RenderingServer.viewport_attach_to_screen(_corner.get_viewport_rid(), _CORNER)
	_draw_directly(true)


func _exit_tree() -> void:
	_draw_directly(false)
	_lay(get_window().get_final_transform())


func _draw_directly(directly: bool) -> void:
	var window := get_window()
	RenderingServer.viewport_set_render_direct_to_screen(window.get_viewport_rid(), directly)
	# What stays on the screen has to be put on this one.
	window.size_changed.emit()


# In every frame, because the engine lays the canvas anew with each change of the window.
func _process(_delta: float) -> void:
	var window := get_window()
	var turned_over := Transform2D(Vector2.RIGHT, Vector2.UP, Vector2(0.0, window.size.y))
	_lay(turned_over * window.get_final_transform())


func _lay(canvas: Transform2D) -> void:
	RenderingServer.viewport_set_global_canvas_transform(get_window().get_viewport_rid(), canvas)
