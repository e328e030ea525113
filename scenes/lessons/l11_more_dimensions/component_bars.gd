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

var _model: MoreDimensionsModel

@onready var _handles_of_a: Array[Handle] = [%A1, %A2, %A3, %A4]
@onready var _handles_of_b: Array[Handle] = [%B1, %B2, %B3, %B4]


func _ready() -> void:
	super()
	for i in MoreDimensionsModel.MOST:
		_connect_handle(_handles_of_a[i], "a", i)
		_connect_handle(_handles_of_b[i], "b", i)
	resized.connect(_lay)


## Chooses the scale so that all components of [param model] are seen.
func fit_model(model: MoreDimensionsModel) -> void:
	_model = model
	_lay()


## Shows the components of [param model] that count.
func show_model(model: MoreDimensionsModel) -> void:
	_model = model
	_place_handles()
	queue_redraw()


func _draw() -> void:
	super()
	var axis := to_screen(Vec2.new()).y
	draw_line(Vector2(0.0, axis), Vector2(size.x, axis), Palette.AXIS, 1.5)
	if not _model:
		return
	for i in _model.dimension():
		_draw_bar(_pixel_of(i, 0), _model.a[i], Palette.Role.A)
		_draw_bar(_pixel_of(i, 1), _model.b[i], Palette.Role.B)
		_write(str(i + 1), Vector2(_pixel_of(i, 0.5), size.y - 8.0), Palette.Role.QUIET)


func _connect_handle(handle: Handle, letter: String, index: int) -> void:
	handle.title = tr("Component %d of %s") % [index + 1, letter]
	handle.moved.connect(func(point: Vec2) -> void: component_moved.emit(letter, index, -point.y))
	handle.released.connect(component_released.emit)


func _lay() -> void:
	if not _model:
		return
	var reach := 1.0
	for i in _model.dimension():
		reach = maxf(reach, maxf(absf(_model.a[i]), absf(_model.b[i])))
	fit([Vec2.new(0.0, reach)] as Array[Vec2])
	_place_handles()


func _place_handles() -> void:
	for i in MoreDimensionsModel.MOST:
		_handles_of_a[i].visible = i < _model.dimension()
		_handles_of_b[i].visible = i < _model.dimension()
		_handles_of_a[i].place(_point_of(i, 0, _model.a[i]))
		_handles_of_b[i].place(_point_of(i, 1, _model.b[i]))


func _point_of(index: int, place: float, value: float) -> Vec2:
	var across := (_pixel_of(index, place) - size.x / 2.0) / pixels_per_unit
	return Vec2.new(across, -value)


# The middle of a bar in pixels from the left; place 0 is a's, place 1 is b's.
func _pixel_of(index: int, place: float) -> float:
	var column := size.x / _model.dimension()
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
