extends LessonJudge
## Judges what the lesson on the distance from a line says.

# What a sum of doubles may be off by, as a share of its terms.
const _ROUNDING := 1e-13

# The steps of the distance, the gap and the segment, counted from 0.
const _DISTANCE := 2
const _GAP := 3
const _SEGMENT := 4
const _DETECTION := 5

const _BELOW_RADIUS := 0
const _ONLY_ABOVE := 1
const _BOTH_SIDES := 2
const _MOST_FRAMES := 12

const _SIGN := "the ball of the card has a “%s”"

const _NOT_UNIT := 10
const _WRONG_SIGN := 9
const _STRAIGHT_UP := -2

# Of the centre from the line, negative behind it.
var _distance: float
# Of the centre from the segment.
var _to_segment: float
var _radius: float
var _mistake: int
# What the mistake has for the distance.
var _wrong: float
# Along the line: 0 at its start, 1 at its end.
var _share: float
# What the distances may be off by.
var _off: float
# How far the ball of the last step moves in a frame, and where it is red.
var _speed: float
var _rule: int


func problem(seen: SeenLesson) -> String:
	_take(seen.state)
	return first_of(
		[
			_problem_of_card(seen),
			_problem_of_sentence(seen.sentence, seen.step),
			_problem_of_rows(seen.rows),
			_problem_of_labels(seen.labels, seen.step),
			_problem_of_time(seen),
		]
	)


func _take(state: Dictionary) -> void:
	var line: PackedFloat64Array = state["line"]
	var ball: PackedFloat64Array = state["ball"]
	_radius = ball[2]
	_mistake = state["mistake"]
	_speed = state["speed"]
	_rule = state["rule"]
	var along_x := line[2] - line[0]
	var along_y := line[3] - line[1]
	var length := sqrt(along_x * along_x + along_y * along_y)
	var way_x := ball[0] - line[0]
	var way_y := ball[1] - line[1]
	_distance = (way_y * (along_x / length)) - (way_x * (along_y / length))
	_share = (way_x * (along_x / length) + way_y * (along_y / length)) / length
	var sizes := absf(line[0]) + absf(line[1]) + absf(ball[0]) + absf(ball[1])
	_off = _ROUNDING * (sizes + length + _radius)
	var nearest := clampf(_share, 0.0, 1.0)
	var to_x := way_x - nearest * along_x
	var to_y := way_y - nearest * along_y
	_to_segment = sqrt(to_x * to_x + to_y * to_y)
	_wrong = _distance
	match _mistake:
		_NOT_UNIT:
			_wrong = _distance * length
			_off *= maxf(length, 1.0)
		_WRONG_SIGN:
			_wrong = -_distance
		_STRAIGHT_UP:
			_wrong = way_x * along_y / along_x - way_y if along_x != 0.0 else INF
			_off *= maxf(absf(along_y / along_x), 1.0) if along_x != 0.0 else 1.0


# Past an end of the segment, or nearly so.
func _is_beside_end(slack: float) -> bool:
	return _share < slack or _share > 1.0 - slack


# In how many frames up to this one the ball is red; rounding may make it one more or less.
func _red_counts(last: int) -> Array[int]:
	var counts: Array[int] = [0, 0]
	for frame: int in last + 1:
		for i: int in 2:
			var at := _distance - frame * _speed
			var slack := _off * (2.0 * i - 1.0)
			var is_red := at < _radius + slack
			if _rule == _ONLY_ABOVE:
				is_red = is_red and at >= -slack
			elif _rule == _BOTH_SIDES:
				is_red = absf(at) < _radius + slack
			counts[i] += int(is_red)
	return counts


func _last_frame() -> int:
	return clampi(ceili(minf((_distance + _radius) / _speed, _MOST_FRAMES)), 1, _MOST_FRAMES)


# Whether the ball may come from the good side and be red in no frame until it is behind the line.
func _can_be_never_seen() -> bool:
	var last := _last_frame()
	var is_behind := _distance - last * _speed < _off
	return _distance > -_off and is_behind and _red_counts(last)[0] == 0


func _problem_of_flight(seen: SeenLesson) -> String:
	var words := seen.verdict[0].replace("red in ", "").replace(" frames", "").split(" of ")
	var frames := int(words[1])
	var counts := _red_counts(frames - 1)
	if frames < 1 or frames > _last_frame() + 2:
		return "there are not so many frames: “%s”" % seen.verdict[0]
	if int(words[0]) < counts[0] or int(words[0]) > counts[1]:
		return "it is red in %s: “%s”" % [counts, seen.verdict[0]]
	if seen.verdict.size() > 1 and not _can_be_never_seen():
		return "it is seen: “%s”" % seen.verdict[1]
	var sign_text := "!" if int(words[0]) > 0 else "0"
	return "" if seen.verdict_sign == sign_text else _SIGN % seen.verdict_sign


