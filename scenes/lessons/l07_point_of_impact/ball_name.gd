@tool
class_name BallName
extends BoardPart
## The name of a ball, or of a place on its path, beside what it names.

const _FONT_SIZE := 20

## The name, such as `old`.
@export var label := "":
	set(value):
		label = value
		queue_redraw()
## Its colour, that of what it names.
@export var role := Palette.Role.INK
## The middle of what it names, in units of the plane. 32 bits; [method lay] keeps all digits.
@export var center := Vector2.ZERO:
	get:
		return _center.to_vector2()
	set(value):
		_center = Vec2.from_vector2(value)
		show_change()
## On which side of it the name is: a direction of any length above 0.
@export var direction := Vector2.ZERO:
	get:
		return _direction.to_vector2()
	set(value):
		_direction = Vec2.from_vector2(value)
		show_change()
## The radius of the ball, in units of the plane; 0 for a place.
@export_range(0.0, 1000.0, 0.001, "or_greater") var radius := 0.0:
	set(value):
		radius = value
		queue_redraw()

var _center := Vec2.new()
var _direction := Vec2.new()


## Names the ball of radius [param its_radius] at [param to], in units of the plane, on the side to
## which [param towards] points.
func lay(to: Vec2, its_radius: float, towards: Vec2) -> void:
	_center = to.copy()
	_direction = towards.normalized()
	radius = its_radius
	show_change()


func _draw() -> void:
	var middle := kept_on_board(_middle_of_text(), Vector2.ZERO, Vector2(26.0, 26.0))
	draw_text(tr(label), middle, Palette.color(role), _FONT_SIZE)


# So far beyond the rim that the text does not touch it.
func _middle_of_text() -> Vector2:
	var away := board.direction_to_screen(_direction.normalized())
	var extent := text_extent(tr(label), _FONT_SIZE)
	var half := absf(away.x) * extent.x / 2.0 + absf(away.y) * drawn_size(_FONT_SIZE) / 2.0
	var rim := maxf(radius * board.pixels_per_unit, 4.0)
	return board.to_screen(_center) + away * (rim + half + 8.0)
