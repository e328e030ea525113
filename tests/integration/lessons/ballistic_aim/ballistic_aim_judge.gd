extends LessonJudge
## Judges what the lesson on aiming under gravity says.

const _LONGEST := 60.0
# Where rounding alone decides, both may be said: below this share of the speed.
const _SLACK := 1e-9
const _EPSILON := 2.220446049250313e-16
# A miss is not more than so many times what rounding alone may make of it.
const _MOST_ROUNDINGS := 8.0

const _SIGN := 101
const _HALF := 102
const _NOT_TESTED := 103
const _AT_REST := 104
const _NO_GRAVITY := 105

# Steps, counted from 0.
const _DROP := 1
const _TIMES := 2
const _ARCS := 3
const _LEAST := 4
const _FIRE := 5

var _step: int
var _p: Pair
var _v: Pair
var _s: float
var _g: float
var _falls: bool
var _moves: bool
var _arc: int
var _mistake: int


## Two doubles.
class Pair:
	extends RefCounted
	var x: float
	var y: float

	func _init(its_x: float, its_y: float) -> void:
		x = its_x
		y = its_y

	func size() -> float:
		var largest := maxf(absf(x), absf(y))
		return largest * sqrt((x / largest) ** 2.0 + (y / largest) ** 2.0) if largest > 0.0 else 0.0


## A shot that hits: when it hits, and its direction.
class Way:
	extends RefCounted
	var time: float
	var dx: float
	var dy: float


func problem(seen: SeenLesson) -> String:
	_take(seen)
	return first_of(
		[
			false_claim([seen.sentence], _claims_of_sentences()),
			_problem_of_card(seen),
			_problem_of_rows(seen.rows),
			_problem_of_labels(seen.labels),
		]
	)


func _take(seen: SeenLesson) -> void:
	_step = seen.step
	var target: PackedFloat64Array = seen.state["target"]
	var velocity: PackedFloat64Array = seen.state["velocity"]
	_moves = seen.state["moves"]
	_falls = seen.state["falls"]
	_p = Pair.new(target[0], target[1])
	_v = Pair.new(velocity[0], velocity[1]) if _moves else Pair.new(0.0, 0.0)
	_s = seen.state["speed"]
	_g = seen.state["gravity"]
	_arc = seen.state["arc"]
	_mistake = seen.state["mistake"]


func _is_fixed() -> bool:
	return _v.size() == 0.0 and (not _falls or _g == 0.0)


func _is_in_one_place() -> bool:
	return _p.size() == 0.0


# All aims that hit the target with these numbers: its velocity, the fall of bullet and target.
func _shots(v: Pair, fall: float, own_fall: float, speed: float) -> Array[Way]:
	var bend := own_fall - fall
	var times: PackedFloat64Array = []
	if _is_in_one_place():
		return []
	if v.size() == 0.0 and own_fall == 0.0:
		times = _times_at_rest(bend, speed)
	else:
		times = _times_of_moving(v, bend, speed)
	var found: Array[Way] = []
	for time in times:
		var shot := Way.new()
		shot.time = time
		var way := Pair.new(_p.x + v.x * time, _p.y + v.y * time + 0.5 * bend * time * time)
		shot.dx = way.x / way.size()
		shot.dy = way.y / way.size()
		var is_known := (
			found and absf(shot.dx - found[-1].dx) + absf(shot.dy - found[-1].dy) < _SLACK
		)
		if not is_known or not _is_fixed():
			found.append(shot)
	return found


func _times_at_rest(bend: float, speed: float) -> PackedFloat64Array:
	if bend == 0.0:
		return [_p.size() / speed]
	var b := speed * speed - bend * _p.y
	var pulled := absf(bend) * _p.size()
	if b < pulled:
		return []
	var sum := b + sqrt(b - pulled) * sqrt(b + pulled)
	return [sqrt(2.0 / sum) * _p.size(), sqrt(2.0 * sum) / absf(bend)]


func _times_of_moving(v: Pair, bend: float, speed: float) -> PackedFloat64Array:
	# Counted in the time of the straight way.
	var unit := _p.size() / maxf(speed, v.size())
	var reach := speed * unit / _p.size()
	var a := Pair.new(_p.x / _p.size(), _p.y / _p.size())
	var u := Pair.new(v.x * unit / _p.size(), v.y * unit / _p.size())
	var c := bend * unit / _p.size() * unit
	var equation: PackedFloat64Array = [
		1.0,
		2.0 * (a.x * u.x + a.y * u.y),
		(u.size() - reach) * (u.size() + reach) + c * a.y,
		c * u.y,
		0.25 * c * c
	]
	var found: PackedFloat64Array = []
	for root in _zeros(equation, _LONGEST / unit):
		found.append(root * unit)
	return found


