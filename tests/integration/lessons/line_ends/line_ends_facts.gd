extends RefCounted
## What becomes of the shot of the lesson on line ends, by plain formulas, for its judge.
##
## It finds the touch on the segment with round caps without a quadratic: along the way the distance
## from a segment first falls, then rises, so the touch can be searched for by halves.

# What a sum of doubles may be off by, as a share of its terms.
const _ROUNDING := 1e-13
const _HALVES := 50

## The number of the mistake; 0 for none.
var mistake: int
## The ball's centre at the beginning.
var start: Vector2D
## The motion of the frame.
var motion: Vector2D
## The ball's radius.
var radius: float
## The end A of the line.
var from: Vector2D
## Of the start from the infinite line, never below 0.
var distance: float
## How far the frame takes the ball towards the line.
var approach: float
## Of the touch with the infinite line, before it is kept within the frame.
var line_time: float
## The time of the touch on the segment with round caps; NAN for none.
var touch: float
## Something is so near its limit that rounding decides: words of fields are not judged then.
var is_close_call: bool

var _to: Vector2D
# What a place may be off by.
var _off: float
# The unit vector along the line, and the one across it to the side of the ball.
var _along: Vector2D
var _across: Vector2D
# The distance with its sign.
var _signed: float
# Where the ball touches along the line: 0 at A, 1 at B; the infinite one, and the segment.
var _share: float
var _touch_share: float
# How near the ball comes to the segment.
var _nearest: float


## Two numbers, as no core has them.
class Vector2D:
	extends RefCounted
	var x: float
	var y: float

	func _init(with_x: float, with_y: float) -> void:
		x = with_x
		y = with_y

	func plus(other: Vector2D, times: float = 1.0) -> Vector2D:
		return Vector2D.new(x + times * other.x, y + times * other.y)

	func minus(other: Vector2D) -> Vector2D:
		return plus(other, -1.0)

	func dot(other: Vector2D) -> float:
		return x * other.x + y * other.y

	func size() -> float:
		return sqrt(x * x + y * y)


## Works out everything from a link state.
func take(state: Dictionary) -> void:
	var shot: PackedFloat64Array = state["shot"]
	var line: PackedFloat64Array = state["line"]
	mistake = state["mistake"]
	start = Vector2D.new(shot[0], shot[1])
	motion = Vector2D.new(shot[2], shot[3])
	radius = shot[4]
	from = Vector2D.new(line[0], line[1])
	_to = Vector2D.new(line[2], line[3])
	_off = radius + start.size() + motion.size() + from.size() + _to.size()
	_off *= _ROUNDING
	_take_line()
	_take_touch()
	is_close_call = _is_near_a_limit()


func _take_line() -> void:
	var way := _to.minus(from)
	_along = Vector2D.new(way.x / way.size(), way.y / way.size())
	_across = Vector2D.new(-_along.y, _along.x)
	_signed = start.minus(from).dot(_across)
	if _signed < 0.0:
		_across = Vector2D.new(_along.y, -_along.x)
	distance = absf(_signed)
	approach = -motion.dot(_across)
	line_time = (distance - radius) / approach if approach > 0.0 else NAN
	_share = _share_at(maxf(line_time, 0.0)) if approach > 0.0 else NAN


func _at(time: float) -> Vector2D:
	return start.plus(motion, time)


func _share_at(time: float) -> float:
	return _at(time).minus(from).dot(_along) / _length()


func _length() -> float:
	return _to.minus(from).size()


func _nearest_point(time: float) -> Vector2D:
	return from.plus(_to.minus(from), clampf(_share_at(time), 0.0, 1.0))


func _distance_at(time: float) -> float:
	return _at(time).minus(_nearest_point(time)).size()


func _take_touch() -> void:
	var nearest_time := _time_of_nearest()
	_nearest = _distance_at(nearest_time)
	touch = NAN
	if _distance_at(0.0) <= radius:
		if start.minus(_nearest_point(0.0)).dot(motion) < 0.0:
			touch = 0.0
	elif _nearest < radius:
		touch = _time_of_radius(nearest_time)
	_touch_share = _share_at(touch)


# Before it the ball approaches the nearest point, then it moves away.
func _time_of_nearest() -> float:
	var early := 0.0
	var late := 1.0
	for i in _HALVES:
		var middle := (early + late) / 2.0
		if _at(middle).minus(_nearest_point(middle)).dot(motion) < 0.0:
			early = middle
		else:
			late = middle
	return late


func _time_of_radius(latest: float) -> float:
	var early := 0.0
	var late := latest
	for i in _HALVES:
		var middle := (early + late) / 2.0
		if _distance_at(middle) > radius:
			early = middle
		else:
			late = middle
	return late


func _is_near_a_limit() -> bool:
	var share_off := 1e-7 + _off / _length()
	var time_off := 1e-7
	var speed_off := 1e-9 * motion.size()
	var nearest_off := _off + 1e-9 * radius
	for pair_of_limits: Array in [
		[_signed, 0.0, _off],
		[distance, radius, _off],
		[approach, 0.0, speed_off if approach != 0.0 else -1.0],
		[line_time, 1.0, time_off],
		[_share, 0.0, share_off],
		[_share, 1.0, share_off],
		[_touch_share, 0.0, share_off],
		[_touch_share, 1.0, share_off],
		[touch, 1.0, time_off],
		[_nearest, radius, nearest_off],
		[_distance_at(0.0), radius, _off],
		[start.minus(_nearest_point(0.0)).dot(motion), 0.0, _off * motion.size()],
	]:
		var value: float = pair_of_limits[0]
		var limit: float = pair_of_limits[1]
		var off: float = pair_of_limits[2]
		if absf(value - limit) <= off:
			return true
	return false


