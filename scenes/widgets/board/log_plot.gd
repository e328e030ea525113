@tool
class_name LogPlot
extends Control
## A plot with two logarithmic axes, such as error over run time. A point that is pointed at, with
## mouse, finger, keys or gamepad, shows a card with words. A dashed line marks the frontier: the
## points that no other beats.

## The student pointed at the point with this place in the list; -1 for none any more.
signal point_chosen(index: int)

# How far from a point, in pixels, the pointer still chooses it.
const _REACH := 30.0
const _MARGIN_LEFT := 86.0
const _MARGIN := 14.0
const _FOOT := 52.0
const _FONT_SIZE := 16
# Pixels from a point to its card.
const _BESIDE := 16.0
# Pixels from the card to the edge of the field, at least.
const _GAP := 4.0
# The same for the places that are tried next, if the nearest ones hide other points.
const _FURTHER := 90.0
# Longer lines of the card are wrapped, in pixels.
const _WIDEST := 400.0

## The name of the x axis: source text.
@export var x_title := "":
	set(value):
		x_title = value
		_name_plot()
## The name of the y axis: source text.
@export var y_title := "":
	set(value):
		y_title = value
		_name_plot()

var _area := LogPlotArea.new()
var _legend := PlotLegend.new()
var _points: Array[PlotPoint] = []
var _frontier: PackedInt32Array = []
var _names: PackedStringArray = []
var _hollow: Array[bool] = []
var _chosen := -1

## Which mark means what: above the field, or where a lesson puts it.
@onready var legend: Control = %Legend

# Drawn apart, and the card too: both are hidden with all answers.
@onready var _frontier_lines: Control = %Frontier
@onready var _card: PanelContainer = %Card
@onready var _words: Label = %Words


func _ready() -> void:
	resized.connect(_lay)
	draw.connect(_frontier_lines.queue_redraw)
	legend.draw.connect(func() -> void: _legend.draw(legend))
	legend.resized.connect(_lay)
	_frontier_lines.draw.connect(_draw_frontier)
	focus_entered.connect(queue_redraw)
	focus_exited.connect(queue_redraw)
	# A text that wraps has its height only once it has its width.
	_words.minimum_size_changed.connect(_place_card, CONNECT_DEFERRED)
	_lay()


## Names the series, translated, and says which have hollow marks; the numbers of [PlotPoint] count
## them.
func show_series(names: PackedStringArray, is_hollow: Array[bool]) -> void:
	_names = names
	_hollow = is_hollow
	_lay()


## Shows these points; [param frontier] has the places of those that no other beats, from left to
## right. A point that is added keeps the others in their places in the list.
func show_points(points: Array[PlotPoint], frontier: PackedInt32Array) -> void:
	_points = points
	_frontier = frontier
	_area.fit(points)
	if _chosen >= points.size():
		_chosen = -1
	_lay()


## Shows which point is pointed at, -1 for none; emits nothing.
func show_chosen(index: int) -> void:
	_chosen = index
	_show_card()
	queue_redraw()


## Which point is pointed at; -1 for none.
func chosen() -> int:
	return _chosen


## Where a point is drawn, in pixels of the plot.
func pixel_of(index: int) -> Vector2:
	return _area.pixel(_points[index])


func _name_plot() -> void:
	queue_redraw()
	# The editor would save it.
	if not Engine.is_editor_hint():
		accessibility_name = tr("%s over %s") % [tr(y_title), tr(x_title)]


func _lay() -> void:
	var line_name := tr("frontier: none is faster and closer") if _frontier else ""
	_legend.name_series(_names, _hollow, line_name)
	legend.custom_minimum_size.y = _legend.height(legend.size.x)
	legend.queue_redraw()
	var top := _MARGIN + 24.0
	if legend.get_parent() == self:
		top += legend.custom_minimum_size.y + _MARGIN
	var corner := Vector2(_MARGIN_LEFT, top)
	_area.field = Rect2(corner, size - corner - Vector2(2.0 * _MARGIN, _FOOT))
	_show_card()
	queue_redraw()


func _draw() -> void:
	_area.draw(self)
	_draw_titles()
	_draw_series()
	for i in _points.size():
		PlotMark.draw(self, _points[i].series, pixel_of(i), _hollow[_points[i].series])
	if _chosen >= 0:
		draw_arc(
			pixel_of(_chosen),
			PlotMark.RADIUS + 6.0,
			0.0,
			TAU,
			32,
			Palette.drawn(Palette.FOCUS),
			3.0,
			true
		)
	if has_focus():
		draw_rect(Rect2(Vector2.ZERO, size).grow(-2.0), Palette.drawn(Palette.FOCUS), false, 3.0)


func _draw_titles() -> void:
	var field := _area.field
	_write(tr(y_title) + "  ↓ " + tr("closer"), Vector2(_MARGIN, field.position.y - 14.0), 0.0)
	var right := Vector2(field.end.x, size.y - 10.0)
	var title := "← " + tr("faster") + "   " + tr(x_title)
	# A phone has no room for the direction.
	_write(title if _width(title) < right.x - _GAP else tr(x_title), right, 1.0)


