extends LessonJudge
## Judges what the lesson on the moment to fire says.

const _LONGEST := 60.0
const _EPSILON := 2.220446049250313e-16
# Where rounding alone decides, both may be said: below this share.
const _SLACK := 1e-9
# A miss is not more than so many times what rounding alone may make of it.
const _MOST_ROUNDINGS := 8.0

const _LINE := 0
const _CIRCLE := 1
const _TURNING := 2

const _IN_FRONT := 101
const _FLIGHT_ADDED := 102
const _BULLET_FORGOTTEN := 103

# Steps, counted from 0.
const _CROSS := 1
const _WAIT := 2
const _WINDOW := 3
const _FIRE := 4

var _step: int
var _kind: int
var _sx: float
var _sy: float
var _wx: float
var _wy: float
var _tx: float
var _ty: float
var _vx: float
var _vy: float
var _cx: float
var _cy: float
# Radians a second.
var _circling: float
var _turning: float
var _radius: float
var _own: float
var _mistake: int
# The right moment and the flight, as worked out here or, for a turning barrel, as shown.
var _fire := NAN
var _flight := NAN


func problem(seen: SeenLesson) -> String:
	_take(seen)
	return first_of(
		[
			false_claim([seen.sentence], _claims_of_sentences(seen)),
			_problem_of_card(seen),
			_problem_of_rows(seen.rows),
			_problem_of_labels(seen),
		]
	)


func _take(seen: SeenLesson) -> void:
	_step = seen.step
	var pairs: Dictionary[String, PackedFloat64Array] = {}
	for key: String in ["muzzle", "bullet", "target", "velocity", "centre"]:
		pairs[key] = seen.state[key]
	_sx = pairs["muzzle"][0]
	_sy = pairs["muzzle"][1]
	_wx = pairs["bullet"][0]
	_wy = pairs["bullet"][1]
	_tx = pairs["target"][0]
	_ty = pairs["target"][1]
	_vx = pairs["velocity"][0]
	_vy = pairs["velocity"][1]
	_cx = pairs["centre"][0]
	_cy = pairs["centre"][1]
	_kind = seen.state["kind"]
	var circling: float = seen.state["circling"]
	var turning: float = seen.state["turning"]
	_circling = deg_to_rad(circling)
	_turning = deg_to_rad(turning)
	_radius = seen.state["radius"]
	_own = seen.state["fire"]
	_mistake = seen.state["mistake"]
	_work_out(seen)


static func _size(x: float, y: float) -> float:
	var largest := maxf(absf(x), absf(y))
	return largest * sqrt((x / largest) ** 2.0 + (y / largest) ** 2.0) if largest > 0.0 else 0.0


func _work_out(seen: SeenLesson) -> void:
	_fire = NAN
	_flight = NAN
	match _kind:
		_LINE:
			_work_out_line()
		_CIRCLE:
			_work_out_circle()
		_TURNING:
			_work_out_turning(seen)


# P × V / (W × V), and P × (W - V) / (W × V).
func _work_out_line() -> void:
	var across := _wx * _vy - _wy * _vx
	if across == 0.0:
		return
	_flight = ((_tx - _sx) * _vy - (_ty - _sy) * _vx) / across
	_fire = ((_tx - _sx) * (_wy - _vy) - (_ty - _sy) * (_wx - _vx)) / across


func _work_out_circle() -> void:
	var rho := _size(_tx - _cx, _ty - _cy)
	var phase := atan2(_ty - _cy, _tx - _cx)
	for flight in _crossings(rho):
		var x := _sx + _wx * flight - _cx
		var y := _sy + _wy * flight - _cy
		var period := TAU / absf(_circling)
		var fire := fposmod((atan2(y, x) - phase) / _circling - flight, period)
		if flight > 0.0 and fire <= _LONGEST and not _fire <= fire:
			_fire = fire
			_flight = flight


func _crossings(rho: float) -> PackedFloat64Array:
	var a := _wx * _wx + _wy * _wy
	var b := (_sx - _cx) * _wx + (_sy - _cy) * _wy
	var c := (_size(_sx - _cx, _sy - _cy) - rho) * (_size(_sx - _cx, _sy - _cy) + rho)
	var inside := b * b - a * c
	if inside < 0.0:
		return []
	var root := -b - sqrt(inside) if b >= 0.0 else -b + sqrt(inside)
	return [root / a, c / root] if root != 0.0 else [0.0]


