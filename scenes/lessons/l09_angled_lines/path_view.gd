@tool
class_name PathView
extends BoardPart
## The path that a ball will take: a dotted line, with a note at the point of impact.

# Pixels between two dots.
const _GAP := 9.0
# From the point of impact to its note, behind the line, in pixels of the screen: across and down.
# A note is wider than high, and so needs more room beside an upright line.
const _NOTE_DISTANCE := Vector2(76.0, 46.0)

## The places through which the path goes, in units of the plane. 32 bits; [method show_path] keeps
## all digits.
@export var places: PackedVector2Array:
	get:
		return PackedVector2Array(
			_path.map(func(place: Vec2) -> Vector2: return place.to_vector2())
		)
	set(value):
		_path.assign(Array(value).map(Vec2.from_vector2))
		show_change()
## The note at the point of impact, such as `t = 0.5`; nothing where it is empty.
@export var note := "":
	set(value):
		note = value
		queue_redraw()
## The point of impact, in units of the plane.
@export var note_place := Vector2.ZERO:
	set(value):
		note_place = value
		queue_redraw()
## The unit normal there; the note is on the other side.
@export var note_normal := Vector2.ZERO:
	set(value):
		note_normal = value
		queue_redraw()
## Colour of the dots.
@export var role := Palette.Role.PROJECTION

var _path: Array[Vec2] = []


## Shows a path through these places; none for an empty list.
func show_path(path: Array[Vec2]) -> void:
	_path = path
	show_change()


## Writes [param text] at the point of impact [param place], on the side away from the unit vector
## [param normal].
func show_note(text: String, place: Vec2, normal: Vec2) -> void:
	note = text
	note_place = place.to_vector2()
	note_normal = normal.to_vector2()


## Takes the note away.
func clear_note() -> void:
	note = ""


func spanned_points() -> Array[Vec2]:
	return _path


func _draw() -> void:
	_draw_dots()
	if note:
		var middle := board.to_screen(Vec2.from_vector2(note_place))
		var away := -note_normal * _NOTE_DISTANCE
		var room := Rect2(Vector2.ZERO, board.size).grow(-40.0)
		var place := (middle + away).clamp(room.position, room.end)
		draw_text(note, place, Palette.color(role), 18)


func _draw_dots() -> void:
	var color := Palette.color(role)
	var ahead := 0.0
	for i in range(1, _path.size()):
		var from := board.to_screen(_path[i - 1])
		var to := board.to_screen(_path[i])
		var length := from.distance_to(to)
		while ahead < length:
			draw_circle(from.lerp(to, ahead / length), 1.8, color)
			ahead += _GAP
		ahead -= length
