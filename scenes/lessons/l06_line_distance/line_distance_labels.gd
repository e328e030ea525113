@tool
class_name LineDistanceLabels
extends BoardPart
## Names on the board: p, c, the normal, the shadow, and a plus on the good side of the line, to
## which its normal points, and a minus on the other.

const _AWAY := 24.0
const _FONT_SIZE := 24
## Where along the line the signs stand.
const _SHARE_OF_SIGNS := 0.94

var _model: LineDistanceModel
var _step := 0
var _times := 1.0


## Puts the names where [param model] has what they name at [param step]; the normal is drawn
## [param times] as long as it is.
func lay(model: LineDistanceModel, step: int, times: float) -> void:
	_model = model
	_step = step
	_times = times
	queue_redraw()


func _draw() -> void:
	var normal := _model.line.normal().to_vector2()
	var from := board.to_screen(_model.from())
	var behind_p := normal * _side() + _away_from_p()
	_write("p", from - behind_p.normalized() * _AWAY, Palette.Role.A)
	var centre := board.to_screen(_model.ball.position)
	_write("c", centre + _away_from_p() * _AWAY, Palette.Role.INK)
	if _step >= 1:
		_draw_signs(normal * _AWAY)
		_draw_normal_names(from, normal)


func _draw_signs(away: Vector2) -> void:
	var place := board.to_screen(_model.line.start.lerped(_model.line.end, _SHARE_OF_SIGNS))
	draw_text("+", place + away, Palette.color(Palette.Role.RIGHT), 30)
	draw_text(NumberText.MINUS, place - away, Palette.color(Palette.Role.WRONG), 30)


# The longer of normal and shadow has its name beyond its tip, the shorter one beside it.
func _draw_normal_names(from: Vector2, normal: Vector2) -> void:
	var length := _times * board.pixels_per_unit
	var shadow := _model.distance() * board.pixels_per_unit if _step >= 2 else 0.0
	var beside := from - _away_from_p() * 46.0
	var is_normal_longer := shadow < length
	var at_normal := from + normal * (length + 18.0)
	if not is_normal_longer:
		at_normal = beside + normal * length * 0.5
	_write(NumberText.short(_times) + " n̂", at_normal, Palette.Role.UNIT)
	var at_shadow := from + normal * (shadow + 18.0 * _side())
	if is_normal_longer and shadow >= 0.0:
		at_shadow = beside + normal * maxf(shadow, 34.0)
	if _step >= 2:
		_write("d · n̂", at_shadow, Palette.Role.PROJECTION)


# The direction on screen along the line from p towards the ball.
func _away_from_p() -> Vector2:
	var along := _model.line.along().normalized()
	return along.to_vector2() * (-1.0 if _model.difference().dot(along) < 0.0 else 1.0)


# 1 where the ball is in front of the line, -1 behind it.
func _side() -> float:
	return -1.0 if _model.is_behind() else 1.0


func _write(text: String, middle: Vector2, role: Palette.Role) -> void:
	var room := Rect2(Vector2.ZERO, board.size).grow(-26.0)
	draw_text(text, middle.clamp(room.position, room.end), Palette.color(role), _FONT_SIZE)
