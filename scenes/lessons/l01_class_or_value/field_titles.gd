@tool
class_name FieldTitles
extends BoardPart
## Names the two fields of the lesson, and says whether their two names stand for one thing or two.

var _left := Vec2.new()
var _right := Vec2.new()
var _sharing: PackedStringArray = []


## The fields have their origins at [param left] and [param right]; [param sharing] says of each how
## many things its names stand for.
func show_fields(left: Vec2, right: Vec2, sharing: PackedStringArray) -> void:
	_left = left.copy()
	_right = right.copy()
	_sharing = sharing
	queue_redraw()


func _draw() -> void:
	var middle := board.size.x / 2.0
	draw_line(Vector2(middle, 0.0), Vector2(middle, board.size.y), Palette.AXIS, 1.5)
	_write(middle / 2.0, tr("Vec2: an object"), _sharing[0], Palette.Role.A)
	_write(middle * 1.5, tr("Vector2: a value"), _sharing[1], Palette.Role.B)
	for origin: Vec2 in [_left, _right]:
		draw_circle(board.to_screen(origin), 4.0, Palette.AXIS, true, -1.0, true)


func _write(x: float, title: String, sentence: String, role: Palette.Role) -> void:
	draw_text(title, Vector2(x, 28.0), Palette.color(role), 24)
	draw_text(sentence, Vector2(x, 58.0), Palette.color(Palette.Role.INK), 18)
