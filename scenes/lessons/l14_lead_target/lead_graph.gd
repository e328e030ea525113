@tool
class_name LeadGraph
extends Control
## The distance |P + V t| of the target against the reach R + s t of the bullet, over time. They
## meet at the hits; left of 0 the distance meets the mirrored reach, where squaring makes a root
## that is no hit.

## The student pointed at this moment, in seconds from 0 on.
signal moment_pointed(seconds: float)

const _MARGIN_LEFT := 14.0
const _MARGIN_RIGHT := 14.0
const _MARGIN_TOP := 32.0
const _MARGIN_BOTTOM := 26.0
const _SAMPLES := 80
const _FONT_SIZE := 15
# A second root is shown where it is at most so many times as late as the first, either way.
const _FARTHEST := 6.0

var _equation: LeadEquation
var _hit := NAN
var _time := 0.0
var _is_dragged := false
# Where the time axis begins and ends, and the largest distance that is shown.
var _first := 0.0
var _last := 1.0
var _largest := 1.0


func _ready() -> void:
	resized.connect(queue_redraw)
	# The editor would save it.
	if not Engine.is_editor_hint():
		accessibility_name = tr("Distance and reach against the time t")


## Draws [param equation] with its roots; the first hit is after [param hit] seconds, NAN where
## there is none.
func show_equation(equation: LeadEquation, hit: float) -> void:
	_equation = equation
	_hit = hit
	_choose_span()
	queue_redraw()


## Marks where both are after [param seconds].
func show_moment(seconds: float) -> void:
	_time = seconds
	queue_redraw()


# From 0, or from a root below it, to behind the last hit.
func _choose_span() -> void:
	var usual := (_equation.way.length() + _equation.radius) / _equation.speed
	var first_hit := _hit if _hit > 0.0 else maxf(usual, 1e-9)
	var other := _equation.other_root()
	_first = 0.0
	_last = 1.35 * first_hit
	if _is_near(other, first_hit):
		_first = minf(0.0, 1.15 * other)
		_last = maxf(_last, 1.15 * other)
	_largest = 1e-300
	for seconds: float in [_first, 0.0, _last]:
		_largest = maxf(_largest, _equation.way_after(seconds).length())
		_largest = maxf(_largest, absf(_equation.reach_after(seconds)))
	_largest *= 1.06


func _is_near(other: float, first_hit: float) -> bool:
	return absf(other) <= _FARTHEST * first_hit and absf(other) > 0.0


func _draw() -> void:
	draw_style_box(get_theme_stylebox(&"panel", &"PanelCard"), Rect2(Vector2.ZERO, size))
	if not _equation:
		return
	_draw_axes()
	_draw_curve(_distance_pixel, Palette.Role.B, _first)
	_draw_curve(_reach_pixel, Palette.Role.PROJECTION, maxf(_first, _reach_begins()))
	_draw_mirrored_reach()
	_draw_legend()
	_draw_roots()
	_draw_moment()


func _draw_axes() -> void:
	var axis := Palette.drawn(Palette.AXIS)
	draw_line(_pixel(_first, 0.0), _pixel(_last, 0.0), axis, 1.5)
	draw_line(_pixel(0.0, 0.0), _pixel(0.0, _largest), axis, 1.5)
	_write("0", _pixel(0.0, 0.0) + Vector2(-4.0, 18.0), Palette.Role.QUIET)
	_write("t", Vector2(size.x - 12.0, size.y - 8.0), Palette.Role.QUIET)


func _draw_curve(pixel_after: Callable, role: Palette.Role, from: float) -> void:
	var points: PackedVector2Array = []
	for i in _SAMPLES + 1:
		var pixel: Vector2 = pixel_after.call(lerpf(from, _last, float(i) / _SAMPLES))
		points.append(pixel)
	draw_polyline(points, Palette.color(role), Palette.stroke(2.5), true)


# Where R + s t is 0.
func _reach_begins() -> float:
	return -_equation.radius / _equation.speed


