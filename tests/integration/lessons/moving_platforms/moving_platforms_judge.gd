extends LessonJudge
## Judges what the lesson on surfaces that move says.

# What becomes of a disc.
enum { ROLLS, ROLLS_LATER, ENDS_BEFORE, SLIPS }

# What rounding may make of a comparison or a number, as a share of its terms.
const _ROUNDING := 1e-9
# A miss is not more than so many times what rounding alone may make of it.
const _MOST_ROUNDINGS := 8.0
const _GRAVITY := 600.0

const _WALL := 0
const _BELT := 1
const _PLATFORM := 2
const _PADDLE := 3
const _PRESS := 4

# The steps, counted from 0.
const _FRAME := 1
const _LAW := 2
const _BACK := 3
const _FLY := 4

const _IGNORED := 101
const _ONCE := 102
const _TWICE := 103
const _TIP := 104
const _BELT_SPEED := 105
const _LATE := 106

var _step: int
var _kind: int
var _mistake: int
var _state: Dictionary
var _speed: float
var _surface_speed: float
var _friction: float
var _way: float
var _met: WorkedOutImpact
# The disc.
var _pull: float
var _pressure: float
var _slip: float
var _roll_time: float
var _roll_speed: float
var _cases: Array[int] = []


func problem(seen: SeenLesson) -> String:
	_take(seen)
	return first_of(
		[
			false_claim([seen.sentence], _claims_of_sentences()),
			_problem_of_card(seen),
			_problem_of_rows(seen),
			false_label(seen.labels, _claims_of_labels()),
		]
	)


func _take(seen: SeenLesson) -> void:
	var state := seen.state
	_state = state
	_step = seen.step
	_kind = state["kind"]
	_mistake = state["mistake"]
	_speed = state["speed"]
	_surface_speed = state["surface_speed"]
	_friction = state["friction"]
	_way = state["way"]
	_met = WorkedOutImpact.new(state)
	_cases = []
	match _kind:
		_WALL:
			_met.find_with_wall()
		_PADDLE:
			_met.find_with_paddle(_shown_time(seen.verdict), _step >= _BACK)
		_BELT, _PLATFORM:
			_work_out_disc()


static func _shown_time(verdict: PackedStringArray) -> float:
	for line in verdict:
		var number := SeenLesson.number_behind("they meet after ", line)
		if not is_nan(number):
			return number
	return NAN


func _work_out_disc() -> void:
	var is_belt := _kind == _BELT
	var ends: PackedFloat64Array = _state["surface"]
	var ball: PackedFloat64Array = _state["ball"]
	var width := ends[2] - ends[0]
	var height := ends[3] - ends[1]
	var length := sqrt(width * width + height * height) if is_belt else 200.0
	_pull = _GRAVITY * height / length if is_belt else 0.0
	_pressure = _GRAVITY * absf(width) / length if is_belt else _GRAVITY
	var speed := _speed if is_belt else 2.0 * _surface_speed
	_slip = speed - (_surface_speed if is_belt else 0.0)
	var distance := 100.0
	if is_belt:
		distance = clampf(
			((ball[0] - ends[0]) * width + (ball[1] - ends[1]) * height) / length, 0.0, length
		)
	var grip := _friction * _pressure
	var holds := 3.0 * grip - absf(_pull)
	var slack := _ROUNDING * (grip + absf(_pull))
	var fades := 3.0 * grip - signf(_slip) * _pull
	var rubs := _pull - signf(_slip) * grip
	_roll_time = absf(_slip) / fades if fades > 0.0 else INF
	_roll_speed = speed + rubs * _roll_time if fades > 0.0 else speed
	if not is_belt:
		_roll_speed -= _surface_speed
	# By how much it stays on the surface until then.
	var room := _room(distance, speed, rubs, length) if fades > 0.0 and _slip != 0.0 else INF
	for can_hold: bool in [true, false]:
		if holds < -slack and can_hold or holds > slack and not can_hold:
			continue
		if not can_hold or not fades > 0.0 and _slip != 0.0:
			_cases.append(SLIPS)
		elif _slip == 0.0:
			_cases.append(ROLLS)
		else:
			if room >= -1e-6 * length:
				_cases.append(ROLLS_LATER)
			if room <= 1e-6 * length:
				_cases.append(ENDS_BEFORE)


