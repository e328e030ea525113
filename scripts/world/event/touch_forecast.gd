class_name TouchForecast
extends BallFlights
## When a ball in flight next touches a wall or a segment, as if there were no other balls: worked
## out once when the flight begins.

## What a ball can touch that is no segment; segments count from 0.
enum { LEFT_WALL = -5, RIGHT_WALL = -4, TOP_WALL = -3, BOTTOM_WALL = -2 }

## What ends a flight: the ball touches a surface or another ball, has to look again, slides off the
## end of what supports it, or has followed a piece of a round cap.
enum { TOUCH, MEET, LOOK_AGAIN, SLIDE_OFF, FOLLOW_CAP }

var _has_walls := false
var _left_x := 0.0
var _top_y := 0.0
var _right_x := 0.0
var _bottom_y := 0.0
var _segments: SegmentScan = SegmentGrid.new()

# The next touch of each ball if there were no others.
var _touch_time: PackedFloat64Array = []
var _touch_low: PackedFloat64Array = []
var _touch_kind: PackedInt32Array = []
var _touched: PackedInt32Array = []
var _touched_feature: PackedInt32Array = []
# The surface on which a ball lies or slides.
var _support: PackedInt32Array = []
# The round end over which it slides, or Feature.LINE, and for how long the present piece lasts.
var _rolled_end: PackedInt32Array = []
var _piece: PackedFloat64Array = []
# The surface that a ball has just left, and, under a pull, how fast along its normal: INF where it
# never comes back to it.
var _left_surface: PackedInt32Array = []
var _left_speed: PackedFloat64Array = []
var _accelerated := AcceleratedImpactFinder.new()
# What the search under a pull has found so far.
var _seconds := INF
var _surface := NOTHING
var _kind: int = TOUCH
# The normal of a surface, towards a ball.
var _normal_x := 0.0
var _normal_y := 0.0


# The next touch of a wall or a segment.
func _forecast_touch(index: int) -> void:
	if _pull_x[index] != 0.0 or _pull_y[index] != 0.0 or _support[index] >= 0:
		_forecast_accelerated_touch(index)
		return
	var x := _x[index]
	var y := _y[index]
	var velocity_x := _velocity_x[index]
	var velocity_y := _velocity_y[index]
	var radius := _radius[index]
	var seconds := INF
	var surface := NOTHING
	if _has_walls:
		if velocity_x > 0.0:
			seconds = maxf((_right_x - radius - x) / velocity_x, 0.0)
			surface = RIGHT_WALL
		elif velocity_x < 0.0:
			seconds = maxf((_left_x + radius - x) / velocity_x, 0.0)
			surface = LEFT_WALL
		if velocity_y > 0.0:
			var to_wall := maxf((_bottom_y - radius - y) / velocity_y, 0.0)
			if to_wall < seconds:
				seconds = to_wall
				surface = BOTTOM_WALL
		elif velocity_y < 0.0:
			var to_wall := maxf((_top_y + radius - y) / velocity_y, 0.0)
			if to_wall < seconds:
				seconds = to_wall
				surface = TOP_WALL
	if _segments.size() > 0:
		# A segment is convex: in straight flight a ball never comes back to the one it has left.
		var left := _left_surface[index]
		if _segments.first_impact(x, y, velocity_x, velocity_y, radius, seconds, left):
			seconds = _segments.time
			surface = _segments.index
			_touched_feature[index] = _segments.feature
	_note_touch(index, seconds, surface, TOUCH)


# Stores the touch after so many seconds of flight, as a sum of two numbers (two-sum), the second
# one smaller than the last place of the first, so that times can be compared.
func _note_touch(index: int, seconds: float, surface: int, kind: int) -> void:
	var start := _start[index]
	var sum := start + seconds
	_touch_time[index] = sum
	_touch_low[index] = 0.0
	if seconds < INF:
		var part := sum - start
		var low := (start - (sum - part)) + (seconds - part) + _start_low[index]
		_touch_time[index] = sum + low
		_touch_low[index] = low - (sum + low - sum)
	_touch_kind[index] = kind
	_touched[index] = surface


# The next touch under a constant pull: the wall or segment that a ball has just left it meets again
# after a time that its normal speed alone tells; the others are searched.
func _forecast_accelerated_touch(index: int) -> void:
	_seconds = INF
	_surface = NOTHING
	_kind = TOUCH
	if _support[index] >= 0:
		if _rolled_end[index] == Impact.Feature.LINE:
			_forecast_slide(index, _support[index])
		else:
			_take(_piece[index], _support[index], FOLLOW_CAP)
	if _has_walls:
		for wall: int in [RIGHT_WALL, LEFT_WALL, BOTTOM_WALL, TOP_WALL]:
			_forecast_wall(index, wall)
	if _segments.size() > 0:
		var skipped := _support[index]
		if _left_surface[index] >= 0:
			skipped = _left_surface[index]
			if _left_speed[index] < INF:
				_forecast_return(index, skipped)
		if _segments.first_accelerated_impact(
			_x[index],
			_y[index],
			_velocity_x[index],
			_velocity_y[index],
			_pull_x[index],
			_pull_y[index],
			_radius[index],
			_seconds,
			skipped
		):
			_take(_segments.time, _segments.index, TOUCH)
			_touched_feature[index] = _segments.feature
	_note_touch(index, _seconds, _surface, _kind)


