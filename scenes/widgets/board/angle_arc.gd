@tool
class_name AngleArc
extends BoardPart
## The angle between two directions: an arc with its size in degrees, a square where it is right.

## Where its corner is, in units of the plane.
@export var corner := Vector2.ZERO:
	get:
		return _corner.to_vector2()
	set(value):
		_corner = Vec2.from_vector2(value)
		show_change()
## The direction from which it is measured, in degrees, clockwise on screen.
@export_range(-180.0, 180.0, 0.001, "suffix:°") var start_degrees := 0.0:
	get:
		return Vec2.rad_to_deg(_start)
	set(value):
		_start = Vec2.deg_to_rad(value)
		show_change()
## Its size in degrees; positive is clockwise on screen.
@export_range(-180.0, 180.0, 0.001, "suffix:°") var sweep_degrees := 0.0:
	get:
		return Vec2.rad_to_deg(_sweep)
	set(value):
		_sweep = Vec2.deg_to_rad(value)
		show_change()
## Pixels from the corner to the arc.
@export_range(10.0, 200.0, 1.0, "suffix:px") var radius := 46.0
## Writes the size beside the arc.
@export var shows_value := true
## The text before the size, such as `α = `.
@export var label := ""
## Writes the size with its sign: positive where the second direction is clockwise of the first.
@export var is_signed := false
## An angle this close to 90 degrees counts as right.
@export_range(0.0, 1.0, 0.001, "suffix:deg") var right_within := 1e-9

var _corner := Vec2.new()
var _start := 0.0
var _sweep := 0.0


## Measures from [param first] to [param second], the short way round, with the corner at
## [param at].
func measure(at: Vec2, first: Vec2, second: Vec2) -> void:
	_corner = at.copy()
	_start = first.angle_radians()
	_sweep = first.angle_to(second)
	visible = first.length() > 0.0 and second.length() > 0.0
	queue_redraw()


func _draw() -> void:
	var middle := board.to_screen(_corner)
	var start := _start * board.y_sign()
	var sweep := _sweep * board.y_sign()
	var ink := Palette.color(Palette.Role.INK)
	if absf(absf(Vec2.rad_to_deg(_sweep)) - 90.0) <= right_within:
		_draw_square(middle, start, sweep, ink)
	else:
		draw_arc(middle, radius, start, start + sweep, 48, ink, 2.0, true)
	if shows_value:
		_draw_value(middle, Vector2.from_angle(start + sweep / 2.0), ink)


# Beside the arc, so far outside that a long text does not cross it.
func _draw_value(middle: Vector2, outwards: Vector2, ink: Color) -> void:
	var text := _value_text()
	var extent := ThemeDB.fallback_font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, 17)
	var half := absf(outwards.x) * extent.x / 2.0 + absf(outwards.y) * extent.y / 2.0
	draw_text(text, middle + outwards * (radius + maxf(26.0, half + 8.0)), ink, 17)


func _value_text() -> String:
	var degrees := Vec2.rad_to_deg(_sweep)
	return label + NumberText.short(degrees if is_signed else absf(degrees), 3) + "°"


func _draw_square(middle: Vector2, start: float, sweep: float, ink: Color) -> void:
	var side := radius * 0.45
	var along := Vector2.from_angle(start) * side
	var across := Vector2.from_angle(start + sweep) * side
	var points := PackedVector2Array([middle + along, middle + along + across, middle + across])
	draw_polyline(points, ink, 2.0, true)