# The first moment takes a search: here it is only seen whether the shown one hits.
func _work_out_turning(seen: SeenLesson) -> void:
	for line in seen.verdict:
		var fire := SeenLesson.number_behind("fire after ", line)
		var hit := SeenLesson.number_behind("it hits after ", line)
		_fire = fire if not is_nan(fire) else _fire
		_flight = hit - _fire if not is_nan(hit) else _flight


# Whether a moment hits; both where rounding decides.
func _can_hit() -> bool:
	if _kind == _TURNING:
		return _size(_wx, _wy) > _size(_vx, _vy)
	var off := _SLACK * (1.0 + absf(_fire) + absf(_flight))
	return _flight > -off and _fire >= -off and _fire <= _LONGEST + off or _is_edge()


func _can_fail() -> bool:
	if _kind == _TURNING:
		return true
	var off := _SLACK * (1.0 + absf(_fire) + absf(_flight))
	return not (_flight > off and _fire >= off and _fire <= _LONGEST - off) or _is_edge()


# Nearly parallel, or the bullet nearly grazes the circle, or the target is nearly met at once.
func _is_edge() -> bool:
	if _kind == _LINE:
		var across := absf(_wx * _vy - _wy * _vx)
		return across <= 1e-12 * _size(_wx, _wy) * _size(_vx, _vy) and across > 0.0
	if _kind != _CIRCLE:
		return false
	var rho := _size(_tx - _cx, _ty - _cy)
	var speed := _size(_wx, _wy)
	var beside := absf((_cx - _sx) * _wy - (_cy - _sy) * _wx) / speed
	var period := TAU / absf(_circling)
	var is_late := _fire > period * (1.0 - 1e-6) or _fire < period * 1e-6
	return absf(beside - rho) <= 1e-6 * rho or is_late


func _claims_of_sentences(seen: SeenLesson) -> Dictionary[String, bool]:
	var is_line := _kind == _LINE
	var is_parallel := absf(_wx * _vy - _wy * _vx) <= 1e-12 * _size(_wx, _wy) * _size(_vx, _vy)
	var shows_wrong := seen.verdict_sign == "✗"
	var rests := _size(_vx, _vy) == 0.0
	return {
		"The barrel turns all the time. When do you fire?": _step == 0 and _kind == _TURNING,
		"The barrel does not follow the target": _step == 0 and _kind != _TURNING,
		"Each moment has its own direction": _step == _CROSS and _kind == _TURNING,
		"They can only meet in X": _step == _CROSS and _kind != _TURNING and _can_cross(),
		"The bullet does not cross the circle": _step == _CROSS and _kind == _CIRCLE,
		"V = 0: the target rests": _step == _CROSS and is_line and rests,
		"Both ways are parallel: there is no X": _step == _CROSS and is_line and is_parallel,
		"f is not above 0: both ways cross behind":
		_step == _CROSS and is_line and not _flight > 1e-9,
		"No moment hits. The card says why": _step == _WAIT and _can_fail(),
		"Fire when the barrel points to where they meet": _step == _WAIT and _kind == _TURNING,
		"Fire f before the target is in X": _step == _WAIT and _kind != _TURNING and _can_hit(),
		"No moment hits, so there is no window": _step == _WINDOW and _can_fail(),
		"With R, the radii of both together": _step == _WINDOW and _can_hit(),
		"No moment hits, and nothing is fired": _step == _FIRE and _can_fail(),
		"Fire: press Play. What the mistake does is dashed": _step == _FIRE and shows_wrong,
		"Fire: press Play. It hits; what is left is rounding": _step == _FIRE and _can_hit(),
	}


func _can_cross() -> bool:
	if _kind == _LINE:
		return _flight > -1e-9
	return _crossings(_size(_tx - _cx, _ty - _cy)).size() > 0 or _is_edge()


func _problem_of_card(seen: SeenLesson) -> String:
	if seen.verdict.is_empty():
		return ""
	if _step < _WAIT:
		return "it is not known yet: “%s”" % seen.verdict[0]
	return first_of(
		[
			false_claim(seen.verdict, _claims_of_card()),
			_problem_of_sign(seen),
			_problem_of_moments(seen.verdict),
			_problem_of_window(seen.verdict),
			_problem_of_miss(seen.verdict),
		]
	)