# The zeros above 0 and up to `last` of the polynomial with these coefficients, from t^0 on.
static func _zeros(equation: PackedFloat64Array, last: float) -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	if equation.size() < 2:
		return found
	var slope: PackedFloat64Array = []
	for power in range(1, equation.size()):
		slope.append(power * equation[power])
	var left := 0.0
	for right in _zeros(slope, last) + PackedFloat64Array([last]):
		if _value(equation, left) * _value(equation, right) < 0.0:
			found.append(_zero_between(equation, left, right))
		left = right
	return found


static func _zero_between(equation: PackedFloat64Array, left: float, right: float) -> float:
	var sign_left := signf(_value(equation, left))
	for halving: int in 200:
		var middle := 0.5 * (left + right)
		if signf(_value(equation, middle)) == sign_left:
			left = middle
		else:
			right = middle
	return right


static func _value(equation: PackedFloat64Array, t: float) -> float:
	var sum := 0.0
	for power in range(equation.size() - 1, -1, -1):
		sum = sum * t + equation[power]
	return sum


func _right_shots(speed: float) -> Array[Way]:
	return _shots(_v, _g, _g if _falls else 0.0, speed)


func _wrong_shots(speed: float) -> Array[Way]:
	var own := _g if _falls else 0.0
	match _mistake:
		_SIGN:
			return _shots(_v, -_g, -own, speed)
		_HALF:
			return _shots(_v, 2.0 * _g, 2.0 * own, speed)
		_AT_REST:
			return _shots(Pair.new(0.0, 0.0), _g, 0.0, speed)
		_NO_GRAVITY:
			return _shots(_v, 0.0, 0.0, speed)
	return _right_shots(speed)


# How many aims hit, as rounding has it.
func _counts() -> PackedInt32Array:
	var found: PackedInt32Array = []
	for share: float in [1.0, 1.0 - _SLACK, 1.0 + _SLACK]:
		found.append(_right_shots(_s * share).size())
	return found


# Whether a tiny change of the speed leads to another number of aims.
func _is_uncertain() -> bool:
	var counts := _counts()
	for share: float in [1.0 - _SLACK, 1.0 + _SLACK]:
		if _wrong_shots(_s * share).size() != _wrong_shots(_s).size():
			return true
	return counts[1] != counts[0] or counts[2] != counts[0]


func _can_be(count: int) -> bool:
	return count in _counts()


func _chosen(shots: Array[Way]) -> Way:
	return shots[clampi(_arc, 0, shots.size() - 1)] if shots else null


# By how much the direction of the mistake is off; INF where only one of the two is there.
func _wrong_by() -> float:
	var right := _chosen(_right_shots(_s))
	var wrong := _chosen(_wrong_shots(_s))
	if not right and not wrong:
		return INF if _mistake == _NOT_TESTED and not _is_in_one_place() else 0.0
	if not right or not wrong:
		return INF
	return Pair.new(right.dx - wrong.dx, right.dy - wrong.dy).size()


func _can_show() -> bool:
	return _mistake != 0 and (_wrong_by() > 0.5 * _SLACK or _is_uncertain())


func _can_hide() -> bool:
	return _mistake != 0 and (_wrong_by() < 2.0 * _SLACK or _is_uncertain())


func _least() -> float:
	if _p.y <= 0.0:
		return sqrt(_g * (_p.size() - _p.y))
	return absf(_p.x) * sqrt(_g / (_p.size() + _p.y))