func _room(distance: float, speed: float, rubs: float, length: float) -> float:
	var moments: PackedFloat64Array = [0.0, _roll_time]
	if rubs != 0.0:
		moments.append(clampf(-speed / rubs, 0.0, _roll_time))
	var least := INF
	for moment in moments:
		var place := distance + (speed + 0.5 * rubs * moment) * moment
		# At the start it may be at an end and leave it.
		if moment > 0.0:
			least = minf(least, minf(place, length - place))
	if distance == 0.0 or distance == length:
		var outwards := speed < 0.0 if distance == 0.0 else speed > 0.0
		least = minf(least, -1.0 if outwards else 0.0)
	return least


func _is_impact() -> bool:
	return _kind in [_WALL, _PADDLE]


func _meets() -> bool:
	return not is_nan(_met.time) or _met.is_edge


func _misses() -> bool:
	return is_nan(_met.time) or _met.is_edge


func _shows() -> bool:
	match _mistake:
		0:
			return false
		_BELT_SPEED:
			return _kind in [_BELT, _PLATFORM] and ROLLS_LATER in _cases
		_LATE:
			return _kind == _PLATFORM
		_TIP:
			return _kind == _PADDLE and not is_nan(_met.time)
		_TWICE:
			return _is_impact() and not is_nan(_met.time)
	return _kind == _PRESS or _is_impact() and not is_nan(_met.time)


# Whether the mistake comes to the same.
func _is_same() -> bool:
	# Where rounding decides what becomes of the disc, both may be said.
	if not _shows() or _mistake == _BELT_SPEED and _cases.size() > 1:
		return true
	if _is_impact():
		var size := _met.leaving.size() + _met.velocity.size() + _met.wall.size()
		return _met.wrong.plus(_met.leaving, -1.0).size() <= 1e-6 * size + 1e-9
	return false


func _differs() -> bool:
	if not _shows():
		return false
	return not _is_impact() or _met.wrong.plus(_met.leaving, -1.0).size() > 0.0 or _met.is_edge


func _claims_of_sentences() -> Dictionary[String, bool]:
	var is_level := _pull == 0.0
	var disc := _kind in [_BELT, _PLATFORM]
	var meets := _is_impact() and _meets()
	return {
		"they do not meet": _is_impact() and _misses(),
		"The paddle turns with ω": _step == 0 and _kind == _PADDLE and meets,
		"The wall comes, too": _step == 0 and _kind == _WALL and meets,
		"moves across its arm r": _step == _FRAME and _kind == _PADDLE and meets,
		"Seen from the wall, the wall rests": _step == _FRAME and _kind == _WALL and meets,
		"There the law is that of a wall at rest": _step == _LAW and meets,
		"Seen from the lab again, w is added": _step == _BACK and meets,
		"Nothing slips, and it rolls at once": _step == _BACK and _is_case(_BELT, ROLLS),
		"A third of u goes into the flight":
		_step == _BACK and _is_case(_BELT, ROLLS_LATER) and is_level,
		"no belt holds a disc": _step == _BACK and _is_case(_BELT, ROLLS_LATER) and not is_level,
		"The belt ends before u is 0": _step == _BACK and _is_case(_BELT, ENDS_BEFORE),
		"Friction is too weak to end the slip": _step == _BACK and _is_case(_BELT, SLIPS),
		"A disc that does not turn is put on the belt": _step == 0 and _kind == _BELT,
		"Seen from the belt": _step == _FRAME and _kind == _BELT,
		"Here µ is 0": _step == _LAW and disc and _friction == 0.0,
		"Nothing slips, so there is no friction": _step == _LAW and disc and _slip == 0.0,
		"Friction f = µ N works against u":
		_step == _LAW and disc and _friction > 0.0 and _slip != 0.0,
		"It keeps a third of V": _step == _BACK and _is_case(_PLATFORM, ROLLS_LATER),
		"It comes to the end of the platform": _step == _BACK and _is_case(_PLATFORM, ENDS_BEFORE),
		"Without friction it keeps V": _step == _BACK and _is_case(_PLATFORM, SLIPS),
		"The disc lies on the platform": _step == 0 and _kind == _PLATFORM,
		"The platform has −V at once": _step == _FRAME and _kind == _PLATFORM,
		"The ball bounces between two walls": _step == 0 and _kind == _PRESS,
		"Seen from the wall that moves": _step == _FRAME and _kind == _PRESS,
		"It leaves that wall with U": _step == _LAW and _kind == _PRESS,
		"Each such bounce adds 2 V": _step == _BACK and _kind == _PRESS,
		"Without end the bounces come faster": _step == _FLY and _kind == _PRESS,
		"What the mistake does is red": _step == _FLY and _differs(),
		"it comes to where the formulas have it":
		_step == _FLY and _is_same() and _kind != _PRESS and (not _is_impact() or _meets()),
	}


