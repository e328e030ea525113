@tool
class_name ComponentTriangle
extends BoardPart
## The triangle of a vector's components x and y, turned together with the vector: it shows where
## each component goes.

## Where the vector begins, in units of the plane. 32 bits; [method lay] keeps all digits.
@export var tail := Vector2.ZERO:
	get:
		return _tail.to_vector2()
	set(value):
		lay(Vec2.from_vector2(value), _vector, degrees)
## The vector before it is turned, in units of the plane.
@export var vector := Vector2.ZERO:
	get:
		return _vector.to_vector2()
	set(value):
		lay(_tail, Vec2.from_vector2(value), degrees)
## By how much it is turned, from the x axis to the y axis.
@export_range(0.0, 360.0, 0.1, "suffix:°") var degrees := 0.0:
	set(value):
		lay(_tail, _vector, value)
	get:
		return _degrees
## Colour of the triangle.
@export var role := Palette.Role.QUIET

var _tail := Vec2.new()
var _vector := Vec2.new()
var _degrees := 0.0


## Shows the triangle of [param of_vector], in units of the plane, turned by [param turned_degrees]
## about its tail [param at].
func lay(at: Vec2, of_vector: Vec2, turned_degrees: float) -> void:
	_tail = at.copy()
	_vector = of_vector.copy()
	_degrees = turned_degrees
	show_change()


func spanned_points() -> Array[Vec2]:
	return [_tail, _corner(), _head()]


func _draw() -> void:
	var color := Palette.color(role)
	var points: PackedVector2Array = []
	for point: Vec2 in spanned_points():
		points.append(board.to_screen(point))
	draw_primitive(points, [Color(color, 0.12)], [])
	_draw_side("x", points[0], points[1], points[2], color)
	_draw_side("y", points[1], points[2], points[0], color)


# A side of length 0 has no name.
func _draw_side(text: String, from: Vector2, to: Vector2, opposite: Vector2, color: Color) -> void:
	if from.distance_to(to) < 8.0:
		return
	draw_strokes(from, to, color, 2.5)
	var outwards := from.direction_to(to).orthogonal()
	if outwards.dot(opposite - from) > 0.0:
		outwards = -outwards
	draw_text(text, (from + to) / 2.0 + outwards * 16.0, color, 18)


func _corner() -> Vec2:
	return _turned(Vec2.new(_vector.x, 0.0))


func _head() -> Vec2:
	return _turned(_vector)


func _turned(from_tail: Vec2) -> Vec2:
	var turned := from_tail.copy()
	turned.rotate_degrees(_degrees)
	return _tail.plus(turned)
