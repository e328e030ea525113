@tool
class_name FlightPath
extends BoardPart
## The way of a shot or of a target: a line through places, solid or dashed, with a dot after each
## equal piece of time.

const _DOT := 3.5

## The places through which the way goes, in units of the plane. 32 bits; [method show_path] keeps
## all digits.
@export var places: PackedVector2Array:
	get:
		return _in_32_bits(_places)
	set(value):
		_places = _of_32_bits(value)
		show_change()
## The places after equal pieces of time.
@export var ticks: PackedVector2Array:
	get:
		return _in_32_bits(_ticks)
	set(value):
		_ticks = _of_32_bits(value)
		show_change()
## Colour of line and dots.
@export var role := Palette.Role.PROJECTION
## Thickness in pixels.
@export_range(1.0, 12.0, 0.5, "suffix:px") var width := 2.5
## Dashed: the way of a wrong shot, or one that is only expected.
@export var dashed := false

var _places: Array[Vec2] = []
var _ticks: Array[Vec2] = []


## Shows a way through [param through], with dots at [param after_equal_times]; nothing for empty
## lists.
func show_path(through: Array[Vec2], after_equal_times: Array[Vec2] = []) -> void:
	_places = through
	_ticks = after_equal_times
	show_change()


## Where something is every [param step] seconds until [param last] seconds, from 0 on:
## [code]place.call(seconds)[/code] says where. For the dots, and with a small step for a way that
## is curved. At most [param most] places.
static func places_every(step: float, last: float, place: Callable, most: int = 400) -> Array[Vec2]:
	var found: Array[Vec2] = []
	for i in most:
		# What rounding leaves of the last step counts.
		if not i * step <= last * (1.0 + 1e-12):
			break
		found.append(place.call(i * step))
	return found


func spanned_points() -> Array[Vec2]:
	return _places


func _draw() -> void:
	var color := Palette.color(role)
	if dashed:
		draw_way_of_strokes(_places, color, width)
	else:
		for i in range(1, _places.size()):
			var from := board.to_screen(_places[i - 1])
			var to := board.to_screen(_places[i])
			draw_line(from, to, color, Palette.stroke(width), true)
	for tick in _ticks:
		draw_circle(board.to_screen(tick), _DOT, color, true, -1.0, true)


static func _in_32_bits(points: Array[Vec2]) -> PackedVector2Array:
	return PackedVector2Array(points.map(func(point: Vec2) -> Vector2: return point.to_vector2()))


static func _of_32_bits(points: PackedVector2Array) -> Array[Vec2]:
	var found: Array[Vec2] = []
	found.assign(Array(points).map(Vec2.from_vector2))
	return found
