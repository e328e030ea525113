class_name AcceleratedImpactFinder
extends AcceleratedPointImpactFinder
## The exact impact of a ball under constant acceleration with a segment that has two sides and
## round caps at its ends. [AcceleratedPointImpactFinder] defines what an impact is.
##
## The ball can touch the segment only while its centre is in a strip: closer to the line than its
## radius. Its distance from the line, counted towards the side to which the acceleration pulls, is
## a parabola that opens upwards. So the ball is in the strip for one interval of time, or for two
## if it crosses the strip and comes back. If it enters the strip between the ends, it touches the
## line. If it enters beside an end, it can touch only the cap of that end before it leaves the
## strip again. So there is no gap between line and cap, and no impact counts twice.
## [br][br]
## Set the flight once, then call [method with_segment] for each segment. With a finite horizon, far
## segments cost little.

## Which part of the segment is touched.
var feature := Impact.Feature.LINE
## Whether the cap at the start of the segment is left out, because the ball cannot meet it: it
## touches something already that is there as well.
var skips_start := false
## The same for the cap at its end.
var skips_end := false

# The segment, and the flight seen from its line: along it and above it, all times its length.
var _ax := 0.0
var _ay := 0.0
var _bx := 0.0
var _by := 0.0
var _ex := 0.0
var _ey := 0.0
var _length := 0.0
var _squared := 0.0
var _along := 0.0
var _along_speed := 0.0
var _along_pull := 0.0
var _side := 1.0
var _height := 0.0
var _climb := 0.0
var _pull := 0.0
var _overlaps := false


## Whether the ball meets the segment from (ax, ay) to (bx, by), which must not be of length 0,
## within [param horizon] seconds (INF allowed).
func with_segment(ax: float, ay: float, bx: float, by: float, horizon: float) -> bool:
	_ax = ax
	_ay = ay
	_bx = bx
	_by = by
	_ex = bx - ax
	_ey = by - ay
	var dx := _px - ax
	var dy := _py - ay
	_height = _ex * dy - _ey * dx
	_climb = _ex * _vy - _ey * _vx
	_pull = _ex * _gy - _ey * _gx
	_side = 1.0
	if _pull < 0.0 or (_pull == 0.0 and _climb > 0.0):
		_side = -1.0
		_height = -_height
		_climb = -_climb
	# Never -0.0: dividing by it would give a time before the start.
	_pull = absf(_pull)
	_squared = _ex * _ex + _ey * _ey
	_length = sqrt(_squared)
	var reach := _radius * _length
	var near := _height - reach
	if near > 0.0 and _climb >= 0.0:
		return false
	var far := _height + reach
	var noise := NOISE * (absf(_ex * dy) + absf(_ey * dx) + reach)
	if absf(near) <= noise:
		near = _exact_parabola().line_gap(ax, ay, bx, by, _radius, _side)
	if absf(far) <= noise:
		far = _exact_parabola().line_gap(ax, ay, bx, by, -_radius, _side)
	_along = _ex * dx + _ey * dy
	_along_speed = _ex * _vx + _ey * _vy
	_along_pull = _ex * _gx + _ey * _gy
	_overlaps = false
	if near <= 0.0:
		if far >= 0.0:
			if _meets_at_start():
				return true
	return _meets_in_strip(near, far, horizon)


# Whether the ball, which is in the strip at the start, touches or overlaps the segment and
# approaches it.
func _meets_at_start() -> bool:
	if _along < 0.0:
		return _meets_point_at_start(_ax, _ay)
	if _along > _squared:
		return _meets_point_at_start(_bx, _by)
	# A centre on the line itself hits the side from which it comes.
	if _height * _climb < 0.0 or (_height == 0.0 and _climb != 0.0):
		return _touches_line_at(0.0, -signf(_climb))
	_overlaps = true
	return false


func _meets_point_at_start(cx: float, cy: float) -> bool:
	if _skips_cap(_along):
		return false
	if not _starts_inside(cx, cy):
		return false
	if (_px - cx) * _vx + (_py - cy) * _vy < 0.0:
		feature = Impact.Feature.START if _along < 0.0 else Impact.Feature.END
		return _touches_point_at(0.0, cx, cy, INF)
	_overlaps = true
	return false


