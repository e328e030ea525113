class_name LogPlotArea
extends RefCounted
## The field of a plot with two logarithmic axes: where a point lies in it, and its grid with
## numbers. Zero has a strip of its own at the foot, and what has no answer one at the top.

const _FONT_SIZE := 15
# Height of the strips for zero and for no answer.
const _STRIP := 34.0
# Room between two numbers of the axes, at least.
const _BETWEEN_X := 84.0
const _BETWEEN_Y := 30.0

## The field without its numbers, in pixels of the plot.
var field := Rect2()

var _x := LogScale.new()
var _y := LogScale.new()


## Chooses both axes so that all [param points] are inside.
func fit(points: Array[PlotPoint]) -> void:
	var across: PackedFloat64Array = []
	var up: PackedFloat64Array = []
	for point in points:
		across.append(point.x)
		up.append(point.y)
	_x = LogScale.around(across)
	_y = LogScale.around(up)


## Where [param point] lies, in pixels of the plot.
func pixel(point: PlotPoint) -> Vector2:
	return Vector2(_x_pixel(point.x), _y_pixel(point.y))


## Draws the grid and its numbers.
func draw(canvas: Control) -> void:
	var scaled := _scaled_field()
	for exponent in _x.ticks(floori(scaled.size.x / _BETWEEN_X)):
		var x := _x_pixel(10.0 ** exponent)
		_draw_line(
			canvas,
			Vector2(x, field.position.y),
			Vector2(x, field.end.y),
			Palette.drawn(Palette.GRID)
		)
		_write(canvas, NumberText.short(10.0 ** exponent), Vector2(x, field.end.y + 14.0), 0.5)
	for exponent in _y.ticks(floori(scaled.size.y / _BETWEEN_Y)):
		var y := _y_pixel(10.0 ** exponent)
		_draw_line(
			canvas,
			Vector2(field.position.x, y),
			Vector2(field.end.x, y),
			Palette.drawn(Palette.GRID)
		)
		_write(canvas, NumberText.short(10.0 ** exponent), Vector2(field.position.x - 8.0, y), 1.0)
	_draw_strips(canvas, scaled)
	canvas.draw_rect(field, Palette.drawn(Palette.AXIS), false, 1.5)


func _draw_strips(canvas: Control, scaled: Rect2) -> void:
	var left := Vector2(field.position.x, scaled.end.y)
	if _y.has_zero:
		_draw_line(canvas, left, Vector2(field.end.x, left.y), Palette.drawn(Palette.AXIS))
		_write(canvas, "0", Vector2(left.x - 8.0, _y_pixel(0.0)), 1.0)
	if _y.has_no_answer:
		left.y = scaled.position.y
		_draw_line(canvas, left, Vector2(field.end.x, left.y), Palette.drawn(Palette.AXIS))
		_write(canvas, canvas.tr("no answer"), Vector2(left.x - 8.0, _y_pixel(INF)), 1.0)


# The field without its strips.
func _scaled_field() -> Rect2:
	var scaled := field
	if _y.has_zero:
		scaled.size.y -= _STRIP
	if _y.has_no_answer:
		scaled.position.y += _STRIP
		scaled.size.y -= _STRIP
	return scaled


func _x_pixel(value: float) -> float:
	if LogScale.is_zero(value):
		return field.position.x
	return lerpf(field.position.x, field.end.x, _x.share(value))


func _y_pixel(value: float) -> float:
	if LogScale.is_no_answer(value):
		return field.position.y + _STRIP / 2.0
	if LogScale.is_zero(value):
		return field.end.y - _STRIP / 2.0
	var scaled := _scaled_field()
	return lerpf(scaled.end.y, scaled.position.y, _y.share(value))


static func _draw_line(canvas: Control, from: Vector2, to: Vector2, color: Color) -> void:
	canvas.draw_line(from, to, color, 1.0)


# Writes so that the point `at` is on the text's middle line, the share `right` of its width away
# from its beginning.
static func _write(canvas: Control, text: String, at: Vector2, right: float) -> void:
	var font := ThemeDB.fallback_font
	var width := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE).x
	var start := at + Vector2(-width * right, _FONT_SIZE * 0.36)
	var color := Palette.color(Palette.Role.QUIET)
	canvas.draw_string(font, start, text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE, color)
