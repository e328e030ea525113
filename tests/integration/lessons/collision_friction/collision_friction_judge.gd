extends LessonJudge
## Judges what the lesson on friction at a bounce says.

# What rounding may make of a comparison or a number, as a share of its terms.
const _ROUNDING := 1e-9
# An event world that is right misses by no more, as a share of all ways and places.
const _MISS := 1e-11

# The steps, counted from 0.
const _SLIP := 1
const _PUSH := 2
const _CONE := 3
const _AFTER := 4
const _LEDGER := 5
const _FLY := 6

const _AS_FACTOR := 101
const _WITHOUT_SPIN := 102
const _NO_STICK := 103
const _NO_TANGENT := 104
const _SMOOTH_BALLS := 105

const _LONGEST_SIDE := 0.3

var _vx: float
var _vy: float
var _spin: float
var _radius: float
var _mu: float
var _c: float
var _gravity: float
var _two: bool
var _mistake: int
# The components of the tangent, and of the velocity along it and along the normal.
var _tx: float
var _ty: float
var _vt: float
var _vn: float
var _slip: float
var _push: float
# The sizes of all speeds.
var _scale: float


## The ball that is told of at last: it, or the one that was at rest.
class Leaving:
	extends RefCounted
	var x := 0.0
	var y := 0.0
	var spin := 0.0


func problem(seen: SeenLesson) -> String:
	_take(seen.state)
	return first_of(
		[
			false_claim([seen.sentence], _claims_of_sentences(seen.step)),
			false_claim(seen.verdict, _claims_of_card(seen.step)),
			_problem_of_numbers(seen.verdict),
			_problem_of_sign(seen),
			_problem_of_rows(seen.rows, seen.step),
			_problem_of_labels(seen.labels, seen.step),
			_problem_of_time(seen),
		]
	)


func _take(state: Dictionary) -> void:
	var velocity: PackedFloat64Array = state["velocity"]
	var along: PackedFloat64Array = state["along"]
	var friction: float = state["friction"]
	var has_friction: bool = state["has_friction"]
	_vx = velocity[0]
	_vy = velocity[1]
	_spin = state["spin"]
	_radius = state["radius"]
	_mu = friction if has_friction else 0.0
	_c = state["bounciness"]
	_two = state["two_balls"]
	_gravity = state["gravity"]
	if _two:
		_gravity = 0.0
	_mistake = state["mistake"]
	var length := sqrt(along[0] * along[0] + along[1] * along[1])
	_tx = along[0] / length
	_ty = along[1] / length
	_vt = _vx * _tx + _vy * _ty
	_vn = _vx * _ty - _vy * _tx
	_slip = _vt - _radius * _spin
	_push = (1.0 + _c) * -_vn
	_scale = sqrt(_vx * _vx + _vy * _vy) + absf(_radius * _spin) + _push * (1.0 + _mu)


func _limit() -> float:
	return _mu * _push


func _share() -> float:
	return 0.5 if _two else 1.0


func _grip() -> float:
	if absf(_slip) <= 3.0 * _limit():
		return -_slip / 3.0
	return -signf(_slip) * _limit()


# Where rounding decides, both hold.
func _can_stick() -> bool:
	return _mu > 0.0 and absf(_slip) <= 3.0 * _limit() + _ROUNDING * _scale


func _can_slip() -> bool:
	return _mu == 0.0 or absf(_slip) >= 3.0 * _limit() - _ROUNDING * _scale


func _rubs() -> bool:
	return absf(_slip) > 1e-13 * _scale


func _can_be_still() -> bool:
	return absf(_slip) <= _ROUNDING * _scale


func _lost() -> float:
	var grip := absf(_grip())
	var to_bounce := 0.5 * (1.0 - _c * _c) * _vn * _vn
	return _share() * (to_bounce + grip * (absf(_slip) - 1.5 * grip))


func _energy() -> float:
	return 0.5 * (_vx * _vx + _vy * _vy) + 0.25 * (_radius * _spin) ** 2


func _momentum() -> float:
	return _radius * _vt + 0.5 * _radius * _radius * _spin


# Ball 1 or 2 as it leaves with an impulse along the surface of which a part turns it.
func _leaving(is_second: bool, grip: float, turning: float) -> Leaving:
	var ball := Leaving.new()
	var side := -_share() if is_second else _share()
	ball.x = side * (_push * _ty + grip * _tx)
	ball.y = side * (-_push * _tx + grip * _ty)
	ball.spin = -_share() * 2.0 * turning / _radius
	if not is_second:
		ball.x += _vx
		ball.y += _vy
		ball.spin += _spin
	return ball


func _right(is_second: bool) -> Leaving:
	return _leaving(is_second, _grip(), _grip())