func _problem_of_card(seen: SeenLesson) -> String:
	if seen.verdict.is_empty():
		return ""
	if seen.step == _DETECTION:
		return _problem_of_flight(seen)
	var gap := _distance - _radius
	var claims: Dictionary[String, bool] = {
		"Behind the line: gap": _distance < _off,
		"It just touches the line: gap 0": absf(gap) <= _off,
		"Too close: gap": gap < _off and _distance > -_off,
		"Free: gap": gap > -_off,
		"measured to the line without ends": _is_beside_end(1e-9),
		"but the gap to the segment is": _is_beside_end(1e-9),
		"d · n̂ is negative on this side": _distance < _off,
		"its centre is on the line": absf(_distance) <= _off,
		"on the good side, where n̂ points": _distance > -_off,
		"the mistake has no answer: this line is vertical": not is_finite(_wrong),
		"the mistake says: gap": _mistake != 0 and is_finite(_wrong),
	}
	var found := false_claim(seen.verdict, claims)
	if found:
		return found
	var wanted: Dictionary[String, float] = {
		"line: gap": gap,
		"Too close: gap": gap,
		"Free: gap": gap,
		"the gap to the segment is": _to_segment - _radius,
		"the mistake says: gap": _wrong - _radius,
	}
	found = false_number(seen.verdict, wanted, _off)
	if found:
		return found
	var signs: Dictionary[String, bool] = {
		"+": _distance > -_off, NumberText.MINUS: _distance < _off
	}
	return "" if signs.get(seen.verdict_sign, false) else _SIGN % seen.verdict_sign


func _problem_of_sentence(sentence: String, step: int) -> String:
	var is_compared := _mistake != 0 and step >= _DISTANCE and step < _DETECTION
	var is_last := step == _SEGMENT and not is_compared
	var claims: Dictionary[String, bool] = {
		"d leads from p": step == 0,
		"The unit normal n̂ is perpendicular to the line": step == 1,
		"d · n̂, the shadow of d on n̂, is the distance of c":
		step == _DISTANCE and not is_compared,
		"Subtract the radius": step == _GAP and not is_compared,
		"Compare the distance of the mistake": is_compared,
		"Past an end, the segment is farther away": is_last and _is_beside_end(1e-9),
		"The distance to the segment has no sign": is_last and _distance < _off,
		"a ball this fast jumps over the line and is never seen":
		step == _DETECTION and _can_be_never_seen(),
		"red where d · n̂ < r, far behind the line, too":
		step == _DETECTION and _rule == _BELOW_RADIUS,
		"red only in front of the line, closer than r": step == _DETECTION and _rule == _ONLY_ABOVE,
		"red on both sides of the line, closer than r": step == _DETECTION and _rule == _BOTH_SIDES,
		"A segment has ends. Here its distance is the same":
		is_last and not _is_beside_end(-1e-9) and _distance > -_off,
	}
	return false_claim([sentence], claims)


# The error of a value is what it is off by.
func _problem_of_rows(rows: Array[PackedStringArray]) -> String:
	for row in rows:
		var value := SeenLesson.first_number(row[1])
		var error := SeenLesson.first_number(row[2])
		if is_nan(value) or not SeenLesson.is_close(value, _distance, 1.1 * error + _off):
			return "it is %s: “%s”" % [_distance, "  ".join(row)]
	return ""


func _problem_of_labels(labels: PackedStringArray, step: int) -> String:
	var gap := _distance - _radius
	var has_gap := step in [_GAP, _SEGMENT]
	var is_compared := _mistake != 0 and step >= _DISTANCE and step < _DETECTION
	var is_so: Dictionary[String, bool] = {
		"line": true,
		"d": step < _DETECTION,
		"r": has_gap and _mistake == 0,
		"free": has_gap and gap > -_off,
		"touching": has_gap and absf(gap) <= _off,
		"too close": has_gap and gap < _off and _distance > -_off,
		"behind": has_gap and _distance < _off,
		"as if here": is_compared and is_finite(_wrong),
	}
	var wanted: Dictionary[String, float] = {}
	if has_gap and _mistake == 0:
		wanted["gap "] = gap
	if step == _SEGMENT and _is_beside_end(1e-9):
		wanted["segment "] = _to_segment
	if is_compared:
		wanted["right "] = _distance
		wanted["wrong "] = _wrong
	for label in labels:
		var begins := func(words: String) -> bool: return label.begins_with(words)
		if not is_so.get(label, wanted.keys().any(begins)):
			return "the board says “%s”" % label
	return false_number(labels, wanted, _off)


# What a step introduces is not shown before it.
func _problem_of_time(seen: SeenLesson) -> String:
	if seen.rows and seen.step < _DISTANCE:
		return "the table comes before the distance"
	if seen.verdict and seen.step < _GAP:
		return "the card comes before the gap"
	for line in seen.lines:
		if line.contains("wrong:") and (_mistake == 0 or seen.step < _DISTANCE):
			return "no wrong distance is shown yet: “%s”" % line
	return ""
