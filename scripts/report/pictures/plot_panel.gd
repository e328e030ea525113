class_name PlotPanel
extends RefCounted
## One situation of a problem in a picture: error against run time, both on logarithmic axes.

const _INK := Palette.Role.INK
const _SMALL := 17
# The margin between the outermost points and the edge of the field.
const _INSET := 16.0

## The left edge of the field.
var left: float
## The upper edge of the field.
var top: float
## The width of the field.
var width: float
## The height of the field.
var height: float
## The horizontal axis.
var times: LogAxis
## The vertical axis.
var errors: LogAxis


## Draws field, marks, labels, points and frontier into [param picture].
func draw(
	picture: SvgText, rows: Array[Measurement], markers: Dictionary[String, PlotMarker]
) -> void:
	_draw_field(picture)
	var title := rows[0].situation
	picture.text(title, left + width / 2.0, top - 20.0, 18, _color(_INK), "middle")
	for method in markers:
		_draw_settings(picture, _rows_of(method, rows), markers[method])
	_draw_frontier(picture, Frontier.of(rows))
	for row in rows:
		var words := "%s, %s" % [row.method, row.setting]
		words += (
			": %s µs, %s %s" % [FigureText.short(row.run_time_us), FigureText.of(row), row.note]
		)
		picture.add(markers[row.method].element(_x(row), _y(row), 6.5, words))


func _draw_frontier(picture: SvgText, rows: Array[Measurement]) -> void:
	var points: PackedFloat64Array = []
	for row in rows:
		points.append_array([_x(row), _y(row)])
		picture.add(PlotMarker.ring(_x(row), _y(row)))
	picture.path(points, _color(_INK), 2.5, PlotMarker.DASHES)


# A thin line that joins the settings of a method.
func _draw_settings(picture: SvgText, rows: Array[Measurement], marker: PlotMarker) -> void:
	var points: PackedFloat64Array = []
	for row in rows:
		points.append_array([_x(row), _y(row)])
	if rows.size() > 1:
		picture.path(points, marker.color, 1.0)


func _draw_field(picture: SvgText) -> void:
	var grid := SvgText.hex(Palette.GRID)
	var ink := _color(Palette.Role.QUIET)
	for tick in times.ticks(floori(width / 50.0)):
		var x := _across(tick)
		picture.line(x, top, x, top + height, grid)
		picture.text(LogAxis.label(tick), x, top + height + 22.0, _SMALL, ink, "middle")
	for tick in errors.ticks(floori(height / 32.0)):
		var y := _down(tick)
		picture.line(left, y, left + width, y, grid)
		picture.text(LogAxis.label(tick), left - 8.0, y + 6.0, _SMALL, ink, "end")
	var axis := SvgText.hex(Palette.AXIS)
	picture.line(left, top + height, left + width, top + height, axis, 1.5)
	picture.line(left, top, left, top + height, axis, 1.5)


func _rows_of(method: String, rows: Array[Measurement]) -> Array[Measurement]:
	return rows.filter(func(row: Measurement) -> bool: return row.method == method)


func _x(row: Measurement) -> float:
	return _across(row.run_time_us)


func _y(row: Measurement) -> float:
	return _down(row.error)


func _across(time: float) -> float:
	return left + _INSET + (width - 2.0 * _INSET) * times.place(time)


func _down(error: float) -> float:
	return top + _INSET + (height - 2.0 * _INSET) * (1.0 - errors.place(error))


func _color(role: Palette.Role) -> String:
	return SvgText.hex(Palette.color(role))
