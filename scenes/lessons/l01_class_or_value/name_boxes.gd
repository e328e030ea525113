@tool
class_name NameBoxes
extends BoardPart
## Names and what they stand for: of the Vec2 each name points to a box, the object, and two may
## point to the same one; of the Vector2 each name is a box of its own.

const _FONT_SIZE := 17
# All in pixels.
const _ROW := 38.0
const _BOX_HEIGHT := 30.0
const _POINTER := 30.0
const _GAP := 8.0
const _BELOW := 14.0

## The names for the Vec2, the first one first.
@export var object_names: PackedStringArray = ["position", "old"]
## The names for the Vector2.
@export var value_names: PackedStringArray = ["value", "old_value"]
## What each name for the Vec2 stands for, such as `(2, −3)`; fewer than the names where some are
## not given yet.
@export var objects: PackedStringArray = ["(2, −3)"]
## The same for the Vector2.
@export var values: PackedStringArray = ["(2, −3)"]
## Whether both names point to one object.
@export var is_shared := false


## Shows what the names stand for now.
func show_boxes(new_objects: PackedStringArray, new_values: PackedStringArray, share: bool) -> void:
	objects = new_objects
	values = new_values
	is_shared = share
	show_change()


func _draw() -> void:
	_draw_objects(board.size.x / 4.0)
	_draw_values(board.size.x * 3.0 / 4.0)


func _draw_objects(middle: float) -> void:
	var names_width := _widest(object_names.slice(0, objects.size()))
	var width := names_width + 2.0 * _GAP + _POINTER + _box_width(objects)
	var left := middle - width / 2.0
	var box_x := left + width - _box_width(objects)
	if is_shared and objects.size() > 1:
		_draw_box(
			Vector2(box_x, (_row_y(0, 2) + _row_y(1, 2)) / 2.0), objects[0], _box_width(objects)
		)
	for i in objects.size():
		var y := _row_y(i, objects.size())
		var box_y := y
		if is_shared and objects.size() > 1:
			box_y = (_row_y(0, 2) + _row_y(1, 2)) / 2.0
		else:
			_draw_box(Vector2(box_x, y), objects[i], _box_width(objects))
		_draw_name(object_names[i], left + names_width, y, _role(i, Palette.Role.A))
		var from := Vector2(left + names_width + _GAP, y)
		_draw_pointer(from, Vector2(box_x - 3.0, lerpf(box_y, y, 0.3)), _role(i, Palette.Role.A))


func _draw_values(middle: float) -> void:
	var names_width := _widest(value_names.slice(0, values.size()))
	var width := names_width + _GAP + _box_width(values)
	var left := middle - width / 2.0
	for i in values.size():
		var y := _row_y(i, values.size())
		_draw_name(value_names[i], left + names_width, y, _role(i, Palette.Role.B))
		_draw_box(Vector2(left + names_width + _GAP, y), values[i], _box_width(values))


# The middle of a row, counted from above.
func _row_y(row: int, count: int) -> float:
	return board.size.y - _BELOW - (count - row - 0.5) * _ROW


# The second name has the color of the other helping arrows.
static func _role(i: int, first: Palette.Role) -> Palette.Role:
	return first if i == 0 else Palette.Role.UNIT


func _draw_name(text: String, right: float, y: float, role: Palette.Role) -> void:
	draw_text(text, Vector2(right - _text_width(text) / 2.0, y), Palette.color(role), _FONT_SIZE)


func _draw_box(left_middle: Vector2, text: String, width: float) -> void:
	var box := Rect2(left_middle.x, left_middle.y - _BOX_HEIGHT / 2.0, width, _BOX_HEIGHT)
	draw_rect(box, Palette.FIELD)
	draw_rect(box, Palette.color(Palette.Role.INK), false, 2.0)
	draw_text(text, box.get_center(), Palette.color(Palette.Role.INK), _FONT_SIZE)


func _draw_pointer(from: Vector2, to: Vector2, role: Palette.Role) -> void:
	var color := Palette.color(role)
	var back := to.direction_to(from) * 10.0
	var side := back.orthogonal() * 0.45
	draw_line(from, to + back, color, 2.5, true)
	var corners: PackedVector2Array = [to, to + back + side, to + back - side]
	draw_primitive(corners, [color], [])


func _box_width(texts: PackedStringArray) -> float:
	return maxf(_widest(texts) + 2.0 * _GAP, 56.0)


func _widest(texts: PackedStringArray) -> float:
	var widest := 0.0
	for text in texts:
		widest = maxf(widest, _text_width(text))
	return widest


func _text_width(text: String) -> float:
	return text_extent(text, _FONT_SIZE).x
