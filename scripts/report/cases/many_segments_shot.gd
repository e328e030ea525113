class_name ManySegmentsShot
extends Shot
## One ball among so many segments that a method should not examine them all. The box grows with
## their number, so that the ball always has the same number around it.

# The side of the square that each segment has for itself, so that none meets another. In pixels.
const _SQUARE := 80.0
const _LENGTH := 40.0
# The largest distance in x and y between a segment's middle and that of its square, in pixels.
const _PLAY := 12.0
# The ball's radius in pixels; it fits between the segments of neighbouring squares.
const _RADIUS := 6.0
const _SPEED := 300.0

var _count: int
var _segments: Array[LineSegment] = []


## A box with [param count] segments, its four walls included: 4, or 4 times a power of 4.
func _init(count: int) -> void:
	problem = "many_segments"
	situation = situation_of(count)
	goes_on = true
	path_seconds = 2.0
	ball = Ball.new(Vec2.new(), _RADIUS, Vec2.unit_radians(0.7).scaled(_SPEED))
	_count = count


## See [method Shot.segments].
func segments() -> Array[LineSegment]:
	if _segments.is_empty():
		_make_segments(roundi(sqrt(_count)))
	return _segments


## The name of the situation in tables.
static func situation_of(count: int) -> String:
	return "%d segments" % count


## See [method Shot.judge]: the error is the distance from the exact position at the end of the
## path.
func judge(case: MeasuredCase, _end: Vec2, path: PackedFloat64Array) -> void:
	var exact := ExactPath.new()
	case.keep_refusal(exact.start(ball, _near()))
	case.keep_refusal(exact.advance_to(path_seconds))
	if case.refusal:
		return
	case.error = exact.position().distance_to(Vec2.new(path[-2], path[-1]))
	case.figures["bounces"] = exact.bounces()
	case.note = "after %d bounces" % exact.bounces()


# The segments that the ball can reach within the path.
func _near() -> Array[LineSegment]:
	var reach := _SPEED * path_seconds + _RADIUS
	return segments().filter(
		func(segment: LineSegment) -> bool:
			return segment.closest_point(ball.position).distance_to(ball.position) <= reach
	)


func _make_segments(squares: int) -> void:
	var half := squares * _SQUARE / 2.0
	_add_walls(half)
	var rng := RandomNumberGenerator.new()
	rng.seed = 4
	for square in _count:
		# The four walls replace the segments in the corners.
		if not _is_corner(square, squares):
			var middle := Vec2.new(_SQUARE * (square % squares + 0.5) - half, 0.0)
			middle.y = _SQUARE * (floorf(float(square) / squares) + 0.5) - half
			_segments.append(_segment(rng, middle))


func _add_walls(half: float) -> void:
	var corners: Array[Vec2] = [
		Vec2.new(-half, -half), Vec2.new(half, -half), Vec2.new(half, half), Vec2.new(-half, half)
	]
	for i in corners.size():
		_segments.append(LineSegment.new(corners[i], corners[(i + 1) % corners.size()]))


func _segment(rng: RandomNumberGenerator, middle: Vec2) -> LineSegment:
	middle.add(Vec2.new(rng.randf_range(-_PLAY, _PLAY), rng.randf_range(-_PLAY, _PLAY)))
	var half := Vec2.unit_radians(rng.randf() * PI).scaled(_LENGTH / 2.0)
	return LineSegment.new(middle.minus(half), middle.plus(half))


func _is_corner(square: int, squares: int) -> bool:
	var last := squares - 1
	var row := floori(float(square) / squares)
	return (square % squares == 0 or square % squares == last) and (row == 0 or row == last)
