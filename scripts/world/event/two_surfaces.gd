class_name TwoSurfaces
extends RefCounted
## Two surfaces between which a ball lies. Each pushes it along its normal. Where the ball spins
## in its place, friction adds a part across, and tilts both pushes to the same side.


## How strongly both push together, in px/s², when they hold the ball against gravity; -1 where
## they cannot. The first normal has length 1; (dx, dy) leads from the point where the ball touches
## the second surface to its centre, [param distance] pixels. [param tilt] is the part across as a
## share of the push, above 0 to the right of a normal that points up. The normals must differ.
static func pressure(
	normal_x: float,
	normal_y: float,
	dx: float,
	dy: float,
	distance: float,
	gravity_x: float,
	gravity_y: float,
	tilt: float
) -> float:
	var area := normal_x * dy - normal_y * dx
	var one_x := normal_x - tilt * normal_y
	var one_y := normal_y + tilt * normal_x
	var other_x := dx - tilt * dy
	var other_y := dy + tilt * dx
	# The direction against gravity is one_share of the first push and other_share of the second.
	var one_share := (gravity_y * other_x - gravity_x * other_y) * area
	var other_share := (one_y * gravity_x - one_x * gravity_y) * area
	if one_share > 0.0 and other_share > 0.0:
		return (one_share + other_share * distance) / (area * area * (1.0 + tilt * tilt))
	return -1.0
