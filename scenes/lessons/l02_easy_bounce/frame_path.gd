@tool
class_name FramePath
extends BoardPart
## Where a ball is frame by frame: its rim and its center in each frame, joined by a line.

## The centers of the ball in order, in units of the plane. 32 bits; [method lay] keeps all digits.
@export var places: PackedVector2Array = []:
	get:
		var rounded: PackedVector2Array = []
		for place in _places:
			rounded.append(place.to_vector2())
		return rounded
	set(value):
		var exact: Array[Vec2] = []
		for place in value:
			exact.append(Vec2.from_vector2(place))
		lay(exact, radius)
## The radius of the ball, in units of the plane.
@export_range(0.0, 1000.0, 0.001, "or_greater") var radius := 1.0:
	set(value):
		radius = value
		show_change()
## Colour of the path.
@export var role := Palette.Role.QUIET
## The label at the end of the path, such as `right`; nothing where it is empty.
@export var label := ""

var _places: Array[Vec2] = []


## Shows a ball of radius [param its_radius] with its center at each of [param centers], in order;
## units of the plane.
func lay(centers: Array[Vec2], its_radius: float) -> void:
	_places = centers
	radius = its_radius


func spanned_points() -> Array[Vec2]:
	return _places


func _draw() -> void:
	var color := Palette.color(role)
	var pixels: PackedVector2Array = []
	for place in _places:
		var middle := board.to_screen(place)
		pixels.append(middle)
		draw_circle(middle, 3.0, color, true, -1.0, true)
		var rim := radius * board.pixels_per_unit
		draw_circle(middle, rim, Color(color, 0.25), false, 1.5, true)
	if pixels.size() > 1:
		draw_polyline(pixels, Color(color, 0.6), 2.0, true)
	if label and not pixels.is_empty():
		var beside := pixels[-1] + Vector2(0.0, -18.0)
		draw_text(tr(label), kept_on_board(beside, Vector2.ZERO, Vector2(30.0, 30.0)), color, 22)
