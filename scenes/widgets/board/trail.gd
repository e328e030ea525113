class_name Trail
extends BoardPart
## The path that something has taken: a line through its latest places.

## Colour of the line.
@export var role := Palette.Role.QUIET
## So many places are kept; the oldest go first.
@export_range(2, 20000) var longest := 2000

var _places: Array[Vec2] = []


## Adds the place where it is now, in units of the plane.
func add_place(place: Vec2) -> void:
	_places.append(place.copy())
	if _places.size() > longest:
		_places.remove_at(0)
	queue_redraw()


## Forgets the path.
func clear() -> void:
	_places.clear()
	queue_redraw()


func _draw() -> void:
	if _places.size() < 2:
		return
	var pixels: PackedVector2Array = []
	for place in _places:
		pixels.append(board.to_screen(place))
	draw_polyline(pixels, Palette.color(role), 2.0, true)
