class_name AcceleratedPointImpactFinder
extends RefCounted
## The exact impact of a ball under constant acceleration with a point: its centre enters the circle
## of its radius about the point. Times are in seconds.
##
## The impact is the first time at which the ball touches the point while it approaches, that is,
## while its velocity has a part against the contact normal. A ball that touches or overlaps the
## point already has its impact at time 0 if it approaches. If it moves away or along, it has an
## impact only when it comes back after it was clear of the point.
## [br][br]
## The impact is a downward root of the quartic |d + v t + g t² / 2|² - r². The quartic is convex,
## then possibly concave, then convex again; a quadratic gives the times in between. Newton's method
## approaches the root from the left where the quartic is convex and from the right where it is
## concave, and never passes it: so it finds the first root. There is none where the slope changes
## its sign on the way. Where rounding hides the answer, [GrazingEntry] and [ExactParabola] decide.
## [br][br]
## To search many points, make one finder, set the flight once and call it for each point: nothing
## is allocated, and all numbers are plain floats. After a call that returned false, the results
## have no meaning.

## Rounding changes a sum by less than this times the sizes of its terms.
const NOISE := 16.0 / 2.0 ** 52

## Below this the square of an acceleration has lost digits, and the acceleration has no effect.
const _FAINT := 1e-280

## Newton's method stops after a step that is smaller than this fraction of the time.
const _LAST_STEP := 4.0 / 2.0 ** 52

## The most steps of Newton's method: more than it needs to come from far away and to halve its way
## to a nearly double root.
const _MOST_STEPS := 90

## Seconds until the impact; 0 where the ball touches already.
var time := 0.0
## x of the contact normal: length 1, towards the ball.
var normal_x := 0.0
## y of the contact normal.
var normal_y := 0.0

var _px := 0.0
var _py := 0.0
var _vx := 0.0
var _vy := 0.0
var _gx := 0.0
var _gy := 0.0
var _radius := 0.0
var _squared_radius := 0.0

# The point, the vector from it to the centre at time 0, and the side of it that counts.
var _cx := 0.0
var _cy := 0.0
var _dx := 0.0
var _dy := 0.0
var _outward_x := 0.0
var _outward_y := 0.0


## Sets the flight: the ball's centre is at (px, py) in pixels, its velocity is (vx, vy) in px/s,
## and its acceleration is (gx, gy) in px/s², which may be 0. [param radius] is 0 or more.
func set_flight(
	px: float, py: float, vx: float, vy: float, gx: float, gy: float, radius: float
) -> void:
	_px = px
	_py = py
	_vx = vx
	_vy = vy
	_gx = gx
	_gy = gy
	_radius = radius
	_squared_radius = radius * radius


## Whether the ball meets the point (cx, cy) within [param horizon] seconds (INF allowed): its
## centre comes within the radius of the point. For the impact of two balls, set the flight to the
## position, velocity and acceleration of one less those of the other, with the sum of both radii,
## and give the point (0, 0).
func with_point(cx: float, cy: float, horizon: float) -> bool:
	var dx := _px - cx
	var dy := _py - cy
	if _starts_inside(cx, cy):
		if dx * _vx + dy * _vy < 0.0:
			return _touches_point_at(0.0, cx, cy, horizon)
		return _touches_point_at(_first_return(cx, cy, INF, 0.0, 0.0), cx, cy, horizon)
	# Across the acceleration the motion is uniform: the ball can touch only while it is in this
	# strip.
	var from := 0.0
	var to := INF
	var squared_pull := _gx * _gx + _gy * _gy
	if squared_pull > _FAINT:
		var leaving := _gx * _vy - _gy * _vx
		var away := (_gx * dy - _gy * dx) * (-1.0 if leaving > 0.0 else 1.0)
		var speed := absf(leaving)
		var reach := sqrt(squared_pull) * (_radius + NOISE * (_radius + absf(dx) + absf(dy)))
		if speed > 0.0:
			from = maxf((away - reach) / speed, 0.0)
			to = (away + reach) / speed
		elif absf(away) > reach:
			return false
	if from <= minf(to, horizon):
		return _touches_point_at(_first_entry(cx, cy, from, to), cx, cy, horizon)
	return false


# Whether the centre is inside the circle about (cx, cy), or on it, at time 0.
func _starts_inside(cx: float, cy: float) -> bool:
	var dx := _px - cx
	var dy := _py - cy
	var squared := dx * dx + dy * dy
	if absf(squared - _squared_radius) > NOISE * squared:
		return squared <= _squared_radius
	return _exact_parabola().squared_gap(cx, cy, _radius, 0.0) <= 0.0


# The first time between `from` and `to` at which a ball that is outside at `from` enters the circle
# about (cx, cy); INF: never.
func _first_entry(cx: float, cy: float, from: float, to: float) -> float:
	_set_point(cx, cy, 0.0, 0.0)
	var x := _dx + from * (_vx + 0.5 * from * _gx)
	var y := _dy + from * (_vy + 0.5 * from * _gy)
	var gap := x * x + y * y - _squared_radius
	# Inside only by rounding: it just touches.
	if gap <= 0.0:
		var growth := x * (_vx + from * _gx) + y * (_vy + from * _gy)
		if growth < 0.0:
			return maxf(from - 0.5 * gap / growth, 0.0)
	return _first_downward(from, to)


