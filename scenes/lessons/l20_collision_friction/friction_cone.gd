@tool
class_name FrictionCone
extends BoardPart
## The friction cone: all impulses that friction and the push together can be, from the contact on.
## Its edges lean from the normal by µ.

const _WIDTH := 2.5
const _FONT_SIZE := 18
# The name of the edge is so many pixels beyond its end.
const _BEYOND := 16.0

## The direction of its axis, of length 1.
@export var axis := Vector2(0.0, -1.0)
## How far its edges lean: the tangent of the angle.
@export var friction := 0.0
## The length of its edges, in units of the plane.
@export var reach := 0.0


## Shows the cone around [param normal], of length 1, whose edges lean by [param mu] and are
## [param its_reach] long.
func show_cone(normal: Vec2, mu: float, its_reach: float) -> void:
	axis = normal.to_vector2()
	friction = mu
	reach = its_reach
	show_change()


## Where its edge on the side [param side] ends: 1.0 along the tangent, -1.0 against it.
func edge(side: float) -> Vec2:
	var normal := Vec2.from_vector2(axis)
	var tangent := Vec2.new(-normal.y, normal.x)
	return normal.plus(tangent.scaled(side * friction)).normalized().scaled(reach)


func spanned_points() -> Array[Vec2]:
	return [Vec2.new(), edge(1.0), edge(-1.0)]


func _draw() -> void:
	var color := Palette.color(Palette.Role.REST)
	var apex := board.to_screen(Vec2.new())
	var ends: PackedVector2Array = [board.to_screen(edge(-1.0)), board.to_screen(edge(1.0))]
	if apex.distance_to(ends[0]) < 1.0:
		return
	draw_primitive([apex, ends[0], ends[1]], [Color(color, 0.13)], [])
	for end in ends:
		draw_strokes(apex, end, color, _WIDTH)
	var name_of_edge := "µ = %s" % NumberText.short(friction)
	var outwards := board.direction_to_screen(Vec2.from_vector2(axis).normal())
	var extent := text_extent(name_of_edge, _FONT_SIZE)
	var beside := absf(outwards.x) * extent.x / 2.0 + absf(outwards.y) * extent.y / 2.0
	draw_text(name_of_edge, ends[1] + outwards * (beside + _BEYOND), color, _FONT_SIZE)