func _claims_of_card() -> Dictionary[String, bool]:
	var is_line := _kind == _LINE
	var rests := is_line and _size(_vx, _vy) == 0.0
	var has_mistake := _mistake != 0 and _step >= _WAIT
	return {
		"fire after ": _step == _WAIT and _can_hit(),
		"it hits after ": _step == _WAIT and _can_hit(),
		"hits from ": _step == _WINDOW and _can_hit(),
		"your shot at ": _step == _WINDOW and _can_hit(),
		"miss ": _step == _FIRE and _can_hit(),
		"px; ε × condition": _step == _FIRE and _can_hit(),
		"the target rests: the moment does not matter": rests,
		"both ways are parallel: they meet never, or always": is_line and _can_fail() and not rests,
		"the bullet does not cross the way of the target":
		_kind != _TURNING and _can_fail() and not rests,
		"too late: the target has passed before a bullet comes": is_line and not _fire > 1e-9,
		"it takes longer than 60 s": _kind != _TURNING and _can_fail() and not rests,
		"the bullet must be faster than the target":
		_kind == _TURNING and _size(_wx, _wy) <= _size(_vx, _vy),
		"within 60 s the barrel never points ahead": _kind == _TURNING,
		"the mistake changes nothing here": has_mistake,
		"the mistake says ± ": _step == _WINDOW and _mistake == _BULLET_FORGOTTEN and is_line,
		"it misses by ": _step in [_WAIT, _FIRE] and _mistake in [_IN_FRONT, _FLIGHT_ADDED],
	}


func _problem_of_sign(seen: SeenLesson) -> String:
	var is_so := false
	match seen.verdict_sign:
		"✗":
			var last := seen.verdict[-1]
			is_so = last.contains("it misses by ") or last.contains("the mistake says ")
		"!":
			is_so = _can_hit()
		"0":
			is_so = _can_fail()
	return "" if is_so else "the ball of the card has a “%s”" % seen.verdict_sign


# What the moments may be off by: nearly parallel ways cross far away.
func _off() -> float:
	if _kind == _TURNING:
		return 0.0
	return 1e-6 * (1.0 + absf(_fire) + absf(_flight)) if _is_edge() else 1e-9 * (1.0 + _flight)


func _problem_of_moments(lines: PackedStringArray) -> String:
	if _kind == _TURNING:
		return _problem_of_turning()
	if _is_edge():
		return ""
	for line in lines:
		var shown := SeenLesson.number_behind("fire after ", line)
		if not is_nan(shown) and not SeenLesson.is_close(shown, _fire, _off()):
			return "it is %s s: “%s”" % [_fire, line]
		shown = SeenLesson.number_behind("it hits after ", line)
		if not is_nan(shown) and not SeenLesson.is_close(shown, _fire + _flight, _off()):
			return "it is %s s: “%s”" % [_fire + _flight, line]
	return ""


# Four digits are shown of both moments: the shot comes as near as these allow.
func _problem_of_turning() -> String:
	if is_nan(_fire) or is_nan(_flight):
		return ""
	var hit := _fire + _flight
	var unit := 10.0 ** (floorf(log(maxf(hit, 1e-9)) / log(10.0)) - 3.0)
	var angle := atan2(_wy, _wx) + _turning * _fire
	var speed := _size(_wx, _wy)
	var x := _sx + speed * cos(angle) * _flight - _tx - _vx * hit
	var y := _sy + speed * sin(angle) * _flight - _ty - _vy * hit
	var off := unit * (2.0 * speed + 2.0 * _size(_vx, _vy) + absf(_turning) * speed * absf(_flight))
	return "" if _size(x, y) <= 2.0 * off else "it misses by %s px then" % _size(x, y)


func _problem_of_window(lines: PackedStringArray) -> String:
	if _kind != _LINE or _is_edge():
		return ""
	var across := absf(_wx * _vy - _wy * _vx)
	var half := _radius * _size(_wx - _vx, _wy - _vy) / across
	for line in lines:
		var first := SeenLesson.number_behind("hits from ", line)
		var last := SeenLesson.number_behind(" s to ", line)
		if not is_nan(first):
			var is_first := SeenLesson.is_close(first, maxf(_fire - half, 0.0), 1e-9 + _off())
			if not is_first or not SeenLesson.is_close(last, _fire + half, _off()):
				return "it hits from %s to %s: “%s”" % [_fire - half, _fire + half, line]
		var plain := SeenLesson.number_behind("the mistake says ± ", line)
		var wanted := _radius / _size(_vx, _vy)
		if not is_nan(plain) and not SeenLesson.is_close(plain, wanted, 0.0):
			return "R / |V| is %s: “%s”" % [wanted, line]
	return ""


