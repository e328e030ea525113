@tool
class_name ComponentBars
extends Board
## The components of both vectors as bars side by side; their ends can be dragged. For any number of
## dimensions.

## The student moves a component, counted from 0, of a vector, `a` or `b`, to this value.
signal component_moved(letter: String, index: int, value: float)
## A drag or nudge has ended.
signal component_released

const _BAR_PIXELS := 26.0
const _FONT_SIZE := 17
# Pixels for the numbers above the bars, and for numbers and letters below them.
const _ROOM_ABOVE := 14.0
const _ROOM_BELOW := 34.0

## The components of a, in units. There may be more of them than [member dimension].
@export var a: PackedFloat64Array = []:
	set(value):
		a = value
		_show_change()
## The components of b, in units; as many as those of a.
@export var b: PackedFloat64Array = []:
	set(value):
		b = value
		_show_change()
## How many components of each are shown.
@export_range(1, 5) var dimension := 3:
	set(value):
		dimension = value
		_show_change()

var _handles_of_a: Array[Handle] = []
var _handles_of_b: Array[Handle] = []


func _ready() -> void:
	super()
	# The editor would save them.
	if not Engine.is_editor_hint():
		for i in a.size():
			_handles_of_a.append(_new_handle("a", i, Palette.Role.A))
			_handles_of_b.append(_new_handle("b", i, Palette.Role.B))
	resized.connect(_lay)
	_lay()


## Shows the components of [param model] that count, at a scale at which all of them are seen.
func fit_model(model: MoreDimensionsModel) -> void:
	show_model(model)
	_lay()


## Shows the components of [param model] that count; the scale stays.
func show_model(model: MoreDimensionsModel) -> void:
	a = model.a.duplicate()
	b = model.b.duplicate()
	dimension = model.dimension()
	_place_handles()


## Bars of positive numbers point up, whichever way y is drawn.
func turn_over(_y_is_up: bool) -> void:
	pass


func _draw() -> void:
	super()
	var axis := to_screen(Vec2.new()).y
	draw_line(Vector2(0.0, axis), Vector2(size.x, axis), Palette.drawn(Palette.AXIS), 1.5)
	for i in _count():
		_draw_bar(_pixel_of(i, 0), a[i], Palette.Role.A)
		_draw_bar(_pixel_of(i, 1), b[i], Palette.Role.B)
		_write(
			ComponentLists.LETTERS[i], Vector2(_pixel_of(i, 0.5), size.y - 8.0), Palette.Role.QUIET
		)


# No lesson runs in the editor that would choose the scale.
func _show_change() -> void:
	queue_redraw()
	if Engine.is_editor_hint():
		_lay()


func _new_handle(letter: String, index: int, role: Palette.Role) -> Handle:
	var handle := Handle.new()
	handle.name = letter.to_upper() + str(index + 1)
	handle.role = role
	handle.title = tr("Component %d of %s") % [index + 1, letter]
	handle.moved.connect(func(point: Vec2) -> void: component_moved.emit(letter, index, -point.y))
	handle.released.connect(component_released.emit)
	add_child(handle)
	return handle


func _lay() -> void:
	var reach := 1.0
	for i in _count():
		reach = maxf(reach, maxf(absf(a[i]), absf(b[i])))
	# The margin of a small board is too narrow for numbers and letters.
	if is_small():
		keep_free(_ROOM_ABOVE, _ROOM_BELOW)
	else:
		keep_free(0.0, 0.0)
	fit([Vec2.new(0.0, reach)] as Array[Vec2])
	_place_handles()


func _place_handles() -> void:
	for i in _handles_of_a.size():
		_handles_of_a[i].visible = i < dimension
		_handles_of_b[i].visible = i < dimension
		_handles_of_a[i].place(_point_of(i, 0, a[i]))
		_handles_of_b[i].place(_point_of(i, 1, b[i]))


# How many components can be drawn: while the scene is loaded, there may be fewer.
func _count() -> int:
	return mini(dimension, mini(a.size(), b.size()))


func _point_of(index: int, place: float, value: float) -> Vec2:
	var across := (_pixel_of(index, place) - size.x / 2.0) / pixels_per_unit
	return Vec2.new(across, -value)


# The middle of a bar in pixels from the left; place 0 is a's, place 1 is b's.
func _pixel_of(index: int, place: float) -> float:
	var column := size.x / dimension
	var apart := minf(column * 0.4, 56.0)
	return column * (index + 0.5) + apart * (place - 0.5)


func _draw_bar(middle: float, value: float, role: Palette.Role) -> void:
	var from := to_screen(Vec2.new())
	var to := to_screen(Vec2.new(0.0, -value))
	var corner := Vector2(middle - _BAR_PIXELS / 2.0, minf(from.y, to.y))
	var color := Palette.color(role)
	var area := Rect2(corner, Vector2(_BAR_PIXELS, absf(to.y - from.y)))
	draw_rect(area, Color(color, 0.3))
	draw_rect(area, color, false, 2.0)
	var away := -22.0 if value >= 0.0 else 34.0
	_write(NumberText.short(value), Vector2(middle, to.y + away), role)


func _write(text: String, middle: Vector2, role: Palette.Role) -> void:
	var font := get_theme_default_font()
	var extent := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE)
	var start := middle - Vector2(extent.x / 2.0, 0.0)
	var color := Palette.color(role)
	draw_string(font, start, text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE, color)