func _claims_of_sentences() -> Dictionary[String, bool]:
	var is_there := not _is_in_one_place()
	var fixed := is_there and _is_fixed()
	var is_upright := fixed and _p.x == 0.0
	var has_one := not _can_be(0) or _is_uncertain()
	return {
		"Shooter and target are in one place": not is_there,
		"Without gravity the bullet flies straight on": is_there and _step == 0 and _g == 0.0,
		"Straight up or down the bullet stays on the line": _step == 0 and is_upright,
		"Aimed straight at the target, the bullet falls and comes too low":
		_step == 0 and fixed and _g > 0.0 and _p.x != 0.0,
		"The target starts to fall as the shot is fired": is_there and _step == 0 and _falls,
		"The target moves while the bullet flies and falls":
		is_there and _step == 0 and _moves and _g > 0.0 and _v.size() > 0.0,
		"g = 0: the bullet does not fall at all": is_there and _step == _DROP and _g == 0.0,
		"In t seconds the bullet falls g t² / 2, and so does the target":
		is_there and _step == _DROP and _falls and _g > 0.0,
		"In t seconds the bullet falls g t² / 2, and the target moves by V t":
		is_there and _step == _DROP and not _falls and _v.size() > 0.0,
		"In t seconds it falls g t² / 2. So aim so far above the target":
		fixed and _step == _DROP and _g > 0.0,
		"A higher aim takes longer, and falls more": fixed and _step == _TIMES,
		"D = P + V t is s t away when it hits":
		is_there and not fixed and _step == _TIMES and (_falls or _g == 0.0),
		"D(t) is s t away when it hits": is_there and not fixed and not _falls and _step == _TIMES,
		"No direction hits. The card says why": is_there and _step == _ARCS and _can_be(0),
		"One direction hits": _step == _ARCS and _can_be(1),
		"Two directions hit, d = D / |D|: the flat arc, and the high arc":
		fixed and _step == _ARCS and _can_be(2),
		"2 directions hit": not fixed and _step == _ARCS and _can_be(2),
		"3 directions hit": _step == _ARCS and _can_be(3),
		"4 directions hit": _step == _ARCS and _can_be(4),
		"Without gravity there is no edge": is_there and _step == _LEAST and _g == 0.0,
		"What a bullet with speed s can reach is inside the dashed parabola":
		is_there and not fixed and _step == _LEAST and _g > 0.0,
		"Straight below, the bullet need only be dropped":
		is_upright and _step == _LEAST and _p.y > 0.0 or fixed and _least() == 0.0,
		"s₀ is the least speed. Its aim halves the angle":
		fixed and _step == _LEAST and _least() > 0.0,
		"No aim hits, and nothing is fired":
		is_there and _step == _FIRE and _can_be(0) and (_mistake == 0 or _can_hide()),
		"Fire: press Play. What the mistake does is dashed": _step == _FIRE and _can_show(),
		"Fire: press Play. It hits; what is left is rounding":
		_step == _FIRE and has_one and (_mistake == 0 or _can_hide()),
	}


func _problem_of_card(seen: SeenLesson) -> String:
	if seen.verdict.is_empty():
		return ""
	if _step < _TIMES:
		return "it is not known yet: “%s”" % seen.verdict[0]
	return first_of(
		[
			false_claim(seen.verdict, _claims_of_card()),
			_problem_of_sign(seen.verdict_sign),
			_problem_of_numbers(seen.verdict),
		]
	)


func _claims_of_card() -> Dictionary[String, bool]:
	var compares := _step in [_ARCS, _FIRE]
	var is_out := not _is_in_one_place() and _can_be(0)
	var is_straight := _falls or _g == 0.0
	var outruns := _v.size() >= _s * (1.0 - _SLACK)
	return {
		"one aim hits": _can_be(1),
		"2 aims hit": _can_be(2),
		"3 aims hit": _can_be(3),
		"4 aims hit": _can_be(4),
		"no direction: both are in one place": _is_in_one_place(),
		"out of reach: s must be at least ": is_out and _is_fixed(),
		"the target is faster than the bullet and gets away":
		is_out and not _is_fixed() and is_straight and outruns,
		"out of reach: no aim hits within 60 s": is_out and not _is_fixed(),
		"miss ": _step == _FIRE and (not _can_be(0) or _is_uncertain()),
		"px; ε × condition": _step == _FIRE,
		"the mistake changes nothing here": compares and (_can_hide() or _is_in_one_place()),
		"the mistake takes the root of w < 0: NaN": compares and _mistake == _NOT_TESTED and is_out,
		"the mistake finds no aim":
		compares and _can_show() and (_wrong_shots(_s).is_empty() or _is_uncertain()),
		"the mistake says t = ": compares and _mistake == _HALF and _p.y == 0.0 and _can_show(),
		"the mistake misses by ": compares and _can_show(),
	}


func _problem_of_sign(sign_text: String) -> String:
	var compares := _step in [_ARCS, _FIRE]
	var is_so := false
	if sign_text == "✗":
		is_so = compares and _can_show()
	else:
		is_so = _can_be(sign_text.to_int()) and (not compares or _mistake == 0 or _can_hide())
	return "" if is_so else "the ball of the card has a “%s”" % sign_text


func _problem_of_numbers(lines: PackedStringArray) -> String:
	var least := SeenLesson.number_behind("at least ", lines[0])
	if not is_nan(least) and not SeenLesson.is_close(least, _least(), 0.0):
		return "the least speed is %s: “%s”" % [_least(), lines[0]]
	if _is_uncertain():
		return ""
	var problems: PackedStringArray = []
	for line in lines:
		problems.append(_problem_of_miss(line))
		problems.append(_problem_of_mistake(line))
	return first_of(problems)


func _problem_of_miss(line: String) -> String:
	var rounding := _rounding()
	var shown := SeenLesson.number_behind("; ε × condition ", line)
	if not is_nan(shown) and not absf(shown - rounding) <= 0.1 * rounding:
		return "rounding may move it by %s: “%s”" % [rounding, line]
	shown = SeenLesson.number_behind("miss ", line)
	if not is_nan(shown) and not shown <= _MOST_ROUNDINGS * rounding:
		return "rounding alone makes no more than %s: “%s”" % [rounding, line]
	return ""


