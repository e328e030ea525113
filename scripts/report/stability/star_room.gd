class_name StarRoom
extends RefCounted
## A closed room of 14 segments in the form of a star, with corners that stick into it.

const _CORNERS := 14
# Every other corner is near the middle.
const _FAR := 300.0
const _NEAR := 170.0

## Its sides, from corner to corner.
var sides: Array[LineSegment] = []

# x and y of the corners, the first one once more at the end.
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


## How far a point is from the nearest side, in pixels; negative outside of the room. A point that
## is not finite gives no number above 0. Plain numbers: it is asked a million times.
func depth_of(x: float, y: float) -> float:
	var nearest := INF
	# A ray to the right meets the sides an odd number of times from inside.
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