func _take(seconds: float, surface: int, kind: int) -> void:
	_seconds = seconds
	_surface = surface
	_kind = kind


func _forecast_wall(index: int, wall: int) -> void:
	var radius := _radius[index]
	var height := 0.0
	var speed := _velocity_x[index]
	var pull := _pull_x[index]
	match wall:
		LEFT_WALL:
			height = _x[index] - radius - _left_x
		RIGHT_WALL:
			height = _right_x - radius - _x[index]
		TOP_WALL:
			height = _y[index] - radius - _top_y
		BOTTOM_WALL:
			height = _bottom_y - radius - _y[index]
	if wall == TOP_WALL or wall == BOTTOM_WALL:
		speed = _velocity_y[index]
		pull = _pull_y[index]
	if wall == RIGHT_WALL or wall == BOTTOM_WALL:
		speed = -speed
		pull = -pull
	if wall == _support[index]:
		return
	if wall == _left_surface[index]:
		height = 0.0
		speed = _left_speed[index]
	var seconds := FreeFlight.time_to_fall(height, speed, pull)
	if seconds < _seconds:
		_take(seconds, wall, TOUCH)


# Back to the segment that was left: on its line after 2 v / g, or on one of its ends.
func _forecast_return(index: int, place: int) -> void:
	_find_normal(index, place)
	var pull := _pull_x[index] * _normal_x + _pull_y[index] * _normal_y
	var seconds := FreeFlight.time_to_fall(0.0, _left_speed[index], pull)
	if seconds < _seconds:
		var share := _segments.share_of(
			place,
			_x[index] + (_velocity_x[index] + 0.5 * _pull_x[index] * seconds) * seconds,
			_y[index] + (_velocity_y[index] + 0.5 * _pull_y[index] * seconds) * seconds
		)
		if share >= 0.0 and share <= 1.0:
			_touched_feature[index] = Impact.Feature.LINE
			_take(seconds, place, TOUCH)
			return
	_forecast_ends(index, place)


# The round ends of a segment, without its line.
func _forecast_ends(index: int, place: int) -> void:
	_accelerated.set_flight(
		_x[index],
		_y[index],
		_velocity_x[index],
		_velocity_y[index],
		_pull_x[index],
		_pull_y[index],
		_radius[index]
	)
	for feature: Impact.Feature in [Impact.Feature.START, Impact.Feature.END]:
		var x := _segments.end_x(place, feature)
		var y := _segments.end_y(place, feature)
		if _accelerated.with_point(x, y, _seconds) and _accelerated.time < _seconds:
			_touched_feature[index] = feature
			_take(_accelerated.time, place, TOUCH)


# When a ball that slides on a segment comes to one of its ends.
func _forecast_slide(index: int, place: int) -> void:
	var length := _segments.length(place)
	var along_x := _segments.normal_y(place)
	var along_y := -_segments.normal_x(place)
	var from_start := _segments.share_of(place, _x[index], _y[index]) * length
	var speed := _velocity_x[index] * along_x + _velocity_y[index] * along_y
	var pull := _pull_x[index] * along_x + _pull_y[index] * along_y
	var to_start := FreeFlight.time_to_fall(maxf(from_start, 0.0), speed, pull)
	var to_end := FreeFlight.time_to_fall(maxf(length - from_start, 0.0), -speed, -pull)
	if minf(to_start, to_end) < _seconds:
		_touched_feature[index] = (
			Impact.Feature.START if to_start < to_end else Impact.Feature.END
		)
		_take(minf(to_start, to_end), place, SLIDE_OFF)


# The unit normal of a surface, towards the ball: of a segment's line on the side where the ball is.
func _find_normal(index: int, surface: int) -> void:
	_normal_x = 0.0
	_normal_y = 0.0
	match surface:
		LEFT_WALL:
			_normal_x = 1.0
		RIGHT_WALL:
			_normal_x = -1.0
		TOP_WALL:
			_normal_y = 1.0
		BOTTOM_WALL:
			_normal_y = -1.0
		_:
			_normal_x = _segments.normal_x(surface)
			_normal_y = _segments.normal_y(surface)
			var side := _segments.signed_distance(surface, _x[index], _y[index])
			if side == 0.0:
				# A centre on the line itself is stopped from the side it comes from.
				side = -(_velocity_x[index] * _normal_x + _velocity_y[index] * _normal_y)
			if side < 0.0:
				_normal_x = -_normal_x
				_normal_y = -_normal_y


func _float_arrays() -> Array[PackedFloat64Array]:
	return super() + ([_touch_time, _touch_low, _left_speed, _piece] as Array[PackedFloat64Array])


func _int_arrays() -> Array[PackedInt32Array]:
	return [_touch_kind, _touched, _touched_feature, _support, _rolled_end, _left_surface]
