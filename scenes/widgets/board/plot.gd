@tool
class_name Plot
extends Control
## A small graph of one function with the point where the lesson is now.

## The student pointed at the graph at this x.
signal x_pointed(x: float)
## The click or drag that [signal x_pointed] told of has ended.
signal released

const _MARGIN_LEFT := 56.0
const _MARGIN_RIGHT := 14.0
# Where numbers stand to the right of the graph.
const _WIDE_MARGIN_RIGHT := 36.0
const _MARGIN_TOP := 36.0
const _MARGIN_BOTTOM := 32.0
const _SAMPLES := 120
const _FONT_SIZE := 15
# A value of at most this share of the y axis is what rounding leaves of 0.
const _ROUNDING := 1.0 / 2.0 ** 50

## What is drawn, as a heading: source text.
@export var title := ""
## Unit behind the numbers of the x axis, such as ` %`.
@export var x_unit := ""
## x is an angle in degrees, shown in the unit and the range that are chosen.
@export var x_is_angle := false
## Ends of the x axis.
@export var x_from := -180.0
@export var x_to := 180.0
## Distance between two numbers on the x axis.
@export var x_step := 90.0
## The upper end of a second scale, on the right, for the same curve; 0 for none.
@export var right_reach := 0.0
## Colour of the curve.
@export var role := Palette.Role.INK

var _function := Callable()
var _y_reach := 1.0
var _x := 0.0
var _is_dragged := false


func _ready() -> void:
	resized.connect(queue_redraw)
	# The editor would save it.
	if not Engine.is_editor_hint():
		accessibility_name = tr(title)


## Draws [param function], from x to y, with the y axis from -[param y_reach] to y_reach, and the
## live point at [param x].
func show_function(function: Callable, y_reach: float, x: float) -> void:
	_function = function
	_y_reach = maxf(y_reach, 1e-300)
	_x = Conventions.in_range(x) if x_is_angle else x
	queue_redraw()


func _draw() -> void:
	draw_style_box(get_theme_stylebox(&"panel", &"PanelCard"), Rect2(Vector2.ZERO, size))
	_draw_axes()
	if _function.is_valid():
		_draw_values()
		_draw_curve()
		_draw_point()


func _draw_axes() -> void:
	var quiet := Palette.color(Palette.Role.QUIET)
	_write(tr(title), Vector2(_MARGIN_RIGHT, 20.0), quiet)
	var x := _first_x()
	var last := x + x_to - x_from
	draw_line(_pixel(x, 0.0), _pixel(last, 0.0), Palette.drawn(Palette.AXIS), 1.5)
	while x <= last:
		draw_line(_pixel(x, _y_reach), _pixel(x, -_y_reach), Palette.drawn(Palette.GRID), 1.0)
		var text := Conventions.mark_text(x, 3) if x_is_angle else NumberText.short(x) + x_unit
		var width := _width(text)
		var left := clampf(_pixel(x, 0.0).x - width / 2.0, 4.0, size.x - width - 4.0)
		_write(text, Vector2(left, size.y - 8.0), quiet)
		x += x_step


# The left end of the x axis, as it is shown.
func _first_x() -> float:
	return 0.0 if x_is_angle and Conventions.has_full_turn() else x_from


# The ends of both y axes, and the value at the point.
func _draw_values() -> void:
	var quiet := Palette.color(Palette.Role.QUIET)
	for y: float in [_y_reach, -_y_reach]:
		var text := NumberText.short(y, 3)
		_write(text, Vector2(_MARGIN_LEFT - 6.0 - _width(text), _pixel(0.0, y).y + 5.0), quiet)
	if right_reach > 0.0:
		for share: float in [1.0, 0.0, -1.0]:
			var at := Vector2(size.x - _margin_right() + 6.0, _pixel(0.0, share * _y_reach).y + 5.0)
			_write(NumberText.short(share * right_reach), at, quiet)
	var value := NumberText.short(_shown_value())
	if right_reach > 0.0:
		value += ", " + NumberText.short(_shown_value() / _y_reach * right_reach)
	_write(value, Vector2(size.x - _MARGIN_RIGHT - _width(value), 20.0), Palette.color(role))


# What is left by rounding is 0.
func _shown_value() -> float:
	var value := _value_at(_x)
	return value if absf(value) > _ROUNDING * _y_reach else 0.0


func _draw_curve() -> void:
	var points: PackedVector2Array = []
	for i in _SAMPLES + 1:
		var x := _first_x() + (x_to - x_from) * i / _SAMPLES
		points.append(_pixel(x, _value_at(x)))
	draw_polyline(points, Palette.color(role), Palette.stroke(2.5), true)


func _draw_point() -> void:
	var at := _pixel(_x, _value_at(_x))
	if not at.is_finite():
		return
	var color := Palette.color(role)
	draw_dashed_line(_pixel(_x, 0.0), at, color, 2.0, 5.0)
	draw_circle(at, 7.0, Palette.drawn(Palette.PAPER), true, -1.0, true)
	draw_circle(at, 6.0, color, true, -1.0, true)


func _gui_input(event: InputEvent) -> void:
	var click := event as InputEventMouseButton
	var motion := event as InputEventMouseMotion
	if click and click.button_index == MOUSE_BUTTON_LEFT:
		end_drag()
		if click.pressed:
			_is_dragged = true
			x_pointed.emit(_x_at(click.position.x))
		accept_event()
	elif motion and _is_dragged:
		# The button may have been released where nobody saw it, as outside of the window.
		if motion.button_mask & MOUSE_BUTTON_MASK_LEFT:
			x_pointed.emit(_x_at(motion.position.x))
		else:
			end_drag()
		accept_event()


## Ends a click or drag on the graph; does nothing where there is none.
func end_drag() -> void:
	if _is_dragged:
		_is_dragged = false
		released.emit()


func _value_at(x: float) -> float:
	var value: float = _function.call(x)
	return value


func _pixel(x: float, y: float) -> Vector2:
	var width := size.x - _MARGIN_LEFT - _margin_right()
	var height := size.y - _MARGIN_TOP - _MARGIN_BOTTOM
	var right := (x - _first_x()) / (x_to - x_from) * width
	return Vector2(_MARGIN_LEFT + right, _MARGIN_TOP + (0.5 - 0.5 * y / _y_reach) * height)


func _x_at(pixel: float) -> float:
	var share := (pixel - _MARGIN_LEFT) / (size.x - _MARGIN_LEFT - _margin_right())
	return _first_x() + (x_to - x_from) * clampf(share, 0.0, 1.0)


func _margin_right() -> float:
	return _WIDE_MARGIN_RIGHT if right_reach > 0.0 else _MARGIN_RIGHT


func _write(text: String, at: Vector2, color: Color) -> void:
	draw_string(_font(), at, text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE, color)


func _width(text: String) -> float:
	return _font().get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE).x


func _font() -> Font:
	return get_theme_default_font()
