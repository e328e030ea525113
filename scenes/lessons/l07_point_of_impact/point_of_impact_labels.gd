@tool
class_name PointOfImpactLabels
extends BoardPart
## The names of the balls on the board and of the motion, each beside what it names.

const _FONT_SIZE := 20


## One name and where it stands.
class Name:
	extends RefCounted
	var text: String
	var role: Palette.Role
	var centre: Vec2
	var direction: Vec2
	var radius: float


var _names: Array[Name] = []


## Forgets all names.
func clear() -> void:
	_names.clear()
	queue_redraw()


## Writes [param text] beside the ball of [param radius] at [param centre], in units of the plane,
## to where [param direction] points.
func add_name(
	text: String, role: Palette.Role, centre: Vec2, direction: Vec2, radius: float
) -> void:
	var added := Name.new()
	added.text = text
	added.role = role
	added.centre = centre.copy()
	added.direction = direction.normalized()
	added.radius = radius
	_names.append(added)


func _draw() -> void:
	var room := Rect2(Vector2.ZERO, board.size).grow(-26.0)
	for each in _names:
		var middle := _middle_of(each).clamp(room.position, room.end)
		draw_text(each.text, middle, Palette.color(each.role), _FONT_SIZE)


func _middle_of(each: Name) -> Vector2:
	var direction := each.direction.to_vector2()
	var font := ThemeDB.fallback_font
	var extent := font.get_string_size(each.text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE)
	var half := absf(direction.x) * extent.x / 2.0 + absf(direction.y) * _FONT_SIZE / 2.0
	var rim := maxf(each.radius * board.pixels_per_unit, 4.0)
	return board.to_screen(each.centre) + direction * (rim + half + 8.0)
