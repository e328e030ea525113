extends LessonJudge
## Judges what the lesson on normals says.

# What a double may be off by, as a share of itself.
const _ROUNDING := 1e-14

var _x: float
var _y: float
var _length: float
var _times: float
var _is_y_up: bool
var _mistake: int


func problem(seen: SeenLesson) -> String:
	_take(seen.state)
	return first_of(
		[
			false_claim([seen.sentence], _claims_of_sentences(seen.step)),
			false_claim(seen.verdict, _claims_of_card()),
			_problem_of_sign(seen.verdict_sign),
			_problem_of_order(seen),
			_problem_of_card_numbers(seen.verdict),
			_problem_of_rows(seen.rows),
			false_label(seen.labels, _claims_of_labels(seen)),
			_problem_of_labels(seen.labels),
			"" if not seen.notice else "nothing was refused: “%s”" % seen.notice,
		]
	)


func _take(state: Dictionary) -> void:
	var line: PackedFloat64Array = state["line"]
	_x = line[2] - line[0]
	_y = line[3] - line[1]
	# Scaled first: squares of tiny numbers are 0.
	var largest := maxf(absf(_x), absf(_y))
	_length = 0.0
	if largest > 0.0:
		_length = largest * sqrt((_x / largest) ** 2.0 + (_y / largest) ** 2.0)
	_times = state["times"]
	_is_y_up = Conventions.is_y_up()
	_mistake = state["mistake"]


func _is_zero() -> bool:
	return _length == 0.0


# Whether the mistake leads to a wrong vector; near a length of 1, rounding decides.
func _can_show() -> bool:
	match _mistake:
		6:
			return _is_zero()
		7:
			return not _is_zero() and _length < 1.0 + _ROUNDING
	return _mistake == 9 and not _is_zero()


func _can_hide() -> bool:
	match _mistake:
		6:
			return not _is_zero()
		7:
			return _is_zero() or _length >= 1.0 - _ROUNDING
	return _mistake == 9 and _is_zero()


func _claims_of_sentences(step: int) -> Dictionary[String, bool]:
	var is_plain := _mistake == 0 and not _is_zero()
	var is_zero := _mistake == 0 and _is_zero()
	return {
		"A line has a direction": is_plain and step == 0,
		"+90°, clockwise: x now runs along y": is_plain and step == 1 and not _is_y_up,
		"+90°, counter-clockwise: x now runs along y": is_plain and step == 1 and _is_y_up,
		"(y, −x) is the opposite normal": is_plain and step == 2,
		"Divide by the length: v̂ is v normalized": is_plain and step == 3,
		"In pixels, length 1 is too short to see": is_plain and step == 4,
		"v is zero: a point has no direction": is_zero and step == 0,
		"v is zero: (−y, x) is (0, 0), which is no normal": is_zero and step == 1,
		"v is zero: (y, −x) is (0, 0), too": is_zero and step == 2,
		"v is zero: never divide by its length": is_zero and step == 3,
		"v is zero: there is no n̂ to draw": is_zero and step == 4,
		"Mistake 9 is on": _mistake == 9,
		"Mistake 6 is on. It shows only if v is zero": _mistake == 6 and not _is_zero(),
		"Mistake 6 is on: it divides by a length of 0": _mistake == 6 and _is_zero(),
		"Mistake 7 is on: int() cuts the length to 0": _mistake == 7 and _can_show(),
		"Mistake 7 is on. It shows only if v is shorter than 1, but not zero":
		_mistake == 7 and _can_hide(),
	}


func _claims_of_card() -> Dictionary[String, bool]:
	var is_about_angle := _mistake == 9 and not _is_zero()
	return {
		"+90° turns clockwise": not _is_y_up and not _is_zero(),
		"+90° turns counter-clockwise": _is_y_up and not _is_zero(),
		"y points down": not _is_y_up,
		"y points up": _is_y_up,
		"The zero vector": _is_zero(),
		"has no direction and no normal": _is_zero(),
		"Here the mistake": _can_hide(),
		"does not show": _can_hide(),
		"from v, not +90°": is_about_angle and _y != 0.0,
		"+90° by luck, as y is 0": is_about_angle and _y == 0.0,
		"nearly +90°": is_about_angle and absf(_y) < 1e-14 * absf(_x),
		"−90°, the other side": is_about_angle,
		"wrong:": _mistake in [6, 7] and _can_show(),
		"right:": _mistake in [6, 7] and _can_show(),
	}