func _wrong(is_second: bool) -> Leaving:
	match _mistake:
		_AS_FACTOR:
			return _leaving(is_second, -_mu * _vt, 0.0)
		_WITHOUT_SPIN:
			return _leaving(is_second, -clampf(_vt, -_limit(), _limit()), 0.0)
		_NO_STICK:
			var grip := -signf(_slip) * _limit()
			return _leaving(is_second, grip, grip)
		_NO_TANGENT:
			return _leaving(is_second, -_vt, 0.0)
		_SMOOTH_BALLS when _two:
			return _leaving(is_second, 0.0, 0.0)
	return _right(is_second)


# By how much the balls of the mistake leave otherwise.
func _off() -> float:
	var most := 0.0
	for is_second: bool in [false, true]:
		if not is_second or _two:
			var right := _right(is_second)
			var wrong := _wrong(is_second)
			most = maxf(most, Vector2(right.x - wrong.x, right.y - wrong.y).length())
			most = maxf(most, absf(right.spin - wrong.spin) * _radius)
	return most


func _differs() -> bool:
	return _off() >= 1e-10 * _scale


func _is_same() -> bool:
	return _off() <= 1e-8 * _scale


func _is_compared(step: int) -> bool:
	return _mistake != 0 and step >= _AFTER


func _wrong_momentum() -> float:
	var wrong := _wrong(false)
	var sum := _radius * (wrong.x * _tx + wrong.y * _ty) + 0.5 * _radius * _radius * wrong.spin
	if _two:
		var other := _wrong(true)
		sum -= _radius * (other.x * _tx + other.y * _ty)
		sum += 0.5 * _radius * _radius * other.spin
	return sum


func _claims_of_sentences(step: int) -> Dictionary[String, bool]:
	var is_free := _mu == 0.0
	var acts := not is_free and _rubs()
	var can_keep := _lost() <= 1e-9 * _energy()
	var can_lose := _lost() >= 1e-15 * _energy()
	return {
		"neither the speed along the line nor the spin": step == 0 and not _two,
		"two balls push each other straight apart": step == 0 and _two,
		"nothing rubs, the slip u is 0": step == _SLIP and _can_be_still(),
		"The surfaces rub along each other": step == _SLIP and _rubs(),
		"the push jn is that of every bounce": step == _PUSH,
		"the cone is a line": step == _CONE and is_free,
		"in the middle of the cone": step == _CONE and not is_free and _can_be_still(),
		"J is in the cone": step == _CONE and acts and _can_stick(),
		"J is on the edge of the cone": step == _CONE and acts and _can_slip(),
		"Nothing acts along t": step == _AFTER and (is_free or _can_be_still()),
		"Each ball takes half of J": step == _AFTER and _two and acts,
		"J changes the flight": step == _AFTER and not _two and acts,
		"Nothing is lost here": step == _LEDGER and can_keep,
		"into both spins": step == _LEDGER and _two and can_lose,
		"no force has a lever": step == _LEDGER and not _two and can_lose,
		"the event world flies it": step == _FLY and _gravity == 0.0,
		"it hops, and friction": step == _FLY and _gravity > 0.0,
	}


func _claims_of_card(step: int) -> Dictionary[String, bool]:
	var is_compared := _is_compared(step)
	var is_told := step != _LEDGER and (step != _FLY or _gravity == 0.0)
	return {
		"no friction": is_told and _mu == 0.0,
		"the surfaces stick": is_told and _can_stick(),
		"the surfaces slip on": is_told and _mu > 0.0 and _can_slip(),
		"one µ, for sticking and slipping": step == _CONE and _mu > 0.0,
		"v′ = ": step == _AFTER and not _two,
		"v₁′ = ": step == _AFTER and _two,
		"v₂′ = ": step == _AFTER and _two,
		"E = ": step == _LEDGER and _lost() <= 1e-9 * _energy(),
		"is lost": step == _LEDGER and _lost() >= 1e-15 * _energy(),
		"L = ": step == _LEDGER,
		"touches: ": step == _FLY and _gravity > 0.0,
		"miss ": step == _FLY,
		"the mistake changes nothing here": is_compared and _is_same(),
		"the mistake makes L = ": is_compared and step == _LEDGER and _differs(),
		"the mistake: v′ = ": is_compared and step != _LEDGER and not _two and _differs(),
		"the mistake: v₂′ = ": is_compared and step != _LEDGER and _two and _differs(),
	}


