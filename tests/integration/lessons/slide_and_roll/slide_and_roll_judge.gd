extends LessonJudge
## Judges what the lesson on sliding and rolling says.

# What rounding may make of a comparison or a number, as a share of its terms.
const _ROUNDING := 1e-9
const _FRAME := 1.0 / 60.0

# The steps, counted from 0.
const _PULL := 1
const _SLIP := 2
const _MARK := 3
const _ROLL := 4
const _RACE := 5
const _ERROR := 6

const _THRESHOLD := 101
const _SPHERE := 102
const _STOPS := 103
const _WITHOUT_SPIN := 104

var _width: float
var _height: float
var _length: float
var _friction: float
var _speed: float
var _mistake: int
# Gravity along the line and onto it, and friction.
var _pull: float
var _pressure: float
var _grip: float
# When it rolls, if the line is long enough; NAN where it never does. And where it is then.
var _change: float
var _change_way: float
# When it is at the end; NAN where nothing moves it.
var _end: float


func problem(seen: SeenLesson) -> String:
	_take(seen.state)
	return first_of(
		[
			false_claim([seen.sentence], _claims_of_sentences(seen.step)),
			false_claim(seen.verdict, _claims_of_card(seen.step)),
			_problem_of_numbers(seen.verdict),
			_problem_of_sign(seen),
			_problem_of_rows(seen.rows),
			_problem_of_labels(seen.labels, seen.step),
			_problem_of_time(seen),
		]
	)


func _take(state: Dictionary) -> void:
	var start: PackedFloat64Array = state["start"]
	var end: PackedFloat64Array = state["end"]
	var gravity: float = state["gravity"]
	_friction = state["friction"]
	_speed = state["speed"]
	_mistake = state["mistake"]
	_width = end[0] - start[0]
	_height = end[1] - start[1]
	_length = sqrt(_width * _width + _height * _height)
	_pull = gravity * _height / _length
	_pressure = gravity * _width / _length
	_grip = _friction * _pressure
	_change = _change_with(3.0)
	_change_way = _way(_change, _pull - _grip) if not is_nan(_change) else INF
	_end = NAN if _rests() else _time_with(_change, _pull - _grip, _pull * 2.0 / 3.0)


# When a body rolls from whose slip friction takes so many times itself.
func _change_with(share: float) -> float:
	var fades := share * _grip - _pull
	if fades < 0.0 or fades == 0.0 and _speed > 0.0:
		return NAN
	return _speed / fades if _speed > 0.0 else 0.0


# How far it is after some seconds with one acceleration.
func _way(seconds: float, acceleration: float) -> float:
	return (_speed + 0.5 * acceleration * seconds) * seconds


# When it is at the end, with one acceleration until it rolls and then with another.
func _time_with(change: float, first: float, second: float) -> float:
	if is_nan(change) or _way(change, first) >= _length:
		return _time_for(_length, _speed, first)
	var left := _length - _way(change, first)
	return change + _time_for(left, _speed + first * change, second)


static func _time_for(way: float, speed: float, acceleration: float) -> float:
	return 2.0 * way / (speed + sqrt(maxf(speed * speed + 2.0 * acceleration * way, 0.0)))


func _rests() -> bool:
	return _height == 0.0 and _speed == 0.0


# Where rounding decides, both hold.
func _can_roll() -> bool:
	return 3.0 * _grip >= _pull * (1.0 - _ROUNDING)


func _can_slip() -> bool:
	return 3.0 * _grip <= _pull * (1.0 + _ROUNDING)


func _rolls_at_once() -> bool:
	return not _rests() and _speed == 0.0 and _can_roll()


func _rolls_later() -> bool:
	return _speed > 0.0 and _can_roll() and _change_way <= _length * (1.0 + _ROUNDING)


func _ends_before() -> bool:
	return _speed > 0.0 and _can_roll() and not _change_way < _length * (1.0 - _ROUNDING)


func _slips() -> bool:
	return not _rests() and _can_slip()


func _is_compared(step: int) -> bool:
	return _mistake != 0 and step >= _ROLL


# How far the ball of the mistake is when the right one is at the end.
func _wrong_way() -> float:
	var slips := _pull - _grip
	match _mistake:
		_THRESHOLD:
			return _way(_end, slips) if _grip < _pull else _length
		_SPHERE:
			var change := _change_with(3.5)
			if is_nan(change) or change >= _end:
				return _way(_end, slips)
			var rest := _end - change
			var then := _speed + slips * change
			return _way(change, slips) + (then + 0.5 * _pull * 5.0 / 7.0 * rest) * rest
		_STOPS:
			return _way(minf(_end, _stop()), slips)
		_WITHOUT_SPIN:
			return _way(_end, _pull)
	return _length


# When the ball stops by the mistake that friction stops it.
func _stop() -> float:
	return _speed / (_grip - _pull) if _grip > _pull else INF


func _lead() -> float:
	return _wrong_way() - _length


func _is_same() -> bool:
	return _rests() or absf(_lead()) <= 1e-6 * _length


func _differs() -> bool:
	return not _rests() and absf(_lead()) >= 1e-12 * _length


