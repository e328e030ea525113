class_name TimelineBar
extends Control
## The seconds of a timeline, with its impacts as diamonds and a mark at the present moment, which
## can be dragged or moved with the arrow keys.

## The student wants to go to this moment, in seconds since the start of the timeline.
signal moment_wanted(seconds: float)

# Seconds that an arrow key moves by.
const _NUDGE := 0.1
const _MARGIN := 14.0
const _FONT_SIZE := 14
# The middle of the legend, and of the line of time as a share of what is below it, in pixels.
const _LEGEND := 10.0
const _LINE := 0.36

var _now := 0.0
var _is_dragged := false
var _from := 0.0
var _impacts: PackedFloat64Array = []
var _rests: PackedFloat64Array = []


func _ready() -> void:
	focus_entered.connect(queue_redraw)
	focus_exited.connect(queue_redraw)
	resized.connect(queue_redraw)


## Shows [param timeline] with the impacts of the ball at the place [param index].
func show_timeline(timeline: EventTimeline, index: int) -> void:
	_now = timeline.time
	_from = timeline.page_start()
	_impacts.clear()
	_rests.clear()
	for event in timeline.impacts(index, _from + EventTimeline.SPAN):
		if event.kind == WorldEvent.Kind.SEGMENT:
			_impacts.append(event.time)
		elif event.kind == WorldEvent.Kind.REST:
			_rests.append(event.time)
	queue_redraw()


## Where a moment is, in pixels of the bar.
func pixel_of(seconds: float) -> float:
	var share := (seconds - _from) / EventTimeline.SPAN
	return lerpf(_MARGIN, size.x - _MARGIN, share)


func _draw() -> void:
	var line := 2.0 * _LEGEND + (size.y - 2.0 * _LEGEND) * _LINE
	var at := _draw_legend(_MARGIN, Palette.Role.PROJECTION, tr("bounce of the ball"))
	_draw_legend(at, Palette.Role.UNIT, tr("comes to rest"))
	draw_line(
		Vector2(_MARGIN, line), Vector2(size.x - _MARGIN, line), Palette.drawn(Palette.AXIS), 2.0
	)
	_draw_seconds(line)
	for seconds in _impacts:
		_draw_impact(seconds, line, Palette.Role.PROJECTION)
	for seconds in _rests:
		_draw_impact(seconds, line, Palette.Role.UNIT)
	_draw_now(line)
	if has_focus():
		draw_rect(Rect2(Vector2.ZERO, size), Palette.drawn(Palette.FOCUS), false, 3.0)


func _draw_seconds(line: float) -> void:
	var font := ThemeDB.fallback_font
	var color := Palette.color(Palette.Role.QUIET)
	for i in int(EventTimeline.SPAN) + 1:
		var x := pixel_of(_from + i)
		draw_line(Vector2(x, line - 5.0), Vector2(x, line + 5.0), Palette.drawn(Palette.AXIS), 1.5)
		var text := "%d" % (_from + i) + (" s" if i == int(EventTimeline.SPAN) else "")
		var width := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE).x
		var at := Vector2(minf(x - width / 2.0, size.x - width), size.y - 4.0)
		draw_string(font, at, text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE, color)


# Draws a mark with its meaning at the top, and returns where the next one begins.
func _draw_legend(left: float, role: Palette.Role, text: String) -> float:
	var font := ThemeDB.fallback_font
	_draw_diamond(Vector2(left, _LEGEND), role)
	var at := Vector2(left + 12.0, _LEGEND + _FONT_SIZE * 0.36)
	var color := Palette.color(Palette.Role.QUIET)
	draw_string(font, at, text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE, color)
	return at.x + font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE).x + 24.0


func _draw_impact(seconds: float, line: float, role: Palette.Role) -> void:
	var middle := Vector2(pixel_of(seconds), line)
	if middle.x >= _MARGIN - 1.0 and middle.x <= size.x - _MARGIN + 1.0:
		_draw_diamond(middle, role)


func _draw_diamond(middle: Vector2, role: Palette.Role) -> void:
	var corners: PackedVector2Array = []
	for direction: Vector2 in [Vector2.UP, Vector2.RIGHT, Vector2.DOWN, Vector2.LEFT]:
		corners.append(middle + direction * Vector2(5.5, 9.0))
	draw_colored_polygon(corners, Palette.color(role))


func _draw_now(line: float) -> void:
	var at := Vector2(pixel_of(_now), line)
	var color := Palette.color(Palette.Role.A)
	draw_line(Vector2(at.x, 2.0 * _LEGEND), Vector2(at.x, size.y - 18.0), color, 3.0)
	var dot := DotTexture.of(Palette.drawn(Palette.PAPER), color, 7.0)
	draw_texture(dot, at - dot.get_size() / 2.0)


func _gui_input(event: InputEvent) -> void:
	var click := event as InputEventMouseButton
	var motion := event as InputEventMouseMotion
	if click and click.button_index == MOUSE_BUTTON_LEFT:
		_is_dragged = click.pressed
		if click.pressed:
			_want_pixel(click.position.x)
		accept_event()
	elif motion and _is_dragged:
		# The button may have been released where nobody saw it, as outside of the window.
		_is_dragged = motion.button_mask & MOUSE_BUTTON_MASK_LEFT != 0
		if _is_dragged:
			_want_pixel(motion.position.x)
		accept_event()
	elif event.is_action_pressed(&"ui_left", true):
		_want(_now - _NUDGE)
	elif event.is_action_pressed(&"ui_right", true):
		_want(_now + _NUDGE)
	elif event.is_action_pressed(&"ui_home"):
		_want(_from)


## Ends a drag of the mark; does nothing where there is none.
func end_drag() -> void:
	_is_dragged = false


# A drag stays within the seconds that are shown. Playing on or the arrow keys turn the page.
func _want_pixel(pixel: float) -> void:
	var share := clampf((pixel - _MARGIN) / (size.x - 2.0 * _MARGIN), 0.0, 0.9999)
	moment_wanted.emit(_from + share * EventTimeline.SPAN)


func _want(seconds: float) -> void:
	accept_event()
	moment_wanted.emit(maxf(seconds, 0.0))
