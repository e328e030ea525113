class_name SoftwareDrawing
extends RefCounted
## The one switch for what is drawn in another way where no graphics card helps: the processor then
## fills every pixel, and a lab that draws its whole window 60 times a second would not keep up.
##
## [StillPicture] and [StillCanvas] draw what does not move once, into a picture.
## [method fill_window] spares the engine work on a window that is filled anyway. On a graphics card
## all of this is off. docs/performance.md says what each of them saves.

## Names of renderers that draw with the processor, as the engine reports them.
const _RENDERERS: PackedStringArray = ["llvmpipe", "softpipe", "SwiftShader", "Basic Render"]

## Whether it is on. Set it before a scene is opened, to compare.
static var is_on := _is_software(RenderingServer.get_video_adapter_name())


## Tells the engine that the scene in [param window] fills the window in every frame. It need not
## clear it then. And because the window may be transparent, it keeps 8 instead of 10 bits a color,
## which are mixed in two thirds of the time.
static func fill_window(window: Window, fills: bool) -> void:
	if not is_on:
		return
	var server := RenderingServer
	var mode := server.VIEWPORT_CLEAR_NEVER if fills else server.VIEWPORT_CLEAR_ALWAYS
	server.viewport_set_clear_mode(window.get_viewport_rid(), mode)
	window.transparent_bg = fills


static func _is_software(renderer: String) -> bool:
	for known in _RENDERERS:
		if renderer.contains(known):
			return true
	return false
