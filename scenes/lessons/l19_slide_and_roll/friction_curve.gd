@tool
class_name FrictionCurve
extends Control
## The acceleration of a ball on a slope against µ, over the axis of a [FrictionCard]: it falls
## until the ball rolls, and then stays. The mark is where it begins to roll.

const _FONT_SIZE := FrictionCard.FONT_SIZE
const _DOT := 6.0

var _pull := 0.0
var _pressure := 1.0
var _mark := 0.0
var _friction := 0.0
# That of the mistake; NAN where it is not shown.
var _wrong_mark := NAN

@onready var _card: FrictionCard = get_parent() as FrictionCard


## Shows the accelerations on the slope of [param model], and the mark at tan where it
## [param has_wrong_mark].
func show_model(model: SlideAndRollModel, has_wrong_mark: bool) -> void:
	var incline := model.incline(model.friction)
	_pull = incline.pull
	_pressure = incline.pressure
	_mark = model.mark()
	_friction = model.friction
	_wrong_mark = model.slope() if has_wrong_mark else NAN
	queue_redraw()


func _draw() -> void:
	if _card:
		_draw_ground()
		_draw_curve()
		_draw_mark(_mark, "tan / 3", Palette.Role.RIGHT)
		if not is_nan(_wrong_mark):
			_draw_mark(_wrong_mark, "tan ✗", Palette.Role.WRONG)


# Where it rolls; on the left of the mark it slips.
func _draw_ground() -> void:
	var left := _card.pixel_of(minf(_mark, _card.most))
	var top := FrictionCard.MARGIN_TOP
	var room := Vector2(_card.pixel_of(_card.most) - left, _foot() - top)
	draw_rect(Rect2(Vector2(left, top), room), Color(Palette.color(Palette.Role.RIGHT), 0.1))
	_write(tr("rolls"), left + room.x / 2.0, _foot() - 10.0, Palette.Role.RIGHT, room.x)
	var slips := left - _card.pixel_of(0.0)
	_write(tr("slips"), left - slips / 2.0, _foot() - 10.0, Palette.Role.QUIET, slips)


func _draw_curve() -> void:
	if _pull <= 0.0:
		return
	var points: PackedVector2Array = []
	for friction: float in [0.0, minf(_mark, _card.most), _card.most]:
		points.append(_pixel(friction))
	draw_polyline(points, Palette.color(Palette.Role.INK), Palette.stroke(2.5), true)
	var at := _pixel(_friction)
	draw_circle(at, _DOT + 1.0, Palette.drawn(Palette.PAPER), true, -1.0, true)
	draw_circle(at, _DOT, Palette.color(Palette.Role.INK), true, -1.0, true)
	var text := "a = %s" % NumberText.short(_acceleration(_friction))
	_write(text, size.x, at.y - 10.0, Palette.Role.INK, size.x)


func _draw_mark(friction: float, text: String, role: Palette.Role) -> void:
	if friction > _card.most:
		return
	var x := _card.pixel_of(friction)
	var top := Vector2(x, FrictionCard.MARGIN_TOP)
	var foot := Vector2(x, _foot())
	draw_dashed_line(top, foot, Palette.color(role), Palette.stroke(2.0), 5.0)
	_write(text, x, size.y - 10.0, role, size.x)


func _acceleration(friction: float) -> float:
	return _pull - _pressure * minf(friction, _mark)


func _pixel(friction: float) -> Vector2:
	var height := _foot() - FrictionCard.MARGIN_TOP - 14.0
	var share := _acceleration(friction) / _pull
	return Vector2(_card.pixel_of(friction), _foot() - height * share)


func _foot() -> float:
	return size.y - FrictionCard.MARGIN_BOTTOM


# A text with its middle at `x`, inside the card; nothing where it needs more than `room`.
func _write(text: String, x: float, y: float, role: Palette.Role, room: float) -> void:
	var font := get_theme_default_font()
	var width := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE).x
	if width > room:
		return
	var at := Vector2(clampf(x - width / 2.0, 6.0, size.x - width - 6.0), y)
	var rim := Palette.drawn(Palette.FIELD)
	draw_string_outline(font, at, text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE, 5, rim)
	draw_string(font, at, text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE, Palette.color(role))
