class_name SegmentScan
extends RefCounted
## Segments in packed arrays, and the first of them that a flying ball meets, found by looking at
## all. [SegmentGrid] finds the same impact by looking at those near the path.
##
## The answer is what [StraightImpact] and [AcceleratedImpact] say of each segment; most are put
## aside before by a few plain operations, which stand here once more because every prediction of
## an [EventWorld] runs through them.

## Seconds until the impact that was found.
var time := INF
## The segment that is met, or -1.
var index := -1
## What of the segment is met.
var feature := Impact.Feature.LINE

var _start_x: PackedFloat64Array = []
var _start_y: PackedFloat64Array = []
var _end_x: PackedFloat64Array = []
var _end_y: PackedFloat64Array = []
var _length: PackedFloat64Array = []
# 1 where there is a segment: a removed one leaves its place empty.
var _is_there: PackedByteArray = []

# The flight that is asked about: seconds, pixels.
var _x := 0.0
var _y := 0.0
var _velocity_x := 0.0
var _velocity_y := 0.0
var _pull_x := 0.0
var _pull_y := 0.0
var _radius := 0.0
var _skipped := -1
var _straight := StraightImpact.new()
var _accelerated := AcceleratedImpact.new()


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


## Whether a ball in straight flight meets a segment within [param horizon] seconds; the segment at
## the place [param skipped] is left out.
func first_impact(
	x: float,
	y: float,
	velocity_x: float,
	velocity_y: float,
	radius: float,
	horizon: float,
	skipped: int = -1
) -> bool:
	_ask(x, y, velocity_x, velocity_y, radius, horizon, skipped)
	for place in size():
		_try(place)
	return index >= 0


## The same under the constant acceleration [param pull_x], [param pull_y] in px/s^2.
func first_accelerated_impact(
	x: float,
	y: float,
	velocity_x: float,
	velocity_y: float,
	pull_x: float,
	pull_y: float,
	radius: float,
	horizon: float,
	skipped: int = -1
) -> bool:
	_ask(x, y, velocity_x, velocity_y, radius, horizon, skipped)
	_ask_accelerated(pull_x, pull_y)
	for place in size():
		_try_accelerated(place)
	return index >= 0


func _ask(
	x: float,
	y: float,
	velocity_x: float,
	velocity_y: float,
	radius: float,
	horizon: float,
	skipped: int
) -> void:
	_x = x
	_y = y
	_velocity_x = velocity_x
	_velocity_y = velocity_y
	_radius = radius
	_skipped = skipped
	time = horizon
	index = -1


func _ask_accelerated(pull_x: float, pull_y: float) -> void:
	_pull_x = pull_x
	_pull_y = pull_y
	_accelerated.set_flight(_x, _y, _velocity_x, _velocity_y, pull_x, pull_y, _radius)


# Takes the segment at that place if it is met before all that were tried.
func _try(place: int) -> void:
	var start_x := _start_x[place]
	var start_y := _start_y[place]
	var along_x := _end_x[place] - start_x
	var along_y := _end_y[place] - start_y
	# As in StraightImpact: distance from the line and approach to it, times the segment's length.
	var distance := along_x * (_y - start_y) - along_y * (_x - start_x)
	var approach := along_y * _velocity_x - along_x * _velocity_y
	if distance < 0.0:
		distance = -distance
		approach = -approach
	var gap := distance - _radius * _length[place]
	if gap > 0.0 and gap > approach * time:
		return
	if _is_there[place] == 0 or place == _skipped:
		return
	if not _straight.with_segment(
		_x, _y, _velocity_x, _velocity_y, _radius, start_x, start_y, _end_x[place], _end_y[place]
	):
		return
	# Of two that are met at once the one with the smaller place counts, however they are found.
	if _straight.time < time or (_straight.time == time and place < index):
		time = _straight.time
		index = place
		feature = _straight.feature


func _try_accelerated(place: int) -> void:
	var start_x := _start_x[place]
	var start_y := _start_y[place]
	var along_x := _end_x[place] - start_x
	var along_y := _end_y[place] - start_y
	var distance := along_x * (_y - start_y) - along_y * (_x - start_x)
	var approach := along_y * _velocity_x - along_x * _velocity_y
	var pull := along_y * _pull_x - along_x * _pull_y
	if distance < 0.0:
		distance = -distance
		approach = -approach
		pull = -pull
	var gap := distance - _radius * _length[place]
	# The pull counts in full only if it helps; a limit without end is no help.
	if gap > 0.0 and time < INF and gap > (approach + 0.5 * maxf(pull, 0.0) * time) * time:
		return
	if _is_there[place] == 0 or place == _skipped:
		return
	if not _accelerated.with_segment(start_x, start_y, _end_x[place], _end_y[place], time):
		return
	if _accelerated.time < time or (_accelerated.time == time and place < index):
		time = _accelerated.time
		index = place
		feature = _accelerated.feature


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


## The places of the segments that a ball at this point might touch, in their order.
func places_near(_x_now: float, _y_now: float, _ball_radius: float) -> PackedInt32Array:
	var places: PackedInt32Array = []
	for place in size():
		if _is_there[place] == 1:
			places.append(place)
	return places
