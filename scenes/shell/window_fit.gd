class_name WindowFit
extends RefCounted
## Fits the lab's drawing size to the window: a pixel of the drawing is never smaller than a pixel
## of the window, and grows on large windows and with the text size that the student has chosen.
##
## The engine scales everything drawn (`canvas_items`, `expand`); this chooses the size that it
## scales from. On a dense screen, and in a browser there, a pixel of the window stands for several
## of the screen: those of CSS are meant.

## The size of a wide window in which nothing is scaled, and its sides exchanged for a tall one.
const USUAL := Vector2i(1280, 720)
## A wide window that is less wide for its height is not scaled beyond this width.
const NARROWEST_WIDE := 960
## The text sizes to choose from: how many times as large as usual everything is drawn.
const TEXT_SIZES: Array[float] = [1.0, 1.25, 1.5]

const _KEY := "text_size"


## Keeps the drawing size of [param window] right from now on.
static func follow(window: Window) -> void:
	var fit_window := fit.bind(window)
	if not window.size_changed.is_connected(fit_window):
		window.size_changed.connect(fit_window)
	fit(window)


## Makes the drawing size of [param window] right, after the text size has changed.
static func fit(window: Window) -> void:
	var density := DisplayServer.screen_get_scale(window.current_screen)
	window.content_scale_size = drawing_size(window.size, density, text_size())


## How many times as large as usual text is drawn.
static func text_size() -> float:
	var chosen: float = KeptChoices.value(_KEY, TEXT_SIZES[0])
	return chosen if chosen in TEXT_SIZES else TEXT_SIZES[0]


## The student has chosen the next larger text size, for [param by] = 1, or the next smaller one,
## for
## -1; it is kept for the next time.
static func enlarge_text(by: int) -> void:
	var place := clampi(TEXT_SIZES.find(text_size()) + by, 0, TEXT_SIZES.size() - 1)
	KeptChoices.keep(_KEY, TEXT_SIZES[place])


## The drawing size for a window of [param window_size] pixels of a screen with [param density] of
## them for each pixel of the window, and text [param text] times as large as usual.
static func drawing_size(window_size: Vector2i, density: float, text: float) -> Vector2i:
	var room := Vector2(window_size) / maxf(density, 0.1)
	var scale := minf(room.x / USUAL.y, room.y / USUAL.x)
	if room.x >= room.y:
		scale = minf(room.x / NARROWEST_WIDE, room.y / USUAL.y)
	# Rounded down: the scale is then never too small.
	return Vector2i((room / (maxf(scale, 1.0) * text)).floor()).max(Vector2i.ONE)