func _problem_of_mistake(line: String) -> String:
	var shown := SeenLesson.number_behind("says t = ", line)
	var half := 0.5 * _chosen(_right_shots(_s)).time if not _can_be(0) else NAN
	if not is_nan(shown) and not SeenLesson.is_close(shown, half, 0.0):
		return "half of the time is %s: “%s”" % [half, line]
	shown = SeenLesson.number_behind("misses by ", line)
	if is_nan(shown):
		return ""
	var miss := _wrong_miss()
	var off := 0.0051 * miss + 1e-9 * _p.size() + _EPSILON * 1e6
	return "" if absf(shown - miss) <= off else "it misses by %s: “%s”" % [miss, line]


# How far the shot moves by a change of each of its numbers by one part, times eps.
func _rounding() -> float:
	var shot := _chosen(_right_shots(_s))
	if not shot:
		return 0.0
	var t := shot.time
	var pull := 0.0 if _falls else _g
	var sum := absf(_p.x) + absf(_p.y) + (absf(_v.x) + absf(_v.y)) * t
	sum += _s * t * (1.0 + absf(shot.dx) + absf(shot.dy)) + 0.5 * pull * t * t
	var closing := Pair.new(_v.x - _s * shot.dx, _v.y - _s * shot.dy - pull * t)
	return _EPSILON * (sum + t * closing.size())


# The smallest distance of the centres, of the shot of the mistake. At a target that moves no shot
# counts that is longer than 60 s.
func _wrong_miss() -> float:
	var shot := _chosen(_wrong_shots(_s))
	if not shot:
		return NAN
	var ux := _v.x - _s * shot.dx
	var uy := _v.y - _s * shot.dy
	var bend := (_g if _falls else 0.0) - _g
	var growth: PackedFloat64Array = [
		_p.x * ux + _p.y * uy, ux * ux + uy * uy + _p.y * bend, 1.5 * uy * bend, 0.5 * bend * bend
	]
	var least := INF
	var last := shot.time if _is_fixed() else minf(shot.time, _LONGEST)
	for t in _zeros(growth, _LONGEST) + PackedFloat64Array([0.0, _LONGEST, last]):
		var apart := Pair.new(_p.x + ux * t, _p.y + uy * t + 0.5 * bend * t * t)
		least = minf(least, apart.size())
	return least


func _problem_of_rows(rows: Array[PackedStringArray]) -> String:
	if _is_uncertain():
		return ""
	var shot := _chosen(_right_shots(_s))
	for row in rows:
		var seconds := SeenLesson.first_number(row[1])
		if is_nan(seconds):
			if row[1] == "none" and row[0] == "t of hit" and shot:
				return "it hits after %s s: “%s”" % [shot.time, "  ".join(row)]
			continue
		var is_careful := row[0] == "t of hit"
		var error := SeenLesson.first_number(row[2])
		if not shot or is_careful and not SeenLesson.is_close(seconds, shot.time, 1e-6 * shot.time):
			return "it hits after %s s: “%s”" % [shot.time if shot else NAN, "  ".join(row)]
		# Of two roots that are nearly one, only half of the digits can be right.
		if is_careful and not error <= 1e-7 * shot.time:
			return "the error cannot be that: “%s”" % "  ".join(row)
		if not is_careful and not _is_error(error, seconds, shot.time):
			return "it is off by %s: “%s”" % [seconds - shot.time, "  ".join(row)]
	return ""


# Four digits are shown of a time, and two of its error.
static func _is_error(error: float, seconds: float, wanted: float) -> bool:
	return absf(error - absf(seconds - wanted)) <= 0.051 * error + 1e-3 * seconds


func _problem_of_labels(labels: PackedStringArray) -> String:
	var hits := (not _can_be(0) or _is_uncertain()) and _step in [_ARCS, _FIRE]
	var claims: Dictionary[String, bool] = {
		"P": true,
		"s": true,
		"g": true,
		"V": _moves,
		"g t² / 2": _g > 0.0 and (_step == _DROP or hits),
		"s₀": _step == _LEAST and _is_fixed() and _least() > 0.0,
	}
	for place: int in 4:
		var is_there := hits and (_counts()[0] > place or _is_uncertain())
		claims["D" + "₁₂₃₄"[place]] = is_there and (_arc >= place or _is_uncertain())
	for label in labels:
		if label.ends_with(" px off"):
			if not (_step in [_ARCS, _FIRE] and _can_show()):
				return "there is no mistake: label “%s”" % label
		elif not claims.get(label, false):
			return "it should not be on the board: “%s”" % label
	return ""
