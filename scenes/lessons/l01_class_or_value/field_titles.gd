class_name FieldTitles
extends BoardPart
## Names the two fields of the lesson, and says whether their two names stand for one thing or two.

var _left := Vec2.new()
var _right := Vec2.new()
var _is_shared := true


## The fields have their origins at [param left] and [param right]; on the left both names may share
## one object.
func show_fields(left: Vec2, right: Vec2, is_shared: bool) -> void:
	_left = left.copy()
	_right = right.copy()
	_is_shared = is_shared
	queue_redraw()


func _draw() -> void:
	var middle := board.size.x / 2.0
	draw_line(Vector2(middle, 0.0), Vector2(middle, board.size.y), Palette.AXIS, 1.5)
	var sharing := tr("two names, one object") if _is_shared else tr("two objects")
	_write(middle / 2.0, tr("Vec2: an object"), sharing, Palette.Role.A)
	_write(middle * 1.5, tr("Vector2: a value"), tr("two names, two values"), Palette.Role.B)
	for origin: Vec2 in [_left, _right]:
		draw_circle(board.to_screen(origin), 4.0, Palette.AXIS, true, -1.0, true)


func _write(x: float, title: String, sentence: String, role: Palette.Role) -> void:
	draw_text(title, Vector2(x, 28.0), Palette.color(role), 24)
	draw_text(sentence, Vector2(x, 58.0), Palette.color(Palette.Role.INK), 18)
