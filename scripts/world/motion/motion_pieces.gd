@abstract class_name MotionPieces
extends GivenMotion
## The pieces of a [SegmentMotion], by its time alone. In each the segment moves with a constant
## velocity or turns with a constant speed; a piece ends where the next one begins, and the last one
## never ends.

# A time that is short of another one by a smaller share of it is that one.
const _ROUNDING := 1.0 / 2.0 ** 50

## The place of the pivot at the time 0, in pixels; means nothing without a [member turn].
var pivot := Vec2.zero()
## How fast the segment turns, in radians per second, clockwise on screen; 0 where it does not.
var turn := 0.0

# For each piece: when it begins (seconds), how far the segment is then from where it was at the
# time 0 (pixels), and its velocity (px/s).
var _begins: PackedFloat64Array = [0.0]
var _ways: Array[Vec2] = [Vec2.zero()]
var _velocities: Array[Vec2] = [Vec2.zero()]
# How long a path that is repeated takes, in seconds; INF for all others.
var _period := INF
# What is wrong with the arguments.
var _problem := ""


## See [method GivenMotion.problem].
func problem(largest: float) -> String:
	if _problem:
		return _problem
	var limit := String.num_scientific(largest)
	for number: Vec2 in _ways + _velocities + [pivot]:
		if not number.is_within(largest):
			var values := [limit, limit, number]
			return "Ways, velocities and pivots must be within -%s..%s, not %s." % values
	if not absf(turn) <= largest:
		return "A segment must turn by -%s..%s rad/s, not by %s." % [limit, limit, turn]
	return ""


## Which piece lasts at this time; at its end it is the next one.
func piece_at(seconds: float) -> int:
	# The end of a piece was reached by adding times, which are rounded.
	var late := seconds + _ROUNDING * absf(seconds)
	var rounds := floori(late / _period)
	var within := late - rounds * _period if rounds > 0 else late
	var piece := 0
	while piece + 1 < _count() and _begins[piece + 1] <= within:
		piece += 1
	return rounds * _count() + piece


## When a piece begins, in seconds.
func piece_begin(piece: int) -> float:
	var rounds := floori(piece / float(_count()))
	return _begins[piece - rounds * _count()] + (rounds * _period if rounds > 0 else 0.0)


## When a piece ends, in seconds; INF for the last one.
func piece_end(piece: int) -> float:
	if _period == INF and piece + 1 >= _count():
		return INF
	return piece_begin(piece + 1)


## How far the segment is from where it was at the time 0 when this piece begins, in pixels.
func way_of(piece: int) -> Vec2:
	return _ways[piece % _count()]


## The velocity of the segment in this piece, in pixels per second; of one that turns, of its pivot.
func velocity_of(piece: int) -> Vec2:
	return _velocities[piece % _count()]


## How far the segment comes from where it was at the time 0, in pixels, at its turning points.
func longest_way() -> float:
	var longest := 0.0
	for way in _ways:
		longest = maxf(longest, way.length())
	return longest


# A path that is repeated has no piece that begins at its end.
func _count() -> int:
	return _begins.size() - (1 if _period < INF else 0)
