class_name TwoSurfaces
extends RefCounted
## Two surfaces between which a ball lies. Each pushes it along its normal. Where the ball spins
## in its place, friction adds a part across, and tilts both pushes to the same side.

## The second surface holds a ball that is this near to it, in pixels.
const GAP := 1e-6
## Contacts whose normals differ by less than this, in radians, count as one.
const LEAST_ANGLE := 1e-6

var _normal: Vec2
var _gravity_x: float
var _gravity_y: float


## The first surface has this unit normal, towards the ball; gravity in px/s².
func _init(normal: Vec2, gravity_x: float, gravity_y: float) -> void:
	_normal = normal
	_gravity_x = gravity_x
	_gravity_y = gravity_y


## How strongly the first surface and one that has its nearest point among [param points] push
## together, in px/s², when they hold the ball with its centre here; -1 where none can. For
## [param tilts] see [method BallSpins.tilts].
func pressure_among(
	points: Array[Vec2], centre: Vec2, radius: float, tilts: PackedFloat64Array
) -> float:
	for point in points:
		var dx := centre.x - point.x
		var dy := centre.y - point.y
		var distance := sqrt(dx * dx + dy * dy)
		if distance > radius + GAP or distance == 0.0:
			continue
		if absf(_normal.x * dy - _normal.y * dx) <= LEAST_ANGLE * distance:
			continue
		for tilt in tilts:
			var pressure := pressure_at(dx, dy, distance, tilt)
			if pressure >= 0.0:
				return pressure
	return -1.0


## How strongly both push together, in px/s², when they hold the ball against gravity; -1 where
## they cannot. (dx, dy) leads from the point where the ball touches the second surface to its
## centre, [param distance] pixels. [param tilt] is the part across as a share of the push, above 0
## to the right of a normal that points up. The normals must differ.
func pressure_at(dx: float, dy: float, distance: float, tilt: float) -> float:
	var area := _normal.x * dy - _normal.y * dx
	var one_x := _normal.x - tilt * _normal.y
	var one_y := _normal.y + tilt * _normal.x
	var other_x := dx - tilt * dy
	var other_y := dy + tilt * dx
	# The direction against gravity is one_share of the first push and other_share of the second.
	var one_share := (_gravity_y * other_x - _gravity_x * other_y) * area
	var other_share := (one_y * _gravity_x - one_x * _gravity_y) * area
	if one_share > 0.0 and other_share > 0.0:
		return (one_share + other_share * distance) / (area * area * (1.0 + tilt * tilt))
	return -1.0