# How far the centres are from each other at least, where the shot is fired at this moment.
func _miss_at(fire: float) -> float:
	var px := _tx + _vx * fire - _sx
	var py := _ty + _vy * fire - _sy
	var ux := _vx - _wx
	var uy := _vy - _wy
	if ux * px + uy * py >= 0.0 or _size(ux, uy) == 0.0:
		return _size(px, py)
	return absf(px * uy - py * ux) / _size(ux, uy)


func _problem_of_miss(lines: PackedStringArray) -> String:
	var rounding := NAN
	var miss := NAN
	for line in lines:
		if line.begins_with("miss "):
			miss = SeenLesson.number_behind("miss ", line)
			rounding = SeenLesson.number_behind("; ε × condition ", line)
		var found := _problem_of_other_shot(line)
		if found:
			return found
	if not is_nan(miss) and not miss <= _MOST_ROUNDINGS * rounding:
		return "a miss of %s is more than rounding alone, %s" % [miss, rounding]
	if _kind == _LINE and not is_nan(rounding) and not _is_edge():
		var wanted := _rounding()
		if not absf(rounding - wanted) <= 0.1 * wanted:
			return "rounding alone may make %s, not %s" % [wanted, rounding]
	return ""


# The shot of the student, and that of the mistake.
func _problem_of_other_shot(line: String) -> String:
	if _kind != _LINE or _is_edge():
		return ""
	var fire := _own
	var words := " misses by "
	if line.begins_with("fired after "):
		fire = _fire + (_flight if _mistake == _IN_FRONT else 2.0 * _flight)
		var shown := SeenLesson.number_behind("fired after ", line)
		if not SeenLesson.is_close(shown, fire, _off()):
			return "the mistake fires after %s s: “%s”" % [fire, line]
	elif not line.begins_with("your shot at "):
		return ""
	var apart := _miss_at(fire)
	var off := 0.0051 * apart + 1e-9 * (1.0 + _size(_vx, _vy) * fire)
	if line.contains(words):
		var shown := SeenLesson.number_behind(words, line)
		if not absf(shown - apart) <= off:
			return "it misses by %s px: “%s”" % [apart, line]
	elif not apart <= _radius + off:
		return "it does not hit, but misses by %s px: “%s”" % [apart, line]
	return ""


# How far the shot moves by a change of each of its numbers by one part, times eps.
func _rounding() -> float:
	var hit := _fire + _flight
	var sum := absf(_sx) + absf(_sy) + absf(_tx) + absf(_ty)
	sum += (absf(_wx) + absf(_wy)) * _flight + (absf(_vx) + absf(_vy)) * hit
	sum += _size(_vx, _vy) * absf(_fire) + _size(_wx - _vx, _wy - _vy) * _flight
	return _EPSILON * sum


func _problem_of_rows(rows: Array[PackedStringArray]) -> String:
	for row in rows:
		var shown := SeenLesson.first_number(row[1])
		if is_nan(shown):
			if not _can_fail():
				return "there is a moment, %s: “%s”" % [_fire, "  ".join(row)]
			continue
		if _kind == _TURNING or _is_edge():
			continue
		var wanted := _fire if row[0] == "fire" else _flight
		if not _can_hit() or not SeenLesson.is_close(shown, wanted, _off()):
			return "it is %s: “%s”" % [wanted, "  ".join(row)]
		var places := _size(_sx, _sy) + _size(_tx, _ty)
		var largest := 1e-12 * (1.0 + wanted + places / _size(_wx, _wy))
		var scale := _size(_wx, _wy) * _size(_vx, _vy) / absf(_wx * _vy - _wy * _vx)
		if row[2] and not SeenLesson.first_number(row[2]) <= largest * scale * (1.0 + scale):
			return "the error cannot be that: “%s”" % "  ".join(row)
	return ""


func _problem_of_labels(seen: SeenLesson) -> String:
	var claims: Dictionary[String, bool] = {
		"T": true,
		"W": true,
		"V": _kind != _CIRCLE,
		"X": _step >= (_WAIT if _kind == _TURNING else _CROSS) and (_can_cross() or _can_hit()),
		"fire": _step in [_WAIT, _FIRE] and _can_hit(),
	}
	for label in seen.labels:
		if label.ends_with(" px off"):
			if seen.verdict_sign != "✗":
				return "there is no mistake: label “%s”" % label
		elif not claims.get(label, false):
			return "it should not be on the board: “%s”" % label
	return ""
