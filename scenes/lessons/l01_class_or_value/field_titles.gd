@tool
class_name FieldTitles
extends BoardPart
## Names the two fields of the lesson, and says whether the two names in each share one thing.

## Half as wide as the longest title and sentence, in pixels.
const HALF_TITLE := 110.0

## The origin of the field of the Vec2, in units of the plane.
@export var left := Vector2.ZERO:
	get:
		return _left.to_vector2()
	set(value):
		_left = Vec2.from_vector2(value)
		show_change()
## The origin of the field of the Vector2.
@export var right := Vector2.ZERO:
	get:
		return _right.to_vector2()
	set(value):
		_right = Vec2.from_vector2(value)
		show_change()
## What is said of the names of the Vec2, as it is to be read; nothing where it is empty.
@export var left_sentence := "":
	set(value):
		left_sentence = value
		queue_redraw()
## The same for the Vector2.
@export var right_sentence := "":
	set(value):
		right_sentence = value
		queue_redraw()

var _left := Vec2.new()
var _right := Vec2.new()


## The fields have their origins at [param left_origin] and [param right_origin]; [param sentences],
## translated, say of each how many things its names share.
func show_fields(left_origin: Vec2, right_origin: Vec2, sentences: PackedStringArray) -> void:
	_left = left_origin.copy()
	_right = right_origin.copy()
	left_sentence = sentences[0]
	right_sentence = sentences[1]
	show_change()


## Half as wide as the longest title and sentence here: on a narrow board they are smaller.
func half_title() -> float:
	return minf(HALF_TITLE, board.size.x / 4.0)


## The middle of each title in pixels from the left of the board: above its origin, but never
## outside of its half of the board.
func title_places() -> PackedFloat32Array:
	var quarter := board.size.x / 4.0
	var room := maxf(quarter - half_title(), 0.0)
	var left_x := clampf(board.to_screen(_left).x, quarter - room, quarter + room)
	var right_x := clampf(board.to_screen(_right).x, 3.0 * quarter - room, 3.0 * quarter + room)
	return [left_x, right_x]


func spanned_points() -> Array[Vec2]:
	return [_left, _right]


func _draw() -> void:
	var middle := board.size.x / 2.0
	draw_line(Vector2(middle, 0.0), Vector2(middle, board.size.y), Palette.drawn(Palette.AXIS), 1.5)
	var places := title_places()
	_write(places[0], tr("Vec2: an object"), left_sentence, Palette.Role.A)
	_write(places[1], tr("Vector2: a value"), right_sentence, Palette.Role.B)
	for origin: Vec2 in [_left, _right]:
		draw_circle(board.to_screen(origin), 4.0, Palette.drawn(Palette.AXIS), true, -1.0, true)


func _write(x: float, title: String, sentence: String, role: Palette.Role) -> void:
	var share := half_title() / HALF_TITLE
	draw_text(title, Vector2(x, 28.0), Palette.color(role), roundi(24 * share))
	draw_text(sentence, Vector2(x, 58.0), Palette.color(Palette.Role.INK), roundi(18 * share))