# The same for a ball that is inside at time 0 and moves away: the first time it enters again after
# it was outside. Only entries on the side (outward_x, outward_y) of the point count; for (0, 0) all
# count.
func _first_return(cx: float, cy: float, to: float, outward_x: float, outward_y: float) -> float:
	_set_point(cx, cy, outward_x, outward_y)
	return _first_downward(0.0, to)


func _set_point(cx: float, cy: float, outward_x: float, outward_y: float) -> void:
	_cx = cx
	_cy = cy
	_dx = _px - cx
	_dy = _py - cy
	_outward_x = outward_x
	_outward_y = outward_y


func _first_downward(from: float, to: float) -> float:
	var x := _dx + from * (_vx + 0.5 * from * _gx)
	var y := _dy + from * (_vy + 0.5 * from * _gy)
	var ux := _vx + from * _gx
	var uy := _vy + from * _gy
	# Half the second derivative, s seconds after `from`: bend + third * s + fourth * s².
	var bend := ux * ux + uy * uy + x * _gx + y * _gy
	var third := 3.0 * (ux * _gx + uy * _gy)
	var fourth := 1.5 * (_gx * _gx + _gy * _gy)
	var discriminant := third * third - 4.0 * fourth * bend
	if fourth <= _FAINT or (bend > 0.0 and (third >= 0.0 or discriminant <= 0.0)):
		return _from_left(from, to)
	var root := sqrt(discriminant)
	var downwards := from
	if bend > 0.0:
		downwards += 2.0 * bend / (root - third)
		var early := _from_left(from, minf(downwards, to))
		if early < INF or downwards >= to:
			return early
	var upwards := from
	upwards += -2.0 * bend / (third + root) if third > 0.0 else (root - third) / (2.0 * fourth)
	var middle := _from_right(downwards, minf(upwards, to))
	if middle < INF or upwards >= to:
		return middle
	return _from_left(upwards, to)


# The downward root in a part that is convex; none if it starts below 0.
func _from_left(from: float, to: float) -> float:
	var at := from
	for count in _MOST_STEPS:
		var ux := _vx + at * _gx
		var uy := _vy + at * _gy
		var x := _dx + at * (_vx + 0.5 * at * _gx)
		var y := _dy + at * (_vy + 0.5 * at * _gy)
		var gap := x * x + y * y - _squared_radius
		var growth := x * ux + y * uy
		if gap < 0.0 and count == 0:
			return INF
		var step := -0.5 * gap / growth
		if growth >= 0.0 or step <= _LAST_STEP * at:
			var bend := ux * ux + uy * uy + x * _gx + y * _gy
			if absf(gap - growth * growth / bend) <= _noise_at(at, x, y):
				return _grazing_entry(at - growth / bend, to)
			return INF if growth >= 0.0 else _counted(at + step)
		at += step
		if at > to:
			return INF
	return _counted(at)


# The downward root in a part that is concave; none if it ends above 0.
func _from_right(from: float, to: float) -> float:
	var at := to
	for count in _MOST_STEPS:
		var ux := _vx + at * _gx
		var uy := _vy + at * _gy
		var x := _dx + at * (_vx + 0.5 * at * _gx)
		var y := _dy + at * (_vy + 0.5 * at * _gy)
		var gap := x * x + y * y - _squared_radius
		var growth := x * ux + y * uy
		if gap >= 0.0 and count == 0:
			return INF
		var step := 0.5 * gap / growth
		if growth >= 0.0 or step <= _LAST_STEP * at:
			var bend := ux * ux + uy * uy + x * _gx + y * _gy
			if absf(gap - growth * growth / bend) <= _noise_at(at, x, y):
				return _grazing_entry(at - growth / bend, to)
			return INF if growth >= 0.0 else _counted(at - step)
		at -= step
		if at < from:
			# No root if the ball is inside at the start of this part. If it is inside only by
			# rounding, the root is there.
			return _from_left(from, to)
	return _counted(at)


# The time of an entry, or INF if the entry is on a side that does not count.
func _counted(at: float) -> float:
	var x := _dx + at * (_vx + 0.5 * at * _gx)
	var y := _dy + at * (_vy + 0.5 * at * _gy)
	return maxf(at, 0.0) if x * _outward_x + y * _outward_y >= 0.0 else INF


# How much rounding can change the value of the quartic.
func _noise_at(at: float, x: float, y: float) -> float:
	var terms_x := absf(_dx) + at * (absf(_vx) + at * absf(_gx))
	var terms_y := absf(_dy) + at * (absf(_vy) + at * absf(_gy))
	return NOISE * (absf(x) * terms_x + absf(y) * terms_y + _squared_radius)


func _grazing_entry(near: float, to: float) -> float:
	var at := GrazingEntry.time(_px, _py, _vx, _vy, _gx, _gy, _radius, _cx, _cy, near)
	return _counted(at) if at >= 0.0 and at <= to else INF


func _touches_point_at(seconds: float, cx: float, cy: float, horizon: float) -> bool:
	if seconds > horizon or seconds == INF:
		return false
	var dx := _px - cx + seconds * (_vx + 0.5 * seconds * _gx)
	var dy := _py - cy + seconds * (_vy + 0.5 * seconds * _gy)
	var distance := sqrt(dx * dx + dy * dy)
	time = seconds
	normal_x = dx / distance if distance > 0.0 else 0.0
	normal_y = dy / distance if distance > 0.0 else 0.0
	return true


func _exact_parabola() -> ExactParabola:
	return ExactParabola.new(_px, _py, _vx, _vy, _gx, _gy)