# The one or two intervals of time in the strip.
func _meets_in_strip(near: float, far: float, horizon: float) -> bool:
	var squared_climb := _climb * _climb
	var near_root := squared_climb - 2.0 * _pull * near
	var far_root := squared_climb - 2.0 * _pull * far
	var noise := _noise_of_roots()
	if absf(near_root) <= noise:
		near_root = _exact_parabola().line_discriminant(_ax, _ay, _bx, _by, _radius, _side)
	if near_root <= 0.0:
		# Beside the strip for ever, or moving along inside it for ever.
		if _pull > 0.0 or _climb != 0.0 or near > 0.0 or far < 0.0:
			return false
		return _meets_between(-1.0, INF, 0.0, horizon)
	if absf(far_root) <= noise:
		far_root = _exact_parabola().line_discriminant(_ax, _ay, _bx, _by, -_radius, _side)
	var near_speed := sqrt(near_root)
	var falls := -1.0
	var leaves := INF
	if _climb <= 0.0:
		falls = 2.0 * near / (near_speed - _climb)
		leaves = (near_speed - _climb) / _pull
	else:
		leaves = -2.0 * near / (near_speed + _climb)
	if falls > horizon or leaves < 0.0:
		return false
	if far_root <= 0.0:
		return _meets_between(falls, leaves, 1.0, horizon)
	var far_speed := sqrt(far_root)
	var dips := -1.0
	var comes_back := INF
	if _climb <= 0.0:
		dips = 2.0 * far / (far_speed - _climb)
		comes_back = (far_speed - _climb) / _pull
	else:
		comes_back = -2.0 * far / (far_speed + _climb)
	if _meets_between(falls, dips, 1.0, horizon):
		return true
	return _meets_between(comes_back, leaves, -1.0, horizon)


# Whether the ball touches while it is in the strip, from `from` to `to`. It enters on the side
# `entered_side`; a negative `from` means that it is in the strip at the start.
func _meets_between(from: float, to: float, entered_side: float, horizon: float) -> bool:
	if to < 0.0 or from > horizon or from == INF:
		return false
	var along := _along
	if from >= 0.0:
		along += from * (_along_speed + 0.5 * from * _along_pull)
		if along >= 0.0:
			if along <= _squared:
				return _touches_line_at(from, entered_side)
	elif _overlaps:
		return _meets_after_overlap(to, horizon)
	var entered := maxf(from, 0.0)
	if _skips_cap(along):
		return false
	if along < 0.0:
		feature = Impact.Feature.START
		entered = _near_end(-_along, -_along_speed, -_along_pull, entered, to)
		return _meets_cap(_ax, _ay, entered, to, horizon)
	feature = Impact.Feature.END
	entered = _near_end(_along - _squared, _along_speed, _along_pull, entered, to)
	return _meets_cap(_bx, _by, entered, to, horizon)


# Whether the cap beside which the ball is, at its start or its end, is left out.
func _skips_cap(along: float) -> bool:
	return skips_start if along < 0.0 else skips_end


# `to` is when the ball leaves the strip, not the horizon: so the horizon does not change a single
# bit of the result.
func _meets_cap(cx: float, cy: float, from: float, to: float, horizon: float) -> bool:
	if from > horizon or from == INF:
		return false
	return _touches_point_at(_first_entry(cx, cy, from, to), cx, cy, horizon)


# The first time after `from` at which the ball is at most its radius beyond an end; INF if that is
# after `to`. At time 0 it is `beyond` past the end, with this speed and acceleration in that
# direction; all are times the length of the segment.
func _near_end(beyond: float, speed: float, pull: float, from: float, to: float) -> float:
	var gap := beyond - _radius * _length
	if gap + from * (speed + 0.5 * from * pull) <= 0.0:
		return from
	var discriminant := speed * speed - 2.0 * pull * gap
	if discriminant < 0.0:
		return INF
	var comes := INF
	var root := sqrt(discriminant)
	if speed < 0.0:
		comes = 2.0 * gap / (root - speed)
	elif pull < 0.0:
		comes = -(root + speed) / pull
	return INF if comes < from or comes > to else comes


# The first return of a ball that overlaps the segment at the start and moves away.
func _meets_after_overlap(to: float, horizon: float) -> bool:
	var at_start := INF if skips_start else _first_return(_ax, _ay, to, -_ex, -_ey)
	var at_end := INF if skips_end else _first_return(_bx, _by, to, _ex, _ey)
	if at_start <= at_end:
		feature = Impact.Feature.START
		return _touches_point_at(at_start, _ax, _ay, horizon)
	feature = Impact.Feature.END
	return _touches_point_at(at_end, _bx, _by, horizon)


func _noise_of_roots() -> float:
	var climb_terms := absf(_ex * _vy) + absf(_ey * _vx)
	var pull_terms := absf(_ex * _gy) + absf(_ey * _gx)
	var height_terms := absf(_ex * (_py - _ay)) + absf(_ey * (_px - _ax)) + _radius * _length
	return NOISE * (climb_terms * climb_terms + 2.0 * pull_terms * height_terms)


func _touches_line_at(seconds: float, entered_side: float) -> bool:
	time = seconds
	feature = Impact.Feature.LINE
	normal_x = -_ey / _length * _side * entered_side
	normal_y = _ex / _length * _side * entered_side
	return true
