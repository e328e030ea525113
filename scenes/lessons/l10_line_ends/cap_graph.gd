@tool
class_name CapGraph
extends Control
## The distance of the ball's centre from the end of the line against the fraction of the frame.
## Where it is the radius, the quadratic has its roots.

const _MARGIN_LEFT := 16.0
const _MARGIN_RIGHT := 44.0
const _MARGIN_TOP := 30.0
const _MARGIN_BOTTOM := 26.0
const _SAMPLES := 120
const _FONT_SIZE := 15

## Whether the roots are marked, or that there are none; seen from [method show_equation] on.
var shows_roots := true

var _equation: CapEquation
var _fraction := 0.0
var _end_name := "A"


func _ready() -> void:
	resized.connect(queue_redraw)


## Draws the distance for [param equation] of the end called [param end_name]. A ring marks the
## distance after [param fraction] of the frame.
func show_equation(equation: CapEquation, end_name: String, fraction: float) -> void:
	_equation = equation
	_end_name = end_name
	_fraction = fraction
	# The editor would save it.
	if not Engine.is_editor_hint():
		accessibility_name = _title()
	queue_redraw()


func _draw() -> void:
	draw_style_box(get_theme_stylebox(&"panel", &"PanelCard"), Rect2(Vector2.ZERO, size))
	_write(_title(), Vector2(_MARGIN_LEFT, 20.0), Palette.Role.QUIET)
	if _equation:
		_draw_axis()
		_draw_curve()
		_draw_radius()
		if shows_roots:
			_draw_roots()
		_draw_live_point()


func _title() -> String:
	return tr("Distance from %s") % _end_name


# From the start to the end of the frame, and further where a root lies outside it.
func _span() -> Vector2:
	var span := Vector2(0.0, 1.0)
	if _equation.has_roots():
		span.x = clampf(_equation.first_root(), -1.0, 0.0)
		span.y = clampf(_equation.second_root() * 1.05, 1.0, 3.0)
	return span


func _largest_distance() -> float:
	var span := _span()
	var ends := maxf(_equation.distance_at(span.x), _equation.distance_at(span.y))
	return maxf(ends, _equation.radius) * 1.05


func _draw_axis() -> void:
	var span := _span()
	draw_line(_pixel(span.x, 0.0), _pixel(span.y, 0.0), Palette.drawn(Palette.AXIS), 1.5)
	for fraction: float in [0.0, 1.0]:
		draw_line(
			_pixel(fraction, 0.0),
			_pixel(fraction, _largest_distance()),
			Palette.drawn(Palette.GRID),
			1.0
		)
		var text := "t = %s" % NumberText.short(fraction)
		var left := clampf(_pixel(fraction, 0.0).x - 18.0, 4.0, size.x - 48.0)
		_write(text, Vector2(left, size.y - 8.0), Palette.Role.QUIET)


func _draw_curve() -> void:
	var span := _span()
	var points: PackedVector2Array = []
	for i in _SAMPLES + 1:
		var fraction := lerpf(span.x, span.y, float(i) / _SAMPLES)
		points.append(_pixel(fraction, _equation.distance_at(fraction)))
	draw_polyline(points, Palette.color(Palette.Role.INK), 2.5, true)


func _draw_radius() -> void:
	var span := _span()
	var end := _pixel(span.y, _equation.radius)
	var color := Palette.color(Palette.Role.UNIT)
	draw_dashed_line(_pixel(span.x, _equation.radius), end, color, 2.0, 6.0)
	_write("r", end + Vector2(10.0, 6.0), Palette.Role.UNIT)


func _draw_roots() -> void:
	if not _equation.has_roots():
		var middle := _pixel(_span().x, 0.0) + Vector2(12.0, -8.0)
		_write(tr("D < 0: never as close as r"), middle, Palette.Role.QUIET)
		return
	_draw_root(_equation.first_root(), "t₁", Palette.Role.PROJECTION)
	_draw_root(_equation.second_root(), "t₂", Palette.Role.REST)


func _draw_root(fraction: float, text: String, role: Palette.Role) -> void:
	var span := _span()
	if fraction < span.x or fraction > span.y:
		return
	var at := _pixel(fraction, _equation.radius)
	draw_dashed_line(_pixel(fraction, 0.0), at, Palette.color(role), 2.0, 4.0)
	draw_circle(at, 6.0, Palette.color(role), true, -1.0, true)
	_write(text, at + Vector2(-6.0, -12.0), role)


func _draw_live_point() -> void:
	var at := _pixel(_fraction, _equation.distance_at(_fraction))
	draw_circle(at, 7.0, Palette.drawn(Palette.PAPER), true, -1.0, true)
	draw_circle(at, 7.0, Palette.color(Palette.Role.INK), false, 2.5, true)


func _pixel(fraction: float, distance: float) -> Vector2:
	var span := _span()
	var width := size.x - _MARGIN_LEFT - _MARGIN_RIGHT
	var height := size.y - _MARGIN_TOP - _MARGIN_BOTTOM
	var share := (fraction - span.x) / (span.y - span.x)
	var up := distance / _largest_distance()
	return Vector2(_MARGIN_LEFT + share * width, _MARGIN_TOP + (1.0 - up) * height)


func _write(text: String, at: Vector2, role: Palette.Role) -> void:
	var font := get_theme_default_font()
	var color := Palette.color(role)
	draw_string(font, at, text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE, color)
