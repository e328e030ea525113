@tool
class_name PathView
extends BoardPart
## The path that is to come: a dotted line.

# Pixels between two dots.
const _GAP := 9.0
# From the point of impact to its note, behind the line, in pixels of the screen; a line that
# stands upright needs more, because the note is wider than high.
const _NOTE_DISTANCE := Vector2(76.0, 46.0)

## Colour of the dots.
@export var role := Palette.Role.PROJECTION

var _path: Array[Vec2] = []
var _note := ""
var _note_bounce: BounceRecord


## Shows a path through these places; none for an empty list.
func show_path(path: Array[Vec2]) -> void:
	_path = path
	queue_redraw()


## Writes a note behind the line that is touched in [param bounce]; none for an empty one.
func show_note(note: String, bounce: BounceRecord) -> void:
	_note = note
	_note_bounce = bounce
	queue_redraw()


func _draw() -> void:
	_draw_dots()
	if _note:
		var middle := board.to_screen(_note_bounce.position)
		var away := -_note_bounce.normal.to_vector2() * _NOTE_DISTANCE
		var room := Rect2(Vector2.ZERO, board.size).grow(-40.0)
		var place := (middle + away).clamp(room.position, room.end)
		draw_text(_note, place, Palette.color(role), 18)


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