func _problem_of_numbers(verdict: PackedStringArray) -> String:
	for line in verdict:
		var is_right := true
		if line.begins_with("v′ = ") or line.begins_with("v₁′ = "):
			is_right = _tells(line, _right(false))
		elif line.begins_with("v₂′ = "):
			is_right = _tells(line, _right(true))
		elif line.begins_with("the mistake: "):
			is_right = _tells(line, _wrong(_two))
		elif line.begins_with("E = "):
			is_right = _is_number("E = ", line, _energy(), _energy())
		elif line.begins_with("E: "):
			is_right = _is_number("E: ", line, _lost(), _energy())
			is_right = is_right and _is_number(" of ", line, _energy(), _energy())
		elif line.begins_with("L = "):
			is_right = _is_number("L = ", line, _momentum(), _radius * _scale)
		elif line.begins_with("the mistake makes"):
			is_right = _is_number("L = ", line, _wrong_momentum(), _radius * _scale)
		elif line.begins_with("touches: "):
			is_right = _is_first_touch(line)
		elif line.begins_with("miss "):
			is_right = _is_miss(line)
		if not is_right:
			return "it is not so: “%s”" % line
	return ""


func _tells(line: String, ball: Leaving) -> bool:
	var spin := SeenLesson.number_behind("′ = ", line.get_slice("ω", 1))
	var is_spin := SeenLesson.is_close(spin, ball.spin, 1e-11 * _scale / _radius)
	return is_spin and is_pair(line.get_slice("′ = ", 1), ball.x, ball.y, 1e-11 * _scale)


static func _is_number(words: String, line: String, wanted: float, size: float) -> bool:
	var shown := SeenLesson.number_behind(words, line)
	return SeenLesson.is_close(shown, wanted, 1e-11 * size)


func _is_first_touch(line: String) -> bool:
	var first := line.trim_prefix("touches: ").get_slice(",", 0)
	return first == "sticks" and _can_stick() or first == "slips" and _can_slip()


# Both are so small that nothing can be seen of them. At least what the numbers of the places are
# rounded by has to be told.
func _is_miss(line: String) -> bool:
	var size := _scale + _gravity + _radius
	var miss := SeenLesson.number_behind("miss ", line)
	var told := line.get_slice("condition", 1).strip_edges()
	var bound := SeenLesson.first_number(told)
	return miss <= _MISS * size and bound <= 1e-9 * size and bound > 0.0


func _problem_of_sign(seen: SeenLesson) -> String:
	var is_so: Dictionary[String, bool] = {
		"": true,
		"=": _can_stick(),
		"≠": _can_slip(),
		"✗": _is_compared(seen.step) and _differs(),
	}
	var is_right: bool = is_so.get(seen.verdict_sign, false)
	return "" if is_right else "the ball of the card has a “%s”" % seen.verdict_sign


func _problem_of_rows(rows: Array[PackedStringArray], step: int) -> String:
	var ball := _right(_two)
	for row in rows:
		var is_right := step >= _AFTER
		if row[0].begins_with("v"):
			is_right = is_right and is_pair(row[1], ball.x, ball.y, 1e-11 * _scale)
			is_right = is_right and SeenLesson.first_number(row[2]) <= 1e-11 * _scale
		elif row[0].begins_with("ω"):
			var shown := SeenLesson.first_number(row[1])
			is_right = is_right and SeenLesson.is_close(shown, ball.spin, 1e-11 * _scale / _radius)
			is_right = is_right and SeenLesson.first_number(row[2]) <= 1e-11 * _scale / _radius
		else:
			is_right = step == _FLY and _is_place(row, ball)
		if not is_right:
			return "it is not so: “%s”" % "  ".join(row)
	return ""


# Where the ball is some time after the contact, before it touches again.
func _is_place(row: PackedStringArray, ball: Leaving) -> bool:
	var seconds := _LONGEST_SIDE
	var presses := _gravity * _tx
	if presses > 0.0:
		seconds = minf(seconds, -2.0 * _c * _vn / presses)
	var side := -_radius if _two else _radius
	var x := side * _ty + ball.x * seconds
	var y := -side * _tx + (ball.y + 0.5 * _gravity * seconds) * seconds
	var size := _scale + _gravity + _radius
	var miss := SeenLesson.first_number(row[2])
	return is_pair(row[1], x, y, _MISS * size) and miss <= _MISS * size


func _problem_of_labels(labels: PackedStringArray, step: int) -> String:
	var is_drawn := step < _FLY
	var friction := "µ = %s" % NumberText.short(_mu)
	var claims: Dictionary[String, bool] = {
		"v": not _two,
		"v₁": _two,
		"r ω": _spin != 0.0,
		"u": is_drawn and step >= _SLIP,
		"jn": is_drawn and step >= _PUSH,
		"J": step >= _CONE,
		friction: step >= _CONE,
		"v′": step >= _AFTER and not _two,
		"v₁′": step >= _AFTER and _two,
		"v₂′": step >= _AFTER and _two,
		"✗": _is_compared(step) and _differs(),
	}
	return false_label(labels, claims)


# What a step introduces is not shown before it.
func _problem_of_time(seen: SeenLesson) -> String:
	if seen.rows and seen.step < _AFTER:
		return "the table comes too early"
	if seen.verdict and seen.step < _CONE:
		return "the card comes before the cone"
	return ""
