@tool
class_name ShotTimeline
extends Control
## The seconds in which to fire: a ring for the student's moment, which can be dragged or moved with
## the arrow keys, the firing window in color, the right moment, and the moment that is shown now.

## The student wants to fire at this moment, in seconds.
signal moment_wanted(seconds: float)
## A drag or a key has ended.
signal released

# Seconds that an arrow key moves by, and to which a drag snaps.
const _NUDGE := 0.1
const _SNAP := 0.05
const _MARGIN := 18.0
const _FONT_SIZE := 15
const _RING := 9.0
const _WINDOW_HEIGHT := 16.0
# The narrowest window that is seen, in pixels.
const _NARROWEST := 3.0
# Two numbers of the axis are not nearer than this, in pixels.
const _NUMBER_ROOM := 34.0
const _STEPS: Array[float] = [0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0]

## What the ring means: source text.
@export var title := "Your moment to fire"
## The heading where there is no ring: source text.
@export var title_without_ring := "The moment to fire"

var _span := 5.0
var _own := 0.0
var _now := 0.0
# Right and wrong moments; NAN where they are not shown.
var _right := NAN
var _wrong := NAN
# First and last moment of the window; empty where it is not shown.
var _window: PackedFloat64Array = []
var _is_dragged := false


func _ready() -> void:
	resized.connect(queue_redraw)
	focus_entered.connect(queue_redraw)
	focus_exited.connect(queue_redraw)
	# The editor would save it.
	if not Engine.is_editor_hint():
		accessibility_name = tr(title)
		tooltip_text = tr(title)


## Shows the moments from 0 to [param span] seconds with the student's, [param own]. A moment that
## is NAN is not shown, nor an empty [param window]; without a ring nothing can be dragged.
func show_moments(
	span: float, own: float, right: float, wrong: float, window: PackedFloat64Array
) -> void:
	_span = span
	_own = own
	_right = right
	_wrong = wrong
	_window = window
	focus_mode = FOCUS_NONE if is_nan(own) else FOCUS_ALL
	queue_redraw()


## Moves the mark of the moment that is shown now.
func show_now(seconds: float) -> void:
	_now = seconds
	queue_redraw()


## Where a moment is, in pixels.
func pixel_of(seconds: float) -> float:
	return lerpf(_MARGIN, size.x - _MARGIN, clampf(seconds / _span, 0.0, 1.0))


func _draw() -> void:
	draw_style_box(get_theme_stylebox(&"panel", &"PanelCard"), Rect2(Vector2.ZERO, size))
	var line := size.y * 0.52
	var quiet := Palette.color(Palette.Role.QUIET)
	var heading := Vector2(_MARGIN, 18.0)
	var font := get_theme_default_font()
	var words := tr(title_without_ring if is_nan(_own) else title)
	draw_string(font, heading, words, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE, quiet)
	_draw_window(line)
	var axis := Palette.drawn(Palette.AXIS)
	draw_line(Vector2(_MARGIN, line), Vector2(size.x - _MARGIN, line), axis, 2.0)
	_draw_seconds(line)
	_draw_now(line)
	_draw_mark(_right, line, Palette.Role.PROJECTION)
	_draw_cross(_wrong, line)
	_draw_ring(line)
	if has_focus():
		draw_rect(Rect2(Vector2.ZERO, size), Palette.drawn(Palette.FOCUS), false, 3.0)


func _draw_window(line: float) -> void:
	if _window.is_empty():
		return
	var left := pixel_of(_window[0])
	var width := maxf(pixel_of(_window[1]) - left, _NARROWEST)
	var place := Rect2(left, line - 0.5 * _WINDOW_HEIGHT, width, _WINDOW_HEIGHT)
	draw_rect(place, Color(Palette.color(Palette.Role.RIGHT), 0.45))
	draw_rect(place, Palette.color(Palette.Role.RIGHT), false, 1.5)


func _draw_seconds(line: float) -> void:
	var step := _STEPS[-1]
	for wanted: float in _STEPS:
		if (size.x - 2.0 * _MARGIN) * wanted / _span >= _NUMBER_ROOM:
			step = wanted
			break
	var font := get_theme_default_font()
	var color := Palette.color(Palette.Role.QUIET)
	for number: int in int(_span / step) + 1:
		var x := pixel_of(number * step)
		var axis := Palette.drawn(Palette.AXIS)
		draw_line(Vector2(x, line - 5.0), Vector2(x, line + 5.0), axis, 1.5)
		var text := NumberText.short(number * step) + (" s" if number == 0 else "")
		var width := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE).x
		var at := Vector2(clampf(x - 0.5 * width, 4.0, size.x - width - 4.0), size.y - 7.0)
		draw_string(font, at, text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE, color)


func _draw_now(line: float) -> void:
	var x := pixel_of(_now)
	var color := Palette.color(Palette.Role.INK)
	draw_line(Vector2(x, line - 14.0), Vector2(x, line + 14.0), color, Palette.stroke(2.0))


func _draw_mark(seconds: float, line: float, role: Palette.Role) -> void:
	if is_nan(seconds):
		return
	var tip := Vector2(pixel_of(seconds), line)
	var corners: PackedVector2Array = [tip, tip + Vector2(-8.0, -15.0), tip + Vector2(8.0, -15.0)]
	draw_colored_polygon(corners, Palette.color(role))


func _draw_cross(seconds: float, line: float) -> void:
	if is_nan(seconds):
		return
	var middle := Vector2(pixel_of(seconds), line)
	var color := Palette.color(Palette.Role.WRONG)
	for arm: Vector2 in [Vector2(7.0, 7.0), Vector2(7.0, -7.0)]:
		draw_line(middle - arm, middle + arm, color, Palette.stroke(3.0), true)


func _draw_ring(line: float) -> void:
	if is_nan(_own):
		return
	var middle := Vector2(pixel_of(_own), line)
	var dot := DotTexture.of(Palette.drawn(Palette.PAPER), Palette.color(Palette.Role.A), _RING)
	draw_texture(dot, middle - dot.get_size() / 2.0)


func _gui_input(event: InputEvent) -> void:
	if is_nan(_own):
		return
	var click := event as InputEventMouseButton
	var motion := event as InputEventMouseMotion
	if click and click.button_index == MOUSE_BUTTON_LEFT:
		end_drag()
		if click.pressed:
			_is_dragged = true
			_want_pixel(click.position.x)
		accept_event()
	elif motion and _is_dragged:
		# The button may have been released where nobody saw it, as outside of the window.
		if motion.button_mask & MOUSE_BUTTON_MASK_LEFT:
			_want_pixel(motion.position.x)
		else:
			end_drag()
		accept_event()
	elif event.is_action_pressed(&"ui_left", true):
		_nudge(-_NUDGE)
	elif event.is_action_pressed(&"ui_right", true):
		_nudge(_NUDGE)


## Ends a drag of the ring; does nothing where there is none.
func end_drag() -> void:
	if _is_dragged:
		_is_dragged = false
		released.emit()


func _want_pixel(pixel: float) -> void:
	var share := clampf((pixel - _MARGIN) / (size.x - 2.0 * _MARGIN), 0.0, 1.0)
	moment_wanted.emit(snappedf(share * _span, _SNAP))


func _nudge(seconds: float) -> void:
	moment_wanted.emit(clampf(snappedf(_own + seconds, 0.01), 0.0, _span))
	released.emit()
	accept_event()
