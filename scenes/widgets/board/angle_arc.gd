@tool
class_name AngleArc
extends BoardPart
## The angle between two directions: an arc with its size, a square where it is right.

# Pixels.
const _WIDTH := 2.0
const _FONT_SIZE := 17

## Where its corner is, in units of the plane.
@export var corner := Vector2.ZERO:
	get:
		return _corner.to_vector2()
	set(value):
		_corner = Vec2.from_vector2(value)
		show_change()
## The direction from which it is measured, in degrees, from the x axis to the y axis.
@export_range(-180.0, 180.0, 0.001, "suffix:°") var start_degrees := 0.0:
	get:
		return Vec2.rad_to_deg(_start)
	set(value):
		_start = Vec2.deg_to_rad(value)
		show_change()
## Its size in degrees; positive is from the x axis to the y axis.
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
## It is the angle of a vector: its size has a sign, positive from the x axis to the y axis, or is
## drawn and written from 0 to 360 degrees where that is chosen.
@export var is_signed := false
## Writes the size beyond the second direction, so far as degrees say, and not between both: there
## may be the numbers of an axis.
@export_range(0.0, 45.0, 1.0, "suffix:°") var beyond_degrees := 0.0
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


## Where the middle of the size is, in pixels of the board.
func label_pixel() -> Vector2:
	var outwards := Vector2.from_angle(_start * board.y_sign() + _value_share(_drawn_sweep()))
	# So far outside that a long text does not cross the arc, but still on the board.
	var extent := text_extent(_value_text(), _FONT_SIZE)
	var half := absf(outwards.x) * extent.x / 2.0 + absf(outwards.y) * extent.y / 2.0
	var at := board.to_screen(_corner) + outwards * (radius + maxf(26.0, half + 8.0))
	return kept_on_board(at, extent, Vector2(4.0, 0.0))


func _draw() -> void:
	var middle := board.to_screen(_corner)
	var start := _start * board.y_sign()
	var sweep := _drawn_sweep()
	var ink := Palette.color(Palette.Role.INK)
	if absf(absf(_degrees()) - 90.0) <= right_within:
		_draw_square(middle, start, sweep, ink)
	else:
		draw_arc(middle, radius, start, start + sweep, 48, ink, Palette.stroke(_WIDTH), true)
	if shows_value:
		draw_text(_value_text(), label_pixel(), ink, _FONT_SIZE)


func _degrees() -> float:
	return Conventions.in_range(sweep_degrees) if is_signed else sweep_degrees


func _drawn_sweep() -> float:
	return Vec2.deg_to_rad(_degrees()) * board.y_sign()


func _value_text() -> String:
	return label + Conventions.mark_text(_degrees() if is_signed else absf(_degrees()), 3)


# The direction in which the size stands, counted from the first one.
func _value_share(sweep: float) -> float:
	if not beyond_degrees:
		return sweep / 2.0
	return sweep + Vec2.deg_to_rad(beyond_degrees) * (signf(sweep) if sweep else -1.0)


func _draw_square(middle: Vector2, start: float, sweep: float, ink: Color) -> void:
	var side := radius * 0.45
	var along := Vector2.from_angle(start) * side
	var across := Vector2.from_angle(start + sweep) * side
	var points := PackedVector2Array([middle + along, middle + along + across, middle + across])
	draw_polyline(points, ink, Palette.stroke(_WIDTH), true)
