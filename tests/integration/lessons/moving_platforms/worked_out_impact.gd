class_name WorkedOutImpact
extends RefCounted
## The impact of the lesson on surfaces that move, worked out by plain formulas for its judge: with
## a wall by the quadratic formula, with a paddle by looking again and again.

## Until then an impact counts, in seconds.
const LONGEST := 20.0

const _RADIUS := 20.0
# So often a paddle is looked at within the longest time.
const _LOOKS := 4000

const _IGNORED := 101
const _ONCE := 102
const _TWICE := 103
const _TIP := 104

## When they meet, in seconds; NAN if they do not.
var time := NAN
## The velocity after the impact, and that which the mistake makes of it.
var leaving: Pair
var wrong: Pair
## The ball's velocity before.
var velocity: Pair
## The velocity of the wall.
var wall: Pair
## Whether rounding alone may decide whether there is an impact.
var is_edge := false

var _ball: Pair
var _from: Pair
var _to: Pair
var _turning: float
var _bounciness: float
var _mistake: int


## A pair of doubles with the little that is needed here.
class Pair:
	var x: float
	var y: float

	func _init(its_x: float, its_y: float) -> void:
		x = its_x
		y = its_y

	func plus(other: Pair, factor: float = 1.0) -> Pair:
		return Pair.new(x + factor * other.x, y + factor * other.y)

	func dot(other: Pair) -> float:
		return x * other.x + y * other.y

	func size() -> float:
		return sqrt(x * x + y * y)

	func times(factor: float) -> Pair:
		return Pair.new(x * factor, y * factor)


## Of this link state of the lesson.
func _init(state: Dictionary) -> void:
	_ball = _pair_of(state["ball"], 0)
	velocity = _pair_of(state["velocity"], 0)
	_from = _pair_of(state["surface"], 0)
	_to = _pair_of(state["surface"], 2)
	wall = _pair_of(state["surface_velocity"], 0)
	_turning = state["turning"]
	_bounciness = state["bounciness"]
	_mistake = state["mistake"]


static func _pair_of(value: Variant, at: int) -> Pair:
	var list: PackedFloat64Array = value
	return Pair.new(list[at], list[at + 1])


## With the wall: seen from it, the ball flies to a line and two points.
func find_with_wall() -> void:
	var seen := velocity.plus(wall, -1.0)
	var along := _to.plus(_from, -1.0)
	var normal := Pair.new(-along.y, along.x).times(1.0 / along.size())
	var gap := _ball.plus(_from, -1.0).dot(normal)
	if gap < 0.0:
		normal = normal.times(-1.0)
		gap = -gap
	var closing := -seen.dot(normal)
	var best := normal
	if closing > 0.0 and gap >= _RADIUS:
		var seconds := (gap - _RADIUS) / closing
		var foot := _ball.plus(seen, seconds).plus(_from, -1.0).dot(along) / along.dot(along)
		is_edge = absf(foot) < 1e-6 or absf(foot - 1.0) < 1e-6
		if foot >= 0.0 and foot <= 1.0:
			time = seconds
	for end: Pair in [_from, _to]:
		var seconds := _time_to_point(end, seen)
		if not is_nan(seconds) and not time <= seconds:
			time = seconds
			best = _ball.plus(seen, seconds).plus(end, -1.0).times(1.0 / _RADIUS)
	is_edge = is_edge or absf(time - LONGEST) < 1e-6 * LONGEST
	if not is_nan(time) and time <= LONGEST:
		_bounce(best, wall, wall)
	else:
		time = NAN


func _time_to_point(point: Pair, seen: Pair) -> float:
	var way := _ball.plus(point, -1.0)
	var a := seen.dot(seen)
	var b := way.dot(seen)
	var c := way.dot(way) - _RADIUS * _RADIUS
	if a == 0.0 or b >= 0.0:
		return NAN
	var beside := absf(way.x * seen.y - way.y * seen.x) / sqrt(a)
	is_edge = is_edge or absf(beside - _RADIUS) < 1e-6 * _RADIUS
	var inside := b * b - a * c
	return c / (-b + sqrt(inside)) if inside >= 0.0 else NAN


func _gap(seconds: float) -> float:
	return _from_surface(seconds).size() - _RADIUS


# From the nearest point of the paddle to the ball.
func _from_surface(seconds: float) -> Pair:
	var arm := _to.plus(_from, -1.0)
	var angle := atan2(arm.y, arm.x) + _turning * seconds
	var unit := Pair.new(cos(angle), sin(angle))
	var way := _ball.plus(velocity, seconds).plus(_from, -1.0)
	return way.plus(unit, -clampf(way.dot(unit), 0.0, arm.size()))


## With the paddle. A first moment takes a search: here it is seen that there is no touch before the
## one that is [param shown], NAN for none, and that one is there. Whether an answer [param
## is_asked], or no moment is shown yet.
func find_with_paddle(shown: float, is_asked: bool) -> void:
	var first := NAN
	for look: int in _LOOKS + 1:
		var seconds := LONGEST * look / _LOOKS
		if _gap(seconds) < 0.0:
			first = seconds
			break
	var low := maxf(first - LONGEST / _LOOKS, 0.0)
	if not is_nan(shown) and not (first <= shown - 0.001 * shown):
		# A touch between two looks.
		low = maxf(shown - 0.001 * shown - 1e-9, 0.0)
		first = shown + 0.001 * shown + 1e-9
	if is_nan(first):
		is_edge = not is_asked
		return
	time = _first_touch(low, first)
	var normal := _from_surface(time)
	normal = normal.times(1.0 / normal.size())
	var point := _ball.plus(velocity, time).plus(normal, -_RADIUS).plus(_from, -1.0)
	var length := _to.plus(_from, -1.0).size()
	var arm := _to.plus(_from, -1.0)
	var angle := atan2(arm.y, arm.x) + _turning * time
	var tip := Pair.new(-sin(angle), cos(angle)).times(_turning * length)
	_bounce(normal, Pair.new(-point.y, point.x).times(_turning), tip)


# By halving; where the ends do not enclose a touch, the moment at which they are nearest.
func _first_touch(low: float, high: float) -> float:
	if _gap(high) > 0.0:
		is_edge = true
		for third: int in 200:
			var part := (high - low) / 3.0
			if _gap(low + part) <= _gap(high - part):
				high -= part
			else:
				low += part
		return low
	for halving: int in 200:
		var middle := 0.5 * (low + high)
		if _gap(middle) > 0.0:
			low = middle
		else:
			high = middle
	return high


func _bounce(normal: Pair, touched: Pair, tip: Pair) -> void:
	leaving = _reflected(velocity.plus(touched, -1.0), normal).plus(touched)
	var plain := _reflected(velocity, normal)
	match _mistake:
		_IGNORED:
			wrong = plain
		_ONCE:
			wrong = plain.plus(touched)
		_TWICE:
			wrong = plain.plus(touched, 2.0)
		_TIP:
			wrong = _reflected(velocity.plus(tip, -1.0), normal).plus(tip)
		_:
			wrong = leaving


func _reflected(coming: Pair, normal: Pair) -> Pair:
	return coming.plus(normal, -(1.0 + _bounciness) * coming.dot(normal))
