class_name StarRoom
extends RefCounted
## A closed room of 14 segments in the form of a star, with corners that point inwards.

const _CORNERS := 14
# The distances of the corners from the middle in pixels, in turn.
const _FAR := 300.0
const _NEAR := 170.0

## Its sides, from corner to corner.
var sides: Array[LineSegment] = []

# The x and y of the corners; the first corner is repeated at the end.
var _x: PackedFloat64Array = []
var _y: PackedFloat64Array = []


func _init() -> void:
	for corner in _CORNERS + 1:
		var distance := _FAR if corner % 2 == 0 else _NEAR
		var place := Vec2.unit_radians(TAU * (corner % _CORNERS) / _CORNERS).scaled(distance)
		_x.append(place.x)
		_y.append(place.y)
	for side in _CORNERS:
		sides.append(
			LineSegment.new(Vec2.new(_x[side], _y[side]), Vec2.new(_x[side + 1], _y[side + 1]))
		)


## The distance of a point from the nearest side in pixels; negative outside the room. For a point
## that is not finite it is not above 0. The arguments are plain numbers, because it is called a
## million times.
func depth_of(x: float, y: float) -> float:
	var nearest := INF
	# From inside, a ray to the right crosses the sides an odd number of times.
	var is_inside := false
	for side in _CORNERS:
		var along_x := _x[side + 1] - _x[side]
		var along_y := _y[side + 1] - _y[side]
		var to_x := x - _x[side]
		var to_y := y - _y[side]
		var share := (to_x * along_x + to_y * along_y) / (along_x * along_x + along_y * along_y)
		share = clampf(share, 0.0, 1.0)
		var off_x := to_x - along_x * share
		var off_y := to_y - along_y * share
		var squared := off_x * off_x + off_y * off_y
		if squared < nearest:
			nearest = squared
		if (to_y < 0.0) != (to_y < along_y):
			if to_x < along_x * to_y / along_y:
				is_inside = not is_inside
	return sqrt(nearest) if is_inside else -sqrt(nearest)
