@tool
class_name ProductStairs
extends Control
## The products as bars, and their sum as stairs: each product goes up or down from where the last
## one ended, and the last stair ends at the dot product.

const _MARGIN_TOP := 40.0
const _MARGIN_BOTTOM := 30.0
const _FONT_SIZE := 17

## What is added up, in square units.
@export var products: PackedFloat64Array = []:
	set(value):
		products = value
		queue_redraw()
## Adds the products up: each begins where the last one ended, and the sum is a stair of its own at
## the end. Else each begins at 0.
@export var shows_sum := true:
	set(value):
		shows_sum = value
		queue_redraw()
		_tell_title()


## The lowest and the highest value that a bar reaches; the axis at 0 is one of them at least.
func spanned() -> Vector2:
	var lowest := 0.0
	var highest := 0.0
	for i in products.size():
		var end := _start_of(i) + products[i]
		lowest = minf(lowest, end)
		highest = maxf(highest, end)
	return Vector2(lowest, highest)


func _ready() -> void:
	resized.connect(queue_redraw)
	_tell_title()


# The editor would save it.
func _tell_title() -> void:
	if not Engine.is_editor_hint():
		accessibility_name = _title()


func _draw() -> void:
	draw_style_box(get_theme_stylebox(&"panel", &"PanelCard"), Rect2(Vector2.ZERO, size))
	_write(_title(), Vector2(size.x / 2.0, 22.0), Palette.Role.QUIET)
	var axis := _pixel(0.0)
	draw_line(Vector2(12.0, axis), Vector2(size.x - 12.0, axis), Palette.drawn(Palette.AXIS), 1.5)
	for i in products.size():
		var from := _start_of(i)
		_draw_stair(i, from, from + products[i], _role_of(products[i]), _text_of(products[i]))
		_write_below(i, ComponentLists.LETTERS[i])
	if shows_sum:
		var sum := _sum_of_first(products.size())
		_draw_stair(products.size(), 0.0, sum, Palette.Role.INK, NumberText.short(sum))
		_write_below(products.size(), "a · b")


func _title() -> String:
	return tr("The products added up") if shows_sum else tr("The products")


func _start_of(index: int) -> float:
	return _sum_of_first(index) if shows_sum else 0.0


func _sum_of_first(count: int) -> float:
	var sum := 0.0
	for i in count:
		sum += products[i]
	return sum


static func _role_of(product: float) -> Palette.Role:
	return Palette.Role.REST if product < 0.0 else Palette.Role.PROJECTION


static func _text_of(product: float) -> String:
	var text := NumberText.short(product)
	return "+" + text if product > 0.0 else text


func _draw_stair(index: int, from: float, to: float, role: Palette.Role, text: String) -> void:
	var color := Palette.color(role)
	var top := minf(_pixel(from), _pixel(to))
	var bottom := maxf(_pixel(from), _pixel(to))
	var middle := _middle_of(index)
	var half := minf(_column() * 0.3, 26.0)
	var area := Rect2(middle - half, top, 2.0 * half, maxf(bottom - top, 2.0))
	draw_rect(area, Color(color, 0.25))
	draw_rect(area, color, false, 2.0)
	if shows_sum and index < products.size():
		var next := Vector2(_middle_of(index + 1) - half, _pixel(to))
		draw_dashed_line(
			Vector2(middle + half, _pixel(to)), next, Palette.drawn(Palette.AXIS), 1.5, 4.0
		)
	_write(text, Vector2(middle, top - 8.0), role)


func _write_below(index: int, text: String) -> void:
	_write(text, Vector2(_middle_of(index), size.y - 10.0), Palette.Role.QUIET)


func _column() -> float:
	return size.x / (products.size() + 1)


func _middle_of(index: int) -> float:
	return _column() * (index + 0.5)


# Where a value is, in pixels from the top; the highest and the lowest stair fit in between.
func _pixel(value: float) -> float:
	var ends := spanned()
	var span := maxf(ends[1] - ends[0], 1e-300)
	var height := size.y - _MARGIN_TOP - _MARGIN_BOTTOM - 24.0
	return _MARGIN_TOP + 16.0 + (ends[1] - value) / span * height


func _write(text: String, middle: Vector2, role: Palette.Role) -> void:
	var font := get_theme_default_font()
	var extent := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE)
	var start := middle - Vector2(extent.x / 2.0, 0.0)
	var color := Palette.color(role)
	draw_string(font, start, text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE, color)
