@tool
class_name OwnDrawing
extends BoardPart
## Draws what the student's code answers: dashed, in a colour that no arrow of the lessons has, and
## thinner than they are, so that both are seen where they lie on each other. While the lesson asks
## something, nothing is seen of it: the question comes before the answer.

const _ROLE := Palette.Role.INK
const _WIDTH := 3.0
const _TIP := 12.0
const _DASHES := 16
# Half of the cross in the middle of a ball.
const _CROSS := 6.0
const _FONT_SIZE := 18
# The height of a plate with words, and what is free at its ends.
const _HIGH := 30.0
const _MARGIN := 8.0
# The ball with the sign on it.
const _BALL := 11.0
const _FAINT := 0.35

var _lesson: Lesson
var _watcher: WorkshopWatcher


## For the board of [param lesson], from what [param watcher] hears.
func _init(lesson: Lesson, watcher: WorkshopWatcher) -> void:
	_lesson = lesson
	_watcher = watcher
	add_to_group(&"answers")


func _process(_seconds: float) -> void:
	visible = not _lesson.is_asking()


## Its colour; faint where it is an answer to something else.
static func ink(is_faint: bool) -> Color:
	return Color(Palette.color(_ROLE), _FAINT if is_faint else 1.0)


## Draws [param mark].
func draw_mark(mark: OwnMark, color: Color) -> void:
	var from := board.to_screen(mark.from)
	var to := board.to_screen(mark.to)
	match mark.shape:
		OwnMark.Shape.ARROW:
			_draw_arrow(from, to, color)
		OwnMark.Shape.LENGTH:
			_draw_length(from, to, color)
		OwnMark.Shape.BALL:
			draw_ball(mark.from, mark.radius, mark.is_filled, color)
		OwnMark.Shape.WAY:
			draw_way_of_strokes(mark.places, color, _WIDTH)


## Draws a ball with a dashed rim.
func draw_ball(center: Vec2, radius: float, is_filled: bool, color: Color) -> void:
	var middle := board.to_screen(center)
	# In 32 bits a circle larger than 1e6 pixels is drawn wrongly.
	var pixels := clampf(radius * board.pixels_per_unit, 2.0, 1e6)
	if is_filled:
		draw_circle(middle, pixels, Color(color, 0.3 * color.a), true, -1.0, true)
	for i in _DASHES:
		var begin := TAU * i / _DASHES
		var end := TAU * (i + 0.6) / _DASHES
		draw_arc(middle, pixels, begin, end, 6, color, Palette.stroke(_WIDTH), true)
	# The lessons' own dashed balls have a dot there.
	for arm: Vector2 in [Vector2(_CROSS, 0.0), Vector2(0.0, _CROSS)]:
		draw_line(middle - arm, middle + arm, color, Palette.stroke(2.0))


## Writes [param words] on a plate beside [param mark], in one of [param places], with a sign on a
## ball for right and wrong; without one where [param sign_text] is "".
func write(
	words: String, sign_text: String, mark: OwnMark, places: OwnPlaces, color: Color
) -> void:
	var wide := _width_of(words) + 2.0 * _MARGIN + (2.0 * _BALL + 6.0 if sign_text else 0.0)
	var extent := Vector2(wide, _HIGH)
	var middle := places.take(_anchor(mark), _reach(mark), _aside(mark), extent)
	var plate := Rect2(middle - extent / 2.0, extent)
	_draw_leader(plate, _anchor(mark), _reach(mark), color)
	draw_rect(plate, Color(Palette.drawn(Palette.PAPER), 0.9 * color.a))
	draw_rect(plate, color, false, Palette.stroke(1.0))
	var end := plate.end.x - _MARGIN - _width_of(words) / 2.0
	draw_text_at(words, Vector2(end, middle.y), color, _FONT_SIZE)
	_draw_sign(sign_text, plate.position + Vector2(_MARGIN + _BALL, _HIGH / 2.0), color.a)


# From a plate to what it is about, which may be some way off.
func _draw_leader(plate: Rect2, anchor: Vector2, reach: float, color: Color) -> void:
	var edge := anchor.clamp(plate.position, plate.end)
	if edge.distance_to(anchor) > reach:
		var end := anchor + anchor.direction_to(edge) * reach
		draw_line(edge, end, Color(color, 0.6 * color.a), Palette.stroke(1.0), true)


func _draw_sign(sign_text: String, middle: Vector2, opacity: float) -> void:
	var role := Palette.Role.RIGHT if sign_text == "✓" else Palette.Role.WRONG
	draw_circle(middle, _BALL, Color(Palette.color(role), opacity), true, -1.0, true)
	var start := middle + Vector2(-_BALL, _FONT_SIZE * 0.36)
	var paper := Color(Palette.drawn(Palette.PAPER), opacity)
	var centered := HORIZONTAL_ALIGNMENT_CENTER
	var font := ThemeDB.fallback_font
	draw_string(font, start, sign_text, centered, 2.0 * _BALL, _FONT_SIZE, paper)


func _draw_arrow(from: Vector2, to: Vector2, color: Color) -> void:
	var stroke := Palette.stroke(_WIDTH)
	if from.distance_to(to) < Arrow.SHORTEST:
		draw_circle(from, 2.0 * stroke, color, false, stroke, true)
		return
	var tip := minf(_TIP, from.distance_to(to))
	draw_strokes(from, to - from.direction_to(to) * tip, color, _WIDTH)
	_draw_tip(from, to, tip, color)


func _draw_length(from: Vector2, to: Vector2, color: Color) -> void:
	draw_strokes(from, to, color, _WIDTH)
	var tip := minf(_TIP, from.distance_to(to) / 2.0)
	if tip > 1.0:
		_draw_tip(from, to, tip, color)
		_draw_tip(to, from, tip, color)


func _draw_tip(from: Vector2, to: Vector2, tip: float, color: Color) -> void:
	var direction := from.direction_to(to)
	var side := direction.orthogonal() * tip * 0.45
	var neck := to - direction * tip
	# Not as a polygon: far outside the board the engine cannot triangulate one.
	var corners: PackedVector2Array = [to, neck + side, neck - side]
	draw_primitive(corners, [color], [])


# What words are about: the head of an arrow, the middle of a length.
func _anchor(mark: OwnMark) -> Vector2:
	var to := board.to_screen(mark.to)
	return board.to_screen(mark.from).lerp(to, 0.5) if mark.shape == OwnMark.Shape.LENGTH else to


func _reach(mark: OwnMark) -> float:
	return minf(mark.radius * board.pixels_per_unit, 1e6)


# Below a ball and a note, beside an arrow.
func _aside(mark: OwnMark) -> Vector2:
	var way := board.to_screen(mark.to) - board.to_screen(mark.from)
	return way.normalized().orthogonal() if way.length() > 1.0 else Vector2.DOWN


func _width_of(words: String) -> float:
	return text_extent(words, _FONT_SIZE).x
