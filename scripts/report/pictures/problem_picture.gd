class_name ProblemPicture
extends RefCounted
## The picture of a problem: a panel for each situation, all with the same axes, and a legend.

const _WIDTH := 1200
const _MOST_COLUMNS := 3
# Margins around the panels for titles, numbers and the legend.
const _TOP := 96.0
const _MARGIN := 78.0
const _GAP := 92.0
const _RIGHT := 24.0
const _AXIS_ROOM := 66.0
const _LEGEND_ROW := 28.0
const _LEGEND_COLUMNS := 3


## The whole SVG text; [param rows] are the problem's measurements, at least one.
static func of(problem: ReportProblem, rows: Array[Measurement]) -> String:
	var situations := situations_in(rows)
	var markers := PlotMarker.for_methods(rows)
	var columns := _columns(situations.size())
	var lines := ceili(float(situations.size()) / columns)
	var height := 300.0 if lines > 1 else 400.0
	var legend := _TOP + lines * (height + _GAP) - _GAP + _AXIS_ROOM
	var legend_rows := ceili(float(markers.size() + 1) / _LEGEND_COLUMNS)
	var picture := SvgText.new(_WIDTH, ceili(legend + legend_rows * _LEGEND_ROW + 24.0))
	var panel := PlotPanel.new()
	panel.times = LogAxis.new(_values(rows, true))
	panel.errors = LogAxis.new(_values(rows, false))
	panel.width = (_WIDTH - _MARGIN - _RIGHT - (columns - 1) * _MARGIN) / columns
	panel.height = height
	for i in situations.size():
		panel.left = _MARGIN + (i % columns) * (panel.width + _MARGIN)
		panel.top = _TOP + floorf(float(i) / columns) * (height + _GAP)
		panel.draw(picture, in_situation(situations[i], rows), markers)
	_draw_words(picture, problem, legend)
	_draw_legend(picture, markers, legend + 10.0)
	return picture.to_text()


## The situations of these measurements, in order of appearance.
static func situations_in(rows: Array[Measurement]) -> PackedStringArray:
	var found: PackedStringArray = []
	for row in rows:
		if not found.has(row.situation):
			found.append(row.situation)
	return found


## The measurements of one situation.
static func in_situation(situation: String, rows: Array[Measurement]) -> Array[Measurement]:
	return rows.filter(func(row: Measurement) -> bool: return row.situation == situation)


static func _columns(count: int) -> int:
	# Four panels look better in two rows of two. More than six get a column more, so that two rows
	# hold them.
	if count == 4:
		return 2
	return mini(count, _MOST_COLUMNS if count <= 2 * _MOST_COLUMNS else _MOST_COLUMNS + 1)


static func _values(rows: Array[Measurement], are_times: bool) -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	for row in rows:
		found.append(row.run_time_us if are_times else row.error)
	return found


static func _draw_words(picture: SvgText, problem: ReportProblem, legend: float) -> void:
	var ink := SvgText.hex(Palette.color(Palette.Role.INK))
	picture.text(problem.title, _MARGIN, 36.0, 24, ink)
	picture.text(problem.run_time_axis, _WIDTH / 2.0, legend - 14.0, 18, ink, "middle")
	picture.upright_text(problem.error_axis, 20.0, (_TOP + legend - _AXIS_ROOM) / 2.0, 18, ink)


static func _draw_legend(
	picture: SvgText, markers: Dictionary[String, PlotMarker], top: float
) -> void:
	var ink := SvgText.hex(Palette.color(Palette.Role.INK))
	var column := (_WIDTH - _MARGIN) / _LEGEND_COLUMNS
	var index := 0
	for method in markers:
		var x := _MARGIN + (index % _LEGEND_COLUMNS) * column
		var y := top + floorf(float(index) / _LEGEND_COLUMNS) * _LEGEND_ROW + 10.0
		picture.add(markers[method].element(x, y, 7.0))
		picture.text(method, x + 18.0, y + 6.0, 18, ink)
		index += 1
	var left := _MARGIN + (index % _LEGEND_COLUMNS) * column
	var line := top + floorf(float(index) / _LEGEND_COLUMNS) * _LEGEND_ROW + 10.0
	picture.path([left - 10.0, line, left + 30.0, line], ink, 2.5, PlotMarker.DASHES)
	picture.add(PlotMarker.ring(left + 10.0, line))
	picture.text("frontier: none is better in both", left + 38.0, line + 6.0, 18, ink)
