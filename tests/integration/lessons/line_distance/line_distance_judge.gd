extends LessonJudge
## Judges what the lesson on the distance from a line says.

# What a sum of doubles may be off by, as a share of its terms.
const _ROUNDING := 1e-13

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


func problem(seen: SeenLesson) -> String:
	_take(seen.state)
	for found: String in [
		_problem_of_card(seen),
		_problem_of_sentence(seen.sentence),
		_problem_of_rows(seen.rows),
		_problem_of_labels(seen.labels),
	]:
		if found:
			return found
	return ""


func _take(state: Dictionary) -> void:
	var line: PackedFloat64Array = state["line"]
	var ball: PackedFloat64Array = state["ball"]
	_radius = ball[2]
	_mistake = state["mistake"]
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


func _problem_of_card(seen: SeenLesson) -> String:
	if seen.verdict.is_empty():
		return ""
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
	found = _false_number(seen.verdict, wanted)
	if found:
		return found
	var is_so := _distance < _off if seen.verdict_sign == NumberText.MINUS else _distance > -_off
	return "" if is_so else "the ball of the card has a “%s”" % seen.verdict_sign


func _problem_of_sentence(sentence: String) -> String:
	var claims: Dictionary[String, bool] = {
		"d leads from p": true,
		"The unit normal n̂ is perpendicular to the line": true,
		"d · n̂ is the distance of c": true,
		"Subtract the radius": _mistake == 0,
		"Compare the distance of the mistake": _mistake != 0,
		"Beside an end the segment is farther away": _is_beside_end(1e-9),
		"The distance to the segment has no sign": _distance < _off,
		"Here the distance to the segment is the same":
		not _is_beside_end(-1e-9) and _distance > -_off,
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


func _problem_of_labels(labels: PackedStringArray) -> String:
	var gap := _distance - _radius
	var is_so: Dictionary[String, bool] = {
		"free": gap > -_off,
		"too close": gap < _off and _distance > -_off,
		"behind": _distance < _off,
	}
	for label in labels:
		if is_so.has(label) and not is_so[label]:
			return "the ball is called “%s”" % label
	var wanted: Dictionary[String, float] = {
		"gap ": gap, "segment ": _to_segment, "right ": _distance, "wrong ": _wrong
	}
	return _false_number(labels, wanted)


# The first number behind one of the words that is not the wanted one.
func _false_number(texts: PackedStringArray, wanted: Dictionary[String, float]) -> String:
	for text in texts:
		for words in wanted:
			var shown := SeenLesson.number_behind(words, text)
			if not is_nan(shown) and not SeenLesson.is_close(shown, wanted[words], _off):
				return "it is %s: “%s”" % [wanted[words], text]
	return ""
