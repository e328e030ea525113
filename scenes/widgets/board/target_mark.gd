@tool
class_name TargetMark
extends BoardPart
## What is shot at: a disc with a cross hair, in its true size. A [BallHandle] on it makes it
## draggable.

# A target that is a point, or a very small one, is drawn so large, in pixels.
const _SMALLEST := 5.0
# In 32 bits a circle larger than this is drawn wrongly.
const _LARGEST := 1e6
# The cross hair reaches so far beyond the rim, in pixels.
const _BEYOND := 7.0
const _FONT_SIZE := 18
const _DASHES := 16

## Where its center is, in units of the plane. 32 bits; [method lay] keeps all digits.
@export var center := Vector2.ZERO:
	get:
		return _center.to_vector2()
	set(value):
		lay(Vec2.from_vector2(value), radius)
## Its radius, in units of the plane; 0 for a point.
@export_range(0.0, 1000.0, 0.001, "or_greater") var radius := 0.0:
	set(value):
		radius = value
		show_change()
## Colour of the target.
@export var role := Palette.Role.B
## The label above it, such as `target`.
@export var label := "":
	set(value):
		label = value
		queue_redraw()
## Only the outline, dashed: a place where the target will be, or was.
@export var is_ghost := false

var _center := Vec2.new()


## Shows a target of radius [param its_radius] with its center at [param to], in units of the plane.
func lay(to: Vec2, its_radius: float) -> void:
	_center = to.copy()
	radius = its_radius


## Where its center is, in units of the plane.
func at() -> Vec2:
	return _center.copy()


## Where the middle of its label is, in the board's pixels.
func label_pixel() -> Vector2:
	var above := Vector2(0.0, -_pixels() - _BEYOND - drawn_size(_FONT_SIZE) * 0.6)
	var extent := Vector2(text_extent(tr(label), _FONT_SIZE).x, 0.0)
	return kept_on_board(board.to_screen(_center) + above, extent, Vector2(8.0, 14.0))


# Its radius as it is drawn.
func _pixels() -> float:
	return clampf(radius * board.pixels_per_unit, _SMALLEST, _LARGEST)


func spanned_points() -> Array[Vec2]:
	return [_center.minus(Vec2.new(radius, radius)), _center.plus(Vec2.new(radius, radius))]


func _draw() -> void:
	var middle := board.to_screen(_center)
	var pixels := _pixels()
	var color := Palette.color(role)
	if is_ghost:
		for i in _DASHES:
			var from := TAU * i / _DASHES
			draw_arc(middle, pixels, from, from + 0.55 * TAU / _DASHES, 6, color, 2.0, true)
	else:
		draw_circle(middle, pixels, Color(color, 0.22), true, -1.0, true)
		draw_circle(middle, pixels, color, false, Palette.stroke(2.5), true)
	for axis: Vector2 in [Vector2.RIGHT, Vector2.DOWN]:
		var reach := axis * (pixels + _BEYOND)
		draw_line(middle - reach, middle + reach, color, Palette.stroke(1.5), true)
	if label:
		draw_text(tr(label), label_pixel(), color, _FONT_SIZE)
