extends LessonJudge
## Judges what the proof of the projection says.

# What a turn or a product of doubles may be off by, as a share of the length of a.
const _ROUNDING := 1e-14
# What is written with four digits may be off by, as a share of it.
const _SHORT := 1.1e-3
const _UNIT := "b\u0302"
const _LAST_STEP := 6

var _a: PackedFloat64Array
var _b: PackedFloat64Array
var _a_length: float
var _b_length: float
# a after the whole turn.
var _turned_x: float
var _turned_y: float


func problem(seen: SeenLesson) -> String:
	_take(seen.state)
	return first_of(
		[
			false_claim([seen.sentence], _claims_of_sentences(seen)),
			_problem_of_card(seen),
			_problem_of_lines(seen.lines),
			_problem_of_rows(seen),
			false_label(_without_numbers(seen.labels), _claims_of_labels(seen.step)),
			false_number(seen.labels, {"bx = ": _b[0], "by = ": _b[1]}, 0.0),
			"" if not seen.notice else "nothing was refused: “%s”" % seen.notice,
		]
	)


func _take(state: Dictionary) -> void:
	_a = state["a"]
	_b = state["b"]
	_a_length = _length(_a[0], _a[1])
	_b_length = _length(_b[0], _b[1])
	_turned_x = 0.0
	_turned_y = 0.0
	if _has_direction():
		var unit_x := _b[0] / _b_length
		var unit_y := _b[1] / _b_length
		_turned_x = _a[0] * unit_x + _a[1] * unit_y
		_turned_y = _a[1] * unit_x - _a[0] * unit_y


# Divided first: squares of tiny numbers are 0.
static func _length(x: float, y: float) -> float:
	var largest := maxf(absf(x), absf(y))
	return largest * sqrt((x / largest) ** 2.0 + (y / largest) ** 2.0) if largest > 0.0 else 0.0


func _has_direction() -> bool:
	return _b_length > 0.0


# In this order of the steps.
func _claims_of_sentences(seen: SeenLesson) -> Dictionary[String, bool]:
	var by_step: PackedStringArray = [
		"Wanted: p, the shadow of a on b. What is its signed length, the scalar projection?",
		"Turn both by −β until b lies on the x axis. No length changes",
		"its signed length is the x of a′",
		"Turning by −β gives a′.x. Use cos(−β) = cos β and sin(−β) = −sin β",
		"The triangle of b holds cos β and sin β",
		"what comes out is a · %s. No angle is left in it" % _UNIT,
		"Both sides, computed in two ways",
	]
	var claims: Dictionary[String, bool] = {
		"b is zero: it has no direction, so there is no β": not _has_direction(),
		# While time runs at the first step.
		"Both turn by −β": _has_direction() and seen.step == 0,
	}
	for step in by_step.size():
		claims[by_step[step]] = _has_direction() and seen.step == step
	# What has been turned has another name.
	claims[by_step[0]] = claims[by_step[0]] and not "a′" in seen.labels
	return claims


func _problem_of_card(seen: SeenLesson) -> String:
	var is_shown := not seen.verdict.is_empty()
	if is_shown != (not _has_direction() or seen.step == _LAST_STEP):
		return "the card is shown at step %d" % seen.step if is_shown else "the card is missing"
	if not is_shown:
		return ""
	if not _has_direction():
		var is_zero := "\n".join(seen.verdict) == "b is zero: no direction, no shadow"
		return "" if is_zero and seen.verdict_sign == "0" else "b is zero: “%s”" % seen.verdict[0]
	var sides: PackedStringArray = []
	for line in seen.verdict.slice(0, 2):
		var side := line.get_slice(" = ", 0)
		if side != ["a′.x", "a · %s" % _UNIT][sides.size()]:
			return "the card begins with “%s”" % line
		sides.append(line.get_slice(" = ", 1))
		if absf(_number(sides[-1]) - _turned_x) > _ROUNDING * _a_length:
			return "it is %s: “%s”" % [_turned_x, line]
	return _problem_of_agreement(sides, seen.verdict[2], seen.verdict_sign)


# Both sides with all their digits are equal when their texts are.
func _problem_of_agreement(sides: PackedStringArray, words: String, sign_text: String) -> String:
	var one := _number(sides[0])
	var other := _number(sides[1])
	var is_equal := sides[0] == sides[1] or one == 0.0 and other == 0.0
	var units := _apart(sides[0], sides[1]) / _last_place(maxf(absf(one), absf(other)))
	var told := 1.0 if words.begins_with("1 unit ") else SeenLesson.first_number(words)
	var claims: Dictionary[String, bool] = {
		"equal to the last bit": is_equal,
		"1 unit in the last place apart": not is_equal,
		" units in the last place apart": not is_equal and told > 1.0,
		"Both mean 0: only rounding is left":
		not is_equal and absf(_turned_x) <= _ROUNDING * _a_length,
	}
	if sign_text != ("=" if is_equal else "≈"):
		return "the ball of the card has a “%s”" % sign_text
	if not is_nan(told) and absf(units - told) > 1.0 + _SHORT * units:
		return "they are %s units apart: “%s”" % [units, words]
	return false_claim([words], claims)


static func _last_place(value: float) -> float:
	return 2.0 ** (floorf(log(value) / log(2.0)) - 52.0) if value > 0.0 else 1.0