func _is_case(kind: int, case: int) -> bool:
	return _kind == kind and case in _cases


func _problem_of_card(seen: SeenLesson) -> String:
	if seen.verdict.is_empty():
		return ""
	if _step < _BACK:
		return "it is not known yet: “%s”" % seen.verdict[0]
	return first_of(
		[
			false_claim(seen.verdict, _claims_of_card()),
			_problem_of_sign(seen),
			_problem_of_numbers(seen.verdict),
			_problem_of_velocity(seen.verdict),
			_problem_of_miss(seen.verdict),
		]
	)


func _claims_of_card() -> Dictionary[String, bool]:
	var is_answer := _step == _BACK
	var disc := _kind in [_BELT, _PLATFORM]
	var has_mistake := _mistake != 0 and _differs()
	return {
		"after 3 bounces off it: ": is_answer and _kind == _PRESS,
		"way left then: ": is_answer and _kind == _PRESS,
		"they meet after ": is_answer and _is_impact() and _meets(),
		"v′ = ": is_answer and _is_impact() and _meets(),
		"carried for ": is_answer and _kind == _PLATFORM,
		"it rolls at once": is_answer and disc and ROLLS in _cases,
		"it slips for ": is_answer and disc and ROLLS_LATER in _cases,
		"then it rolls with ": is_answer and disc and ROLLS_LATER in _cases,
		"it comes to an end before it rolls": is_answer and disc and ENDS_BEFORE in _cases,
		"it slips all the way": is_answer and disc and SLIPS in _cases,
		"no impact within 20 s": _is_impact() and _misses(),
		"crushed after ": _step == _FLY and _kind == _PRESS,
		"px; ε × condition": _step == _FLY and (not _is_impact() or _meets()),
		"the mistake changes nothing here": _mistake != 0 and _is_same(),
		"the mistake: v′ = ": has_mistake and _is_impact(),
		"the mistake: ": has_mistake and not _is_impact(),
	}


func _problem_of_sign(seen: SeenLesson) -> String:
	var is_so: Dictionary[String, bool] = {
		"": true,
		"!": not _is_impact() or _meets(),
		"0": _is_impact() and _misses(),
		"✗": _differs(),
	}
	var is_right: bool = is_so.get(seen.verdict_sign, false)
	return "" if is_right else "the ball of the card has a “%s”" % seen.verdict_sign


func _problem_of_numbers(verdict: PackedStringArray) -> String:
	var speed := _speed + 6.0 * _surface_speed
	var wrong_speed := -_surface_speed if _kind == _PLATFORM else _surface_speed
	if _kind == _PRESS:
		wrong_speed = _speed + (3.0 * _surface_speed if _mistake == _ONCE else 0.0)
	var wanted: Dictionary[String, float] = {
		"after 3 bounces off it: ": speed,
		"way left then: ": _way * (_speed - _surface_speed) / (speed - _surface_speed),
		"carried for ": _way / _surface_speed,
		"it slips for ": _roll_time,
		"crushed after ": _way / _surface_speed,
		"the mistake: ": _surface_speed / 60.0 if _mistake == _LATE else wrong_speed,
	}
	if _is_impact() and not _met.is_edge:
		wanted["they meet after "] = _met.time
	var found := false_number(verdict, wanted, 0.0)
	if found:
		return found
	var size := absf(_speed) + absf(_surface_speed) + absf(_slip)
	return false_number(
		verdict, {"then it rolls with ": _roll_speed} as Dictionary[String, float], 1e-12 * size
	)