func _draw_mirrored_reach() -> void:
	var begin := _reach_begins()
	if begin <= _first:
		return
	var start := _pixel(_first, absf(_equation.reach_after(_first)))
	var color := Color(Palette.color(Palette.Role.PROJECTION), 0.7)
	draw_dashed_line(start, _pixel(begin, 0.0), color, Palette.stroke(2.0), 5.0)


func _draw_legend() -> void:
	var distance := "|P + V t|"
	_write(distance, Vector2(_MARGIN_LEFT, 20.0), Palette.Role.B)
	var width := _font().get_string_size(distance, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE).x
	var behind := Vector2(_MARGIN_LEFT + width + 18.0, 20.0)
	_write("R + s t", behind, Palette.Role.PROJECTION)


func _draw_roots() -> void:
	_draw_root(_hit, "t₁", Palette.Role.PROJECTION)
	var other := _equation.other_root()
	if not is_nan(_hit) or other < 0.0:
		_draw_root(other, "t₂", Palette.Role.QUIET)


func _draw_root(seconds: float, text: String, role: Palette.Role) -> void:
	if not (seconds >= _first and seconds <= _last):
		return
	var at := _distance_pixel(seconds)
	var foot := _pixel(seconds, 0.0)
	draw_dashed_line(foot, at, Palette.color(role), 2.0, 4.0)
	draw_circle(at, 5.0, Palette.color(role), true, -1.0, true)
	var left := clampf(foot.x - 7.0, 4.0, size.x - 20.0)
	if absf(foot.x - _pixel(0.0, 0.0).x) > 16.0:
		_write(text, Vector2(left, size.y - 8.0), role)


func _draw_moment() -> void:
	if _time <= 0.0 or _time > _last:
		return
	var places: Array[Vector2] = [_distance_pixel(_time), _reach_pixel(_time)]
	var roles: Array[Palette.Role] = [Palette.Role.B, Palette.Role.PROJECTION]
	for i in places.size():
		draw_circle(places[i], 6.0, Palette.drawn(Palette.PAPER), true, -1.0, true)
		draw_circle(places[i], 6.0, Palette.color(roles[i]), false, 2.5, true)


func _gui_input(event: InputEvent) -> void:
	var click := event as InputEventMouseButton
	var motion := event as InputEventMouseMotion
	if click and click.button_index == MOUSE_BUTTON_LEFT:
		_is_dragged = click.pressed
		if click.pressed:
			moment_pointed.emit(_seconds_at(click.position.x))
		accept_event()
	elif motion and _is_dragged:
		# The button may have been released where nobody saw it, as outside of the window.
		if motion.button_mask & MOUSE_BUTTON_MASK_LEFT:
			moment_pointed.emit(_seconds_at(motion.position.x))
		else:
			end_drag()
		accept_event()


## Ends a click or drag on the graph; does nothing where there is none.
func end_drag() -> void:
	_is_dragged = false


func _seconds_at(pixel: float) -> float:
	var share := (pixel - _MARGIN_LEFT) / (size.x - _MARGIN_LEFT - _MARGIN_RIGHT)
	return maxf(0.0, lerpf(_first, _last, clampf(share, 0.0, 1.0)))


func _distance_pixel(seconds: float) -> Vector2:
	return _pixel(seconds, _equation.way_after(seconds).length())


func _reach_pixel(seconds: float) -> Vector2:
	return _pixel(seconds, _equation.reach_after(seconds))


func _pixel(seconds: float, distance: float) -> Vector2:
	var width := size.x - _MARGIN_LEFT - _MARGIN_RIGHT
	var height := size.y - _MARGIN_TOP - _MARGIN_BOTTOM
	var share := (seconds - _first) / (_last - _first)
	var up := 1.0 - distance / _largest
	return Vector2(_MARGIN_LEFT + share * width, _MARGIN_TOP + up * height)


func _write(text: String, at: Vector2, role: Palette.Role) -> void:
	var color := Palette.color(role)
	draw_string(_font(), at, text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE, color)


func _font() -> Font:
	return get_theme_default_font()