# The difference of two numbers with all their digits: exact, in whole numbers, where they are near.
static func _apart(one: String, other: String) -> float:
	var places := mini(_last_digit_place(one), _last_digit_place(other))
	var first := _whole_number(one, places)
	var second := _whole_number(other, places)
	if absf(_number(one) - _number(other)) > 1e-3 * absf(_number(one)):
		return absf(_number(one) - _number(other))
	return absi(first - second) * 10.0 ** places


# The power of ten of the last digit: -2 for 7.25 and 72.5e-1.
static func _last_digit_place(text: String) -> int:
	var mantissa := text.get_slice("e", 0)
	var power := (
		text.replace(NumberText.MINUS, "-").get_slice("e", 1).to_int() if "e" in text else 0
	)
	return power - (mantissa.get_slice(".", 1).length() if "." in mantissa else 0)


# The number as a multiple of this power of ten; the digits of a double fit into 64 bits.
static func _whole_number(text: String, place: int) -> int:
	var digits := text.get_slice("e", 0).replace(".", "").replace(NumberText.MINUS, "-")
	return (digits + "0".repeat(mini(_last_digit_place(text) - place, 18))).to_int()


# To a unit or two in the last place; the engine's own to_float loses more.
static func _number(text: String) -> float:
	var place := _last_digit_place(text)
	return _whole_number(text, place) * 10.0 ** place


# Where both vectors are, on the way and at its end. The other lines are read as formulas.
func _problem_of_lines(lines: PackedStringArray) -> String:
	for line in lines:
		if line.begins_with("on the way: "):
			var heads := _numbers_in_pairs(line)
			if not _is_on_the_way(heads.slice(0, 2), heads.slice(2, 4)):
				return "no turn leads there: “%s”" % line
		elif line.begins_with("a′ = ("):
			var wanted: PackedFloat64Array = [_turned_x, _turned_y, _b_length, 0.0]
			var shown := _numbers_in_pairs(line)
			for i in 4:
				var off := _ROUNDING * 100.0 * (_a_length if i < 2 else _b_length)
				if shown.size() != 4 or not SeenLesson.is_close(shown[i], wanted[i], off):
					return "they are %s: “%s”" % [wanted, line]
	return ""


# Lengths stay, and so does the angle between both.
func _is_on_the_way(a: PackedFloat64Array, b: PackedFloat64Array) -> bool:
	var keeps_a := absf(_length(a[0], a[1]) - _a_length) <= _SHORT * _a_length
	var keeps_b := absf(_length(b[0], b[1]) - _b_length) <= _SHORT * _b_length
	var turned := atan2(a[1], a[0]) - atan2(b[1], b[0])
	var wanted := atan2(_a[1], _a[0]) - atan2(_b[1], _b[0])
	var keeps_angle := _a_length == 0.0 or absf(wrapf(turned - wanted, -PI, PI)) < 4.0 * _SHORT
	return keeps_a and keeps_b and keeps_angle


static func _numbers_in_pairs(line: String) -> PackedFloat64Array:
	var numbers: PackedFloat64Array = []
	for part in line.split("(").slice(1):
		for number in part.get_slice(")", 0).split(", "):
			numbers.append(_number(number))
	return numbers


# Value and error, in this order; equal sides are off by the same.
func _problem_of_rows(seen: SeenLesson) -> String:
	if seen.rows.is_empty():
		return ""
	if seen.step != _LAST_STEP or not _has_direction():
		return "there is nothing to compare: “%s”" % "  ".join(seen.rows[0])
	for row in seen.rows:
		var found := _problem_of_row(row)
		if found:
			return found
	var is_equal := "equal to the last bit" in seen.verdict
	if is_equal and seen.rows[0][2] != seen.rows[1][2]:
		return "equal sides are off by the same: “%s”" % "  ".join(seen.rows[1])
	return ""


func _problem_of_row(row: PackedStringArray) -> String:
	var error := SeenLesson.first_number(row[2])
	var off := _ROUNDING * _a_length
	if not row[0] in ["x of a′", "a · %s" % _UNIT]:
		return "no row is known for “%s”" % row[0]
	if not error <= off or error < 0.0:
		return "the error cannot be %s: “%s”" % [error, "  ".join(row)]
	if not SeenLesson.is_close(SeenLesson.first_number(row[1]), _turned_x, off):
		return "it is %s: “%s”" % [_turned_x, "  ".join(row)]
	return ""


# `bx = 8` is `bx`; its number is judged by itself.
static func _without_numbers(labels: PackedStringArray) -> PackedStringArray:
	var found: PackedStringArray = []
	for label in labels:
		var is_side := label.begins_with("bx = ") or label.begins_with("by = ")
		found.append(label.left(2) if is_side else label)
	return found


func _claims_of_labels(step: int) -> Dictionary[String, bool]:
	var is_expanded := _has_direction() and step == 3
	var is_in_triangle := _has_direction() and step == 4
	return {
		"a": true,
		"b": true,
		"a′": _has_direction(),
		"b′": _has_direction(),
		"p": _has_direction(),
		"β = ": _has_direction() and step <= 4,
		"ax": is_expanded,
		"ay": is_expanded,
		"bx": is_in_triangle,
		"by": is_in_triangle,
	}
