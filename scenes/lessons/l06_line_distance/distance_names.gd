@tool
class_name DistanceNames
extends BoardPart
## The names of p, c, the normal and the shadow, each beside what it names; and a plus on the good
## side of the line, to which the normal points, and a minus on the other.
##
## Line, point and ball say where the names are, so that there is nothing to set here.

const _AWAY := 24.0
const _FONT_SIZE := 24

## Where along the line the two signs are: 0 at its start, 1 at its end.
@export_range(0.0, 1.0, 0.01) var share_of_signs := 0.04

@onready var _line: DraggableVector = %Line
@onready var _from: Handle = %From
@onready var _ball: BallView = %Ball
@onready var _normal: Arrow = %Normal
@onready var _shadow: Arrow = %Shadow


# The shadow is an answer: its name is hidden with it.
func _ready() -> void:
	_shadow.draw.connect(queue_redraw)


## The normal is drawn this many times as long as it is.
func times() -> float:
	return 2.0 * board.grid_step


func _draw() -> void:
	var line := LineSegment.new(_line.tail_point(), _line.head_point())
	var normal := board.direction_to_screen(line.normal())
	var from := board.to_screen(_from.at())
	var ahead := _ahead(line)
	_write("p", from - (normal * _side(line) + ahead).normalized() * _AWAY, Palette.Role.A)
	_write("c", board.to_screen(_ball.at()) + ahead * _AWAY, Palette.Role.INK)
	if _normal.visible:
		_draw_signs(line.start.lerped(line.end, share_of_signs), normal * _AWAY)
		_draw_names_along_normal(from, line)


func _draw_signs(place: Vec2, away: Vector2) -> void:
	var middle := board.to_screen(place)
	draw_text("+", middle + away, Palette.color(Palette.Role.RIGHT), 30)
	draw_text(NumberText.MINUS, middle - away, Palette.color(Palette.Role.WRONG), 30)


# The longer of normal and shadow has its name beyond its tip, the shorter one beside it.
func _draw_names_along_normal(from: Vector2, line: LineSegment) -> void:
	var normal := board.direction_to_screen(line.normal())
	var length := times() * board.pixels_per_unit
	var distance := _ball.at().minus(_from.at()).dot(line.normal())
	var is_shadow_shown := _shadow.visible and _shadow.modulate.a > 0.0
	var shadow := distance * board.pixels_per_unit if is_shadow_shown else 0.0
	var beside := from - _ahead(line) * 46.0
	var is_normal_longer := shadow < length
	var at_normal := from + normal * (length + 18.0)
	if not is_normal_longer:
		at_normal = beside + normal * length * 0.5
	_write(NumberText.short(times()) + " n̂", at_normal, Palette.Role.UNIT)
	var at_shadow := from + normal * (shadow + 18.0 * _side(line))
	if is_normal_longer and shadow >= 0.0:
		at_shadow = beside + normal * maxf(shadow, 34.0)
	if is_shadow_shown:
		_write("d · n̂", at_shadow, Palette.Role.PROJECTION)


# The direction on screen along the line from p towards the ball.
func _ahead(line: LineSegment) -> Vector2:
	var along := line.along().normalized()
	var is_behind := _ball.at().minus(_from.at()).dot(along) < 0.0
	return board.direction_to_screen(along) * (-1.0 if is_behind else 1.0)


# 1 where the ball is in front of the line, -1 behind it.
func _side(line: LineSegment) -> float:
	return -1.0 if LineDistance.signed_distance(_ball.at(), line) < 0.0 else 1.0


func _write(text: String, middle: Vector2, role: Palette.Role) -> void:
	var at := kept_on_board(middle, Vector2.ZERO, Vector2(26.0, 26.0))
	draw_text(text, at, Palette.color(role), _FONT_SIZE)