func _problem_of_velocity(verdict: PackedStringArray) -> String:
	if not _is_impact() or is_nan(_met.time) or _met.is_edge:
		return ""
	var rounding := (
		1e-9 * (_met.velocity.size() + _met.leaving.size() + _met.wrong.size() + _met.wall.size())
	)
	for line in verdict:
		var is_wrong := line.begins_with("the mistake: v′ = ")
		if not is_wrong and not line.begins_with("v′ = "):
			continue
		var wanted := _met.wrong if is_wrong else _met.leaving
		if not is_pair(line.get_slice("v′ = ", 1), wanted.x, wanted.y, rounding):
			return "it is (%s, %s): “%s”" % [wanted.x, wanted.y, line]
	return ""


func _problem_of_miss(verdict: PackedStringArray) -> String:
	for line in verdict:
		var miss := SeenLesson.number_behind("miss ", line)
		var rounding := SeenLesson.number_behind("; ε × condition ", line)
		if not is_nan(miss) and not miss <= _MOST_ROUNDINGS * rounding:
			return "a miss of %s is more than rounding alone, %s" % [miss, rounding]
	return ""


func _problem_of_rows(seen: SeenLesson) -> String:
	for row in seen.rows:
		if _step != _FLY:
			return "the table comes before the last step"
		var is_right := true
		var error := SeenLesson.first_number(row[2])
		if _kind == _PRESS:
			var shown := SeenLesson.first_number(row[1])
			is_right = SeenLesson.is_close(shown, _way / _surface_speed, 0.0)
			is_right = is_right and error <= 1e-15 * _way / _surface_speed
		elif _is_impact():
			is_right = _is_velocity_row(row, error)
		elif row[1] == "none":
			is_right = ENDS_BEFORE in _cases or SLIPS in _cases
		else:
			var size := absf(_speed) + 2.0 * absf(_surface_speed)
			var shown := SeenLesson.first_number(row[1])
			is_right = SeenLesson.is_close(shown, _roll_speed, 1e-12 * (size + absf(_slip)))
			is_right = is_right and not error > 1e-14 * size
		if not is_right:
			return "it is not so: “%s”" % "  ".join(row)
	return ""


func _is_velocity_row(row: PackedStringArray, error: float) -> bool:
	if row[1] == "none":
		return _misses()
	if not _meets():
		return false
	if is_nan(_met.time) or _met.is_edge:
		return true
	var size := _met.velocity.size() + _met.leaving.size() + _met.wall.size()
	# A wall that is far away has a less exact normal.
	return is_pair(row[1], _met.leaving.x, _met.leaving.y, 1e-9 * size) and not error > 1e-12 * size


func _claims_of_labels() -> Dictionary[String, bool]:
	var meets := _is_impact() and _meets() or _kind == _PRESS
	var is_late_press := _kind == _PRESS and _step >= _BACK
	var rolls := ROLLS in _cases or ROLLS_LATER in _cases
	var has_v := _step in [0, _FRAME, _FLY] or _misses()
	return {
		"v": _kind == _BELT or _is_impact() and has_v,
		"u₀": _kind == _PRESS and _step <= _FRAME,
		"w": _kind == _WALL or _kind == _PADDLE and meets and _step in [_FRAME, _BACK],
		"s": _kind == _BELT,
		"V": _kind in [_PLATFORM, _PRESS],
		"r": _kind == _PADDLE and _step == _FRAME and meets,
		"U": meets and _step in [_FRAME, _LAW],
		"n": meets and _step == _LAW,
		"U′": meets and _step in [_LAW, _BACK] and not is_late_press,
		"u": _kind in [_BELT, _PLATFORM] and _step == _FRAME,
		"f": _step == _LAW and _kind in [_BELT, _PLATFORM] and _friction > 0.0 and _slip != 0.0,
		"v′": _step >= _BACK and (_is_impact() and meets or rolls),
	}
