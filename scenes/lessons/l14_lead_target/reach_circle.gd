@tool
class_name ReachCircle
extends BoardPart
## All places where a bullet may be some time after the shot: a circle around the shooter.

const _SIDES := 96
const _DASHES := 48
const _FONT_SIZE := 18
# In 32 bits a circle larger than this is drawn wrongly.
const _LARGEST := 1e6

## Where its center is, in units of the plane. 32 bits; [method lay] keeps all digits.
@export var center := Vector2.ZERO:
	get:
		return _center.to_vector2()
	set(value):
		lay(Vec2.from_vector2(value), radius)
## Its radius, in units of the plane.
@export_range(0.0, 1000.0, 0.001, "or_greater") var radius := 1.0:
	set(value):
		radius = value
		show_change()
## Its colour.
@export var role := Palette.Role.PROJECTION
## Thickness in pixels.
@export_range(1.0, 12.0, 0.5, "suffix:px") var width := 2.5
## Dashed: a circle that is only a measure.
@export var dashed := false
## The label below it, such as `t = 1.5 s`, as it is to be read.
@export var label := "":
	set(value):
		label = value
		queue_redraw()

var _center := Vec2.new()


## Shows a circle of radius [param its_radius] around [param middle], in units of the plane.
func lay(middle: Vec2, its_radius: float) -> void:
	_center = middle.copy()
	radius = its_radius


func spanned_points() -> Array[Vec2]:
	return [_center.minus(Vec2.new(radius, radius)), _center.plus(Vec2.new(radius, radius))]


func _draw() -> void:
	var middle := board.to_screen(_center)
	var pixels := minf(radius * board.pixels_per_unit, _LARGEST)
	var color := Palette.color(role)
	var stroke := Palette.stroke(width)
	if dashed:
		for i in _DASHES:
			var from := TAU * i / _DASHES
			draw_arc(middle, pixels, from, from + 0.5 * TAU / _DASHES, 4, color, stroke, true)
	else:
		draw_circle(middle, pixels, Color(color, 0.06), true, -1.0, true)
		draw_arc(middle, pixels, 0.0, TAU, _SIDES, color, stroke, true)
	if label:
		var extent := Vector2(text_extent(label, _FONT_SIZE).x, 0.0)
		var below := middle + Vector2(0.0, pixels + 14.0)
		var place := kept_on_board(below, extent, Vector2(8.0, 16.0))
		draw_text(label, place, color, _FONT_SIZE)