func _claims_of_sentences(step: int) -> Dictionary[String, bool]:
	var is_level := _height == 0.0
	return {
		"Nothing moves the ball. Make": step == 0 and _rests(),
		"Without friction the ball keeps its speed": step == 0 and is_level and not _rests(),
		"Without friction the ball slides down": step == 0 and not is_level,
		"The line is level: gravity presses": step == _PULL and is_level,
		"Gravity pulls along the line with G": step == _PULL and not is_level,
		"Here µ is 0": step == _SLIP and _friction == 0.0,
		"Nothing slips, so": step == _SLIP and _rests() and _friction > 0.0,
		"Friction f brakes the ball": step == _SLIP and not _rests() and _friction > 0.0,
		"On the level tan is 0": step == _MARK and is_level,
		"from µ = tan / 3 on": step == _MARK and not is_level,
		"Nothing moves the ball: it stays": step == _ROLL and _rests(),
		"A third of G turns the ball": step == _ROLL and _rolls_at_once(),
		"It slips until t₁": step == _ROLL and _rolls_later(),
		"the line ends before the slip is 0": step == _ROLL and _ends_before(),
		"Friction is too weak": step == _ROLL and _slips() and _friction > 0.0,
		"Without friction it slips on": step == _ROLL and _slips() and _friction == 0.0,
		"Nobody wins": step == _RACE and _rests(),
		"Three balls race": step == _RACE and not _rests(),
		"Nothing moves, so there is nothing to measure": step == _ERROR and _rests(),
		"the ball trembles": step == _ERROR and (_rolls_at_once() or _rolls_later()),
		"the end is seen with the next frame": step == _ERROR and (_slips() or _ends_before()),
	}


func _claims_of_card(step: int) -> Dictionary[String, bool]:
	var is_compared := _is_compared(step)
	var stops := _mistake == _STOPS and not _wrong_can_arrive()
	return {
		"nothing moves": _rests(),
		"it rolls at once": _rolls_at_once(),
		"it rolls after": _rolls_later(),
		"the line ends before it rolls": _ends_before(),
		"it slips all the way": _slips(),
		"it does not come to the end": step >= _RACE and _rests(),
		"at the end after": step >= _RACE and not _rests(),
		"the mistake changes nothing here": is_compared and _is_same(),
		"the mistake: it stops after": is_compared and _differs() and stops,
		"px ahead": is_compared and _differs() and _lead() > 0.0,
		"px behind": is_compared and _differs() and _lead() < 0.0,
	}


# Whether what stops by the mistake is at the end before.
func _wrong_can_arrive() -> bool:
	var stop := _stop()
	return stop == INF or _way(stop, _pull - _grip) >= _length * (1.0 + _ROUNDING)


func _problem_of_numbers(verdict: PackedStringArray) -> String:
	for line in verdict:
		var words: Dictionary[String, float] = {
			"it rolls after ": _change, "at the end after ": _end, "it stops after ": _stop()
		}
		var wrong := false_number([line], words, 0.0)
		if wrong:
			return wrong
		if line.ends_with("ahead") or line.ends_with("behind"):
			var shown := SeenLesson.number_behind("the mistake: ", line)
			var off := absf(shown - absf(_lead()))
			if not off <= 0.006 * absf(_lead()) + 1e-12 * _length:
				return "it is %s: “%s”" % [absf(_lead()), line]
	return ""


func _problem_of_sign(seen: SeenLesson) -> String:
	var is_so: Dictionary[String, bool] = {
		"": true,
		"×": _rests(),
		"!": not _rests(),
		"✗": _is_compared(seen.step) and _differs(),
	}
	var is_right: bool = is_so.get(seen.verdict_sign, false)
	return "" if is_right else "the ball of the card has a “%s”" % seen.verdict_sign


func _problem_of_rows(rows: Array[PackedStringArray]) -> String:
	for row in rows:
		var is_formula := row[0] == "t, by the formula"
		var is_right := true
		if row[1] == "none":
			is_right = not is_formula or _rests()
		elif row[0].begins_with("slip"):
			is_right = _is_slip(row)
		else:
			is_right = not _rests() and _is_time(row, is_formula)
		if not is_right:
			return "it is at the end after %s: “%s”" % [_end, "  ".join(row)]
	return ""


# The time is shown with four digits.
func _is_time(row: PackedStringArray, is_formula: bool) -> bool:
	var time := SeenLesson.first_number(row[1])
	var error := SeenLesson.first_number(row[2])
	if is_formula:
		return SeenLesson.is_close(time, _end, _ROUNDING * _end) and error <= 1e-12 * _end
	return absf(error - absf(time - _end)) <= 0.06 * error + 1e-3 * time


# What rolls exactly does not slip, so all of it is error; and one frame of friction is too much.
func _is_slip(row: PackedStringArray) -> bool:
	var slip := SeenLesson.first_number(row[1])
	var error := SeenLesson.first_number(row[2])
	if not _rolls_at_once() and not _rolls_later() or _can_slip():
		return not is_nan(error)
	var most := (_pull + 3.0 * _grip) * _FRAME
	return absf(error - absf(slip)) <= 0.06 * error and absf(slip) <= most * 1.001


func _problem_of_labels(labels: PackedStringArray, step: int) -> String:
	var is_race := step >= _RACE
	var claims: Dictionary[String, bool] = {
		"v₀": step == 0 or is_race,
		"g": step == _PULL,
		"G": step >= _PULL and not is_race and _height > 0.0,
		"N": step >= _PULL and step <= _MARK,
		"f": step >= _SLIP and not is_race and _friction > 0.0 and not _rests(),
		"rolls": is_race,
		"µ = 0": is_race,
	}
	for label in labels:
		var friction := SeenLesson.number_behind("µ = ", label)
		if claims.has(label):
			if not claims[label]:
				return "it should not be on the board: “%s”" % label
		elif not is_race or not SeenLesson.is_close(friction, _friction, 0.0):
			return "µ is %s: “%s”" % [_friction, label]
	return ""


# What a step introduces is not shown before it.
func _problem_of_time(seen: SeenLesson) -> String:
	if seen.rows and seen.step < _RACE:
		return "the table comes before the race"
	if seen.verdict and seen.step < _ROLL:
		return "the card comes before it rolls"
	return ""
