class_name PlotLegend
extends RefCounted
## Which mark of a plot means what, in as many rows as the width needs.

const _FONT_SIZE := 16
const _ROW := 25.0
# From the mark's middle to its text, and from there to the next mark.
const _BESIDE := 18.0
const _GAP := 20.0
# The length of the sample of a line.
const _STROKE := 26.0

var _names: PackedStringArray = []
var _is_hollow: Array[bool] = []
var _line_name := ""


## Names the series, translated, and says which have hollow marks; [param line_name] is the text
## beside a dashed line, "" where there is none.
func name_series(names: PackedStringArray, is_hollow: Array[bool], line_name: String) -> void:
	_names = names
	_is_hollow = is_hollow
	_line_name = line_name


## The height of the legend in pixels, for a width in pixels.
func height(width: float) -> float:
	return 0.0 if _names.is_empty() else _places(width)[-1].y + _ROW


## Draws the legend on all of [param canvas].
func draw(canvas: Control) -> void:
	var places := _places(canvas.size.x)
	for i in _names.size():
		var at := places[i] + Vector2(PlotMark.RADIUS + 3.0, _ROW / 2.0)
		PlotMark.draw(canvas, i, at, _is_hollow[i])
		_write(canvas, _names[i], at + Vector2(_BESIDE, 0.0), Palette.color(Palette.Role.INK))
	if _line_name:
		var start := places[-1] + Vector2(0.0, _ROW / 2.0)
		var end := start + Vector2(_STROKE, 0.0)
		var color := Palette.color(Palette.Role.INK)
		canvas.draw_dashed_line(start, end, color, 2.0, 6.0)
		_write(canvas, _line_name, end + Vector2(8.0, 0.0), color)


# The corner of each entry; the line is the last.
func _places(width: float) -> PackedVector2Array:
	var places: PackedVector2Array = []
	var at := Vector2.ZERO
	for text in _names + PackedStringArray([_line_name] if _line_name else []):
		var wide := _width_of(text) + _BESIDE + PlotMark.RADIUS + 3.0
		if at.x > 0.0 and at.x + wide > width:
			at = Vector2(0.0, at.y + _ROW)
		places.append(at)
		at.x += wide + _GAP
	return places


static func _width_of(text: String) -> float:
	var font := ThemeDB.fallback_font
	return font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE).x


static func _write(canvas: Control, text: String, middle_left: Vector2, color: Color) -> void:
	var at := middle_left + Vector2(0.0, _FONT_SIZE * 0.36)
	canvas.draw_string(
		ThemeDB.fallback_font, at, text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE, color
	)
