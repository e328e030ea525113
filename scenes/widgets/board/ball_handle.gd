@tool
class_name BallHandle
extends Handle
## A ball as a handle: it can be taken hold of anywhere inside its rim.

# A ball is never larger on screen than this, in pixels: controls cannot be larger.
const _LARGEST := 1e5

## Radius of the ball that it lies on, in units of the plane.
@export_range(0.0, 1000.0, 0.001, "or_greater") var radius := 0.0


## Lies on a ball of radius [param its_radius] at [param center], both in units of the plane; emits
## nothing.
func place_ball(center: Vec2, its_radius: float) -> void:
	radius = its_radius
	place(center)


func covers(pixel: Vector2) -> bool:
	return _has_point(get_global_transform().affine_inverse() * pixel)


func _has_point(pixel: Vector2) -> bool:
	return pixel.distance_to(size / 2.0) <= size.x / 2.0


func _follow_view() -> void:
	if Engine.is_editor_hint():
		return
	var side := clampf(2.0 * radius * _board.pixels_per_unit, TOUCH_SIZE, _LARGEST)
	size = Vector2(side, side)
	super()