func _problem_of_sign(sign_text: String) -> String:
	var is_so := true
	match sign_text:
		"✗":
			is_so = _can_show()
		"0":
			is_so = _is_zero()
		"=":
			is_so = _can_hide() and not _is_zero()
		"+":
			is_so = _mistake == 0 and not _is_zero()
	return "" if is_so else "the ball of the card has a “%s”" % sign_text


# The unit normal, and the angle from v to (y, x), which is mirrored at the diagonal.
func _problem_of_card_numbers(lines: PackedStringArray) -> String:
	for line in lines:
		if line.begins_with("right: ") and not _is_unit_normal(line.trim_prefix("right: ")):
			return "it is (%s, %s): “%s”" % [-_y / _length, _x / _length, line]
		if line.begins_with("wrong: "):
			var wanted := "(0, 0)" if _mistake == 7 else "(NaN, NaN)"
			if line != "wrong: " + wanted:
				return "it is %s: “%s”" % [wanted, line]
		var shown := SeenLesson.degrees_behind("(y, x):", line)
		if is_nan(shown) or not in_degrees(line).ends_with("not +90°"):
			continue
		var degrees := wrapf(90.0 - 2.0 * rad_to_deg(atan2(_y, _x)), -180.0, 180.0)
		var off := absf(wrapf(shown - degrees, -180.0, 180.0))
		if off > 0.0051 * absf(degrees) + 1e-9 or shown == 90.0:
			return "it is %s: “%s”" % [degrees, line]
	return ""


func _is_unit_normal(text: String) -> bool:
	var numbers := text.trim_prefix("(").trim_suffix(")").split(", ")
	if _is_zero():
		return text == "(0, 0)"
	var is_x := absf(SeenLesson.first_number(numbers[0]) + _y / _length) < 1e-3
	return is_x and absf(SeenLesson.first_number(numbers[1]) - _x / _length) < 1e-3


# Of a zero vector the way by the angle makes a unit vector, which is off by 1.
func _problem_of_rows(rows: Array[PackedStringArray]) -> String:
	for row in rows:
		var is_lost := _is_zero() and row[0] == "by the angle"
		var error := SeenLesson.first_number(row[2])
		if is_lost != (error == 1.0) or not is_lost and error > _ROUNDING:
			return "the error cannot be %s: “%s”" % [error, "  ".join(row)]
		if not is_lost and not _is_unit_normal(row[1]):
			return "it is no unit normal: “%s”" % "  ".join(row)
	return ""


# The card comes with the normal, the table with the unit normal; a mistake is beside the steps.
func _problem_of_order(seen: SeenLesson) -> String:
	if seen.verdict.is_empty() != (seen.step < 1 and _mistake == 0):
		return "the card is for later than step %d, or missing" % (seen.step + 1)
	if seen.rows.is_empty() != (seen.step < 3):
		return "the table is for later than step %d, or missing" % (seen.step + 1)
	return ""


func _claims_of_labels(seen: SeenLesson) -> Dictionary[String, bool]:
	var is_plain := _mistake == 0 and not _is_zero()
	var is_about_unit := _mistake in [6, 7] and not _is_zero()
	var claims: Dictionary[String, bool] = {
		"v": true,
		"n": not _is_zero() and (_mistake != 0 or seen.step >= 1),
		"−n": is_plain and seen.step >= 2,
		"n̂": is_about_unit or is_plain and seen.step >= 3,
		"v̂": is_plain and seen.step == 3,
		"✗ (y, x)": _mistake == 9 and not _is_zero(),
		"✗ (y, −x)": _mistake == 9 and not _is_zero(),
		"✗ (0, 0)": _mistake == 7 and _can_show(),
	}
	for label in seen.labels:
		if label.ends_with(" n̂"):
			claims[label] = is_plain and seen.step == 4
	return claims


func _problem_of_labels(labels: PackedStringArray) -> String:
	for label in labels:
		var times := SeenLesson.first_number(label)
		if label.ends_with(" n̂") and not SeenLesson.is_close(times, _times, 0.0):
			return "it is drawn %s times: “%s”" % [_times, label]
	return ""
