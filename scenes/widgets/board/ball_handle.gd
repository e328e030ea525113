class_name BallHandle
extends Handle
## A ball as a handle: it can be taken hold of anywhere inside its rim.

# A ball is never larger on screen than this, in pixels: controls know no larger numbers.
const _LARGEST := 1e5

var _radius := 0.0


## Lies on a ball of [param radius] at [param centre], both in units of the plane; emits nothing.
func place_ball(centre: Vec2, radius: float) -> void:
	_radius = radius
	place(centre)


func covers(pixel: Vector2) -> bool:
	return _has_point(get_global_transform().affine_inverse() * pixel)


func _has_point(pixel: Vector2) -> bool:
	return pixel.distance_to(size / 2.0) <= size.x / 2.0


func _follow_view() -> void:
	var side := clampf(2.0 * _radius * _board.pixels_per_unit, TOUCH_SIZE, _LARGEST)
	size = Vector2(side, side)
	super()