## Whether the ball moves at all.
func moves() -> bool:
	return motion.size() > 0.0


## Whether it touches the infinite line in this frame.
func hits_line() -> bool:
	return approach > 0.0 and maxf(line_time, 0.0) <= 1.0


## Whether it is then beside the segment.
func is_beside() -> bool:
	return _share >= 0.0 and _share <= 1.0


## Whether it starts on the good side.
func is_in_front() -> bool:
	return _signed >= 0.0


## Whether it touches the segment with round caps.
func hits_capsule() -> bool:
	return not is_nan(touch)


## Whether it touches one of the ends.
func hits_end() -> bool:
	return hits_capsule() and not (_touch_share >= 0.0 and _touch_share <= 1.0)


## The end that is touched; else the one to which the ball comes nearer.
func end() -> Vector2D:
	if hits_end():
		return from if _touch_share < 0.0 else _to
	return from if _clearance(from) <= _clearance(_to) else _to


func _clearance(point: Vector2D) -> float:
	var squared := motion.dot(motion)
	var time := clampf(point.minus(start).dot(motion) / squared, 0.0, 1.0) if squared else 0.0
	return _at(time).minus(point).size()


## Whether rounding decides which end is met, or whether mistake 22 sees the ball beside the line.
func can_be_either_end() -> bool:
	var new_share := _share_at(1.0)
	var is_near_end := minf(absf(new_share), absf(new_share - 1.0)) < 1e-7 + _off / _length()
	if mistake == 22 and is_near_end:
		return true
	return is_close_call or absf(_clearance(from) - _clearance(_to)) <= _off + 1e-9 * radius


## Whether this kind of line finds a touch.
func touches(field: int) -> bool:
	match field:
		0:
			return hits_line() and is_in_front()
		1:
			return hits_line()
		2:
			return hits_line() and is_beside() and is_in_front()
		3:
			return hits_line() and is_beside()
	return hits_capsule()


## When it touches in a field that has a touch.
func time_in(field: int) -> float:
	return touch if field == 4 else maxf(line_time, 0.0)


## Where the ball is at the end of the frame in a field.
func end_of_field(field: int) -> Vector2D:
	if not touches(field):
		return _at(1.0)
	if field == 4:
		return _bounced(touch, _at(touch).minus(_nearest_point(touch)))
	return _bounced(maxf(line_time, 0.0), _across)


# Where it is after a bounce at a time, off what lies against this direction.
func _bounced(time: float, towards: Vector2D) -> Vector2D:
	if time > 1.0:
		return _at(1.0)
	var normal := Vector2D.new(towards.x / towards.size(), towards.y / towards.size())
	var after := motion.plus(normal, -2.0 * motion.dot(normal))
	return _at(time).plus(after, 1.0 - time)


## Whether a place is another one than where the ball really is after the frame.
func differs(place: Vector2D) -> bool:
	return place.minus(end_of_field(4)).size() > 1e-7


## The time at which the mistake has a touch: NAN where it has a root of less than 0, INF for none.
func wrong_time() -> float:
	match mistake:
		22:
			if _takes_line():
				return maxf(line_time, 0.0)
			return INF if hits_capsule() and not hits_end() else _right_time()
		23:
			return maxf(line_time, 0.0) if hits_line() else INF
	return _wrong_time_at_end()


# Of the mistakes that are made with the quadratic.
func _wrong_time_at_end() -> float:
	var difference := start.minus(end())
	var b := 2.0 * difference.dot(motion)
	if hits_capsule() and not hits_end() or b >= 0.0:
		return _right_time()
	var a := motion.dot(motion)
	var discriminant := b * b - 4.0 * a * (difference.dot(difference) - radius * radius)
	match mistake:
		18:
			return (-b - discriminant * discriminant) / (2.0 * a)
		19:
			return NAN if discriminant < 0.0 else _right_time()
	return (-b - sqrt(discriminant)) / (2.0 * a) - 1.0 if hits_end() else _right_time()


# Whether the mistake has the ball bounce on the line as if that had no ends.
func _takes_line() -> bool:
	var new_share := _share_at(1.0)
	var is_taken := mistake == 22 and new_share >= 0.0 and new_share <= 1.0
	return hits_line() and (is_taken or mistake == 23)


func _right_time() -> float:
	return touch if hits_capsule() else INF


## Where the ball of the mistake is after the frame.
func wrong_end() -> Vector2D:
	var time := wrong_time()
	if time == INF or is_nan(time):
		return _at(1.0)
	if _takes_line():
		return _bounced(time, _across)
	if time == touch:
		return end_of_field(4)
	return _bounced(time, _at(time).minus(end()))


## Whether it overlaps the segment and moves away from it.
func overlaps_and_leaves() -> bool:
	return _distance_at(0.0) <= radius and not hits_capsule()


## Of the touch on the end alone, as if there were no line; NAN for none.
func time_at_end() -> float:
	var difference := start.minus(end())
	var a := motion.dot(motion)
	var b := difference.dot(motion)
	var c := difference.dot(difference) - radius * radius
	if b >= 0.0:
		return NAN
	if c <= 0.0:
		return 0.0
	if b * b <= a * c:
		return NAN
	var time := c / (-b + sqrt(b * b - a * c))
	return time if time <= 1.0 else NAN
