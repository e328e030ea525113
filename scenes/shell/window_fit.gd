class_name WindowFit
extends RefCounted
## Fits the lab's drawing size to the window, so that text keeps its size on tall and small windows
## too.
##
## The engine scales everything drawn (`canvas_items`, `expand`); this chooses the size that it
## scales from.

## Heights and widths that the layouts are made for, in pixels of the drawing.
const SHORT_SIDE := 720
const LONG_SIDE := 1280
## A wide window shows at least this width.
const NARROWEST_WIDE := 960


## Keeps the drawing size of [param window] right from now on.
static func follow(window: Window) -> void:
	var fit := _fit.bind(window)
	if not window.size_changed.is_connected(fit):
		window.size_changed.connect(fit)
	fit.call()


## The drawing size for a window of [param window_size] pixels: tall windows get the tall one.
static func drawing_size(window_size: Vector2i) -> Vector2i:
	if window_size.x < window_size.y:
		return Vector2i(SHORT_SIDE, LONG_SIDE)
	var width := roundi(SHORT_SIDE * float(window_size.x) / window_size.y)
	return Vector2i(clampi(width, NARROWEST_WIDE, LONG_SIDE), SHORT_SIDE)


static func _fit(window: Window) -> void:
	window.content_scale_size = drawing_size(window.size)