# A thin line joins the settings of each method: its slope shows what a smaller step gains.
func _draw_series() -> void:
	for series in _hollow.size():
		var pixels: PackedVector2Array = []
		for i in _points.size():
			if _points[i].series == series:
				pixels.append(pixel_of(i))
		pixels.sort()
		if pixels.size() > 1:
			draw_polyline(pixels, Color(PlotMark.color(series), 0.4), 1.5, true)


# A staircase: for each place to the right and above, some point is both faster and closer.
func _draw_frontier() -> void:
	var color := Palette.color(Palette.Role.INK)
	for i in _frontier.size():
		var at := pixel_of(_frontier[i])
		var top := pixel_of(_frontier[i - 1]).y if i > 0 else _area.field.position.y
		_frontier_lines.draw_dashed_line(Vector2(at.x, top), at, color, 2.0, 6.0)
		var is_last := i == _frontier.size() - 1
		var right := _area.field.end.x if is_last else pixel_of(_frontier[i + 1]).x
		_frontier_lines.draw_dashed_line(at, Vector2(right, at.y), color, 2.0, 6.0)


func _gui_input(event: InputEvent) -> void:
	var mouse := event as InputEventMouse
	if mouse:
		_point_at(mouse)
	elif event.is_action_pressed(&"ui_left", true):
		_go(-1, func(i: int) -> float: return pixel_of(i).x)
	elif event.is_action_pressed(&"ui_right", true):
		_go(1, func(i: int) -> float: return pixel_of(i).x)
	elif event.is_action_pressed(&"ui_up", true):
		_go(-1, func(i: int) -> float: return pixel_of(i).y)
	elif event.is_action_pressed(&"ui_down", true):
		_go(1, func(i: int) -> float: return pixel_of(i).y)


func _point_at(mouse: InputEventMouse) -> void:
	var nearest := -1
	var least := _REACH
	for i in _points.size():
		var distance := pixel_of(i).distance_to(mouse.position)
		if distance < least:
			nearest = i
			least = distance
	var is_click := mouse is InputEventMouseButton and mouse.is_pressed()
	if nearest >= 0 or is_click:
		_choose(nearest)


# To the next point in the order of `place`; points at the same place come one after the other.
func _go(direction: int, place: Callable) -> void:
	accept_event()
	if _points.is_empty():
		return
	var order: Array[int] = []
	order.assign(range(_points.size()))
	order.sort_custom(func(a: int, b: int) -> bool: return [place.call(a), a] < [place.call(b), b])
	var here := order.find(_chosen)
	var next := here + direction if here >= 0 else 0
	_choose(order[clampi(next, 0, order.size() - 1)])


func _choose(index: int) -> void:
	if index != _chosen:
		show_chosen(index)
		point_chosen.emit(index)


func _show_card() -> void:
	if _card.visible != (_chosen >= 0):
		_card.visible = _chosen >= 0
	if _chosen < 0:
		return
	_words.text = "\n".join(_points[_chosen].words)
	var widest := minf(_WIDEST, _area.field.size.x - 4.0 * _MARGIN)
	_words.custom_minimum_size.x = minf(_width_of_longest(_points[_chosen].words), widest)
	_place_card()


func _place_card() -> void:
	if _chosen < 0:
		return
	_card.reset_size()
	_card.position = _place_beside(pixel_of(_chosen), _card.size)


func _width_of_longest(lines: PackedStringArray) -> float:
	var font := _words.get_theme_font(&"font")
	var font_size := _words.get_theme_font_size(&"font_size")
	var longest := 0.0
	for line in lines:
		var width := font.get_string_size(line, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x
		longest = maxf(longest, width)
	return ceilf(longest)


# The card is put above or below the point, to its right or left, near or further away: where it
# hides the fewest other points, and over no number of the axes.
func _place_beside(at: Vector2, extent: Vector2) -> Vector2:
	var best := Vector2.ZERO
	var fewest := _points.size() + 1
	var room := Rect2(_area.field.position, _area.field.size - extent).grow(-_GAP)
	for across: float in [_BESIDE, -_BESIDE - extent.x]:
		for down: float in [-_BESIDE - extent.y, _BESIDE, -_FURTHER - extent.y, _FURTHER]:
			var place := (at + Vector2(across, down)).clamp(
				room.position, room.end.max(room.position)
			)
			var covered := _count_inside(Rect2(place, extent).grow(PlotMark.RADIUS))
			if covered < fewest:
				best = place
				fewest = covered
	return best


func _count_inside(place: Rect2) -> int:
	var count := 0
	for i in _points.size():
		if place.has_point(pixel_of(i)):
			count += 1
	return count


func _write(text: String, at: Vector2, right: float) -> void:
	var color := Palette.color(Palette.Role.INK)
	var start := at - Vector2(_width(text) * right, 0.0)
	draw_string(
		ThemeDB.fallback_font, start, text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE, color
	)


static func _width(text: String) -> float:
	var font := ThemeDB.fallback_font
	return font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE).x
