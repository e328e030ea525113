class_name AngleArc
extends BoardPart
## The angle between two directions: an arc with its size in degrees, a square where it is right.

## Pixels from the corner to the arc.
@export_range(10.0, 200.0, 1.0, "suffix:px") var radius := 46.0
## Writes the size beside the arc.
@export var shows_value := true
## What stands before the size, such as `α = `.
@export var label := ""
## Writes the size with its sign: positive where the second direction is clockwise of the first.
@export var is_signed := false
## An angle this close to 90 degrees counts as right.
@export_range(0.0, 1.0, 0.001, "suffix:deg") var right_within := 1e-9

var _corner := Vec2.new()
var _start := 0.0
var _sweep := 0.0


## Measures from [param first] to [param second], the short way round, with the corner at [param
## corner].
func measure(corner: Vec2, first: Vec2, second: Vec2) -> void:
	_corner = corner.copy()
	_start = first.angle_radians()
	_sweep = first.angle_to(second)
	visible = first.length() > 0.0 and second.length() > 0.0
	queue_redraw()


func _draw() -> void:
	var corner := board.to_screen(_corner)
	var start := _start * board.y_sign()
	var sweep := _sweep * board.y_sign()
	var ink := Palette.color(Palette.Role.INK)
	if absf(absf(Vec2.rad_to_deg(_sweep)) - 90.0) <= right_within:
		_draw_square(corner, start, sweep, ink)
	else:
		draw_arc(corner, radius, start, start + sweep, 48, ink, 2.0, true)
	if shows_value:
		_draw_value(corner, Vector2.from_angle(start + sweep / 2.0), ink)


# Beside the arc, so far outside that a long text does not cross it.
func _draw_value(corner: Vector2, outwards: Vector2, ink: Color) -> void:
	var text := _value_text()
	var extent := ThemeDB.fallback_font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, 17)
	var half := absf(outwards.x) * extent.x / 2.0 + absf(outwards.y) * extent.y / 2.0
	draw_text(text, corner + outwards * (radius + maxf(26.0, half + 8.0)), ink, 17)


func _value_text() -> String:
	var degrees := Vec2.rad_to_deg(_sweep)
	return label + NumberText.short(degrees if is_signed else absf(degrees), 3) + "°"


func _draw_square(corner: Vector2, start: float, sweep: float, ink: Color) -> void:
	var side := radius * 0.45
	var along := Vector2.from_angle(start) * side
	var across := Vector2.from_angle(start + sweep) * side
	var points := PackedVector2Array([corner + along, corner + along + across, corner + across])
	draw_polyline(points, ink, 2.0, true)
