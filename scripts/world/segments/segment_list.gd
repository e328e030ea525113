class_name SegmentList
extends RefCounted
## Segments in packed arrays, each at a place of its own, and where a point is as seen from them.

## The corners of the walls around the segments, at the upper left and the lower right; none where
## there are no walls.
var corners: Array[Vec2] = []

var _start_x: PackedFloat64Array = []
var _start_y: PackedFloat64Array = []
var _end_x: PackedFloat64Array = []
var _end_y: PackedFloat64Array = []
var _length: PackedFloat64Array = []
# 1 where there is a segment: a removed one leaves its place empty.
var _is_there: PackedByteArray = []


## How many places there are, with those of removed segments.
func size() -> int:
	return _length.size()


## Whether there is a segment at that place.
func has_segment(place: int) -> bool:
	return place >= 0 and place < size() and _is_there[place] == 1


## The segment at that place.
func segment(place: int) -> LineSegment:
	return LineSegment.new(
		Vec2.new(_start_x[place], _start_y[place]), Vec2.new(_end_x[place], _end_y[place])
	)


## The length in pixels of the segment at that place.
func length(place: int) -> float:
	return _length[place]


## Puts a segment at a place; at the end where the place is [method size].
func put(place: int, new_segment: LineSegment) -> void:
	if place == size():
		for numbers: PackedFloat64Array in [_start_x, _start_y, _end_x, _end_y, _length]:
			numbers.append(0.0)
		_is_there.append(0)
	_start_x[place] = new_segment.start.x
	_start_y[place] = new_segment.start.y
	_end_x[place] = new_segment.end.x
	_end_y[place] = new_segment.end.y
	_length[place] = new_segment.length()
	_is_there[place] = 1


## Leaves the place empty.
func remove(place: int) -> void:
	_is_there[place] = 0


## x of an end of the segment at that place: its start or its end.
func end_x(place: int, of: Impact.Feature) -> float:
	return _end_x[place] if of == Impact.Feature.END else _start_x[place]


## y of an end of the segment at that place.
func end_y(place: int, of: Impact.Feature) -> float:
	return _end_y[place] if of == Impact.Feature.END else _start_y[place]


## Where the perpendicular from a point meets the segment at that place: 0 at its start, 1 at its
## end.
func share_of(place: int, x: float, y: float) -> float:
	var along_x := _end_x[place] - _start_x[place]
	var along_y := _end_y[place] - _start_y[place]
	var to_x := x - _start_x[place]
	var to_y := y - _start_y[place]
	return (along_x * to_x + along_y * to_y) / (along_x * along_x + along_y * along_y)


## The point of the segment at that place that is nearest to a point.
func nearest_point(place: int, x: float, y: float) -> Vec2:
	var share := clampf(share_of(place, x, y), 0.0, 1.0)
	return Vec2.new(
		_start_x[place] + (_end_x[place] - _start_x[place]) * share,
		_start_y[place] + (_end_y[place] - _start_y[place]) * share
	)


## What of the segment at that place is nearest to a point: its line or one of its ends.
func nearest_feature(place: int, x: float, y: float) -> Impact.Feature:
	var share := share_of(place, x, y)
	if share < 0.0:
		return Impact.Feature.START
	return Impact.Feature.END if share > 1.0 else Impact.Feature.LINE


## Distance in pixels of a point from the segment at that place, with its ends.
func distance_to_segment(place: int, x: float, y: float) -> float:
	return nearest_point(place, x, y).distance_to(Vec2.new(x, y))


## Distance in pixels of a point from the line of the segment at that place, positive on the side of
## its normal.
func signed_distance(place: int, x: float, y: float) -> float:
	var along_x := _end_x[place] - _start_x[place]
	var along_y := _end_y[place] - _start_y[place]
	return (along_x * (y - _start_y[place]) - along_y * (x - _start_x[place])) / _length[place]


## x of the unit normal of the segment at that place.
func normal_x(place: int) -> float:
	return (_start_y[place] - _end_y[place]) / _length[place]


## y of the unit normal of the segment at that place.
func normal_y(place: int) -> float:
	return (_end_x[place] - _start_x[place]) / _length[place]


## The places of the segments that are no farther than [param reach] pixels from a point, in their
## order.
func places_within(x: float, y: float, reach: float) -> PackedInt32Array:
	var places: PackedInt32Array = []
	for place in size():
		if _is_there[place] == 1:
			if maxf(_start_x[place], _end_x[place]) >= x - reach:
				if minf(_start_x[place], _end_x[place]) <= x + reach:
					if distance_to_segment(place, x, y) <= reach:
						places.append(place)
	return places


## The nearest points of the walls.
func wall_points(x: float, y: float) -> Array[Vec2]:
	if corners.is_empty():
		return []
	var points: Array[Vec2] = [Vec2.new(corners[0].x, y), Vec2.new(corners[1].x, y)]
	points.append_array([Vec2.new(x, corners[0].y), Vec2.new(x, corners[1].y)])
	return points


## The nearest points of the walls and of the segments that a ball at this point might touch.
func points_near(x: float, y: float, ball_radius: float) -> Array[Vec2]:
	var points := wall_points(x, y)
	for place in places_near(x, y, ball_radius):
		points.append(nearest_point(place, x, y))
	return points


## The places of the segments that a ball at this point might touch, in their order.
func places_near(_x_now: float, _y_now: float, _ball_radius: float) -> PackedInt32Array:
	var places: PackedInt32Array = []
	for place in size():
		if _is_there[place] == 1:
			places.append(place)
	return places
