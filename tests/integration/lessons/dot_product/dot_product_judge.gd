extends LessonJudge
## Judges what the lesson on the dot product says.

enum Step { VECTORS, UNIT, SCALAR, PROJECTION, REJECTION, SURE, BOTH, ANGLE, PRIMITIVE }

# What a sum of doubles may be off by, as a share of its terms.
const _ROUNDING := 1e-14

const _HATS: Dictionary[String, String] = {"a": "â", "b": "b\u0302"}

var _u_letter: String
var _w_letter: String
var _u_length: float
var _w_length: float
var _dot: float
# How long the rest is.
var _rest: float
# What the dot product may be off by.
var _off: float
var _normalizes: bool


func problem(seen: SeenLesson) -> String:
	_take(seen.state)
	return first_of(
		[
			_problem_of_order(seen),
			_problem_of_card(seen) if not seen.verdict.is_empty() else "",
			_problem_of_sentence(seen),
			_problem_of_rows(seen),
			_problem_of_labels(seen),
			"" if not seen.notice else "nothing was refused: “%s”" % seen.notice,
		]
	)


# u is the vector whose shadow falls on w.
func _take(state: Dictionary) -> void:
	var is_swapped: bool = state["is_swapped"]
	_u_letter = "b" if is_swapped else "a"
	_w_letter = "a" if is_swapped else "b"
	_normalizes = state["normalizes"]
	var u := _vector(state, _u_letter)
	var w := _vector(state, _w_letter)
	_u_length = sqrt(u[0] * u[0] + u[1] * u[1])
	_w_length = sqrt(w[0] * w[0] + w[1] * w[1])
	_dot = u[0] * w[0] + u[1] * w[1]
	_rest = 0.0
	if _w_length > 0.0:
		_rest = absf(u[0] * w[1] - u[1] * w[0]) / _w_length
	_off = _ROUNDING * (absf(u[0] * w[0]) + absf(u[1] * w[1]))


static func _vector(state: Dictionary, letter: String) -> PackedFloat64Array:
	var head: PackedFloat64Array = state[letter]
	var tail: PackedFloat64Array = state[letter + "_from"]
	return [head[0] - tail[0], head[1] - tail[1]]


# What the card must say of the scalar projection; with the usual mistake it is the dot product.
func _scalar() -> float:
	return _dot / _w_length if _normalizes else _dot


func _scalar_off() -> float:
	return _off / _w_length if _normalizes else _off


func _mistake_shows() -> bool:
	return not _normalizes and absf(_dot) > _off and absf(_w_length - 1.0) > _ROUNDING


# Where rounding alone decides, both may be said.
func _can_be_wrong() -> bool:
	return not _normalizes and _dot != 0.0 and _w_length != 1.0


func _problem_of_order(seen: SeenLesson) -> String:
	if seen.verdict.is_empty() == (seen.step < Step.SCALAR):
		return ""
	return "the card comes with the scalar projection, not at step %d" % (seen.step + 1)


func _problem_of_card(seen: SeenLesson) -> String:
	var has_both := _u_length > 0.0 and _w_length > 0.0
	var w_is_zero := "%s is zero: it has no direction" % _w_letter
	var u_is_zero := "zero: %s is zero, and so is its shadow" % _u_letter
	var claims: Dictionary[String, bool] = {
		"No projection": _w_length == 0.0,
		"Scalar projection": _w_length > 0.0,
		w_is_zero: _w_length == 0.0,
		u_is_zero: _w_length > 0.0 and _u_length == 0.0,
		"negative: the angle is above 90°": has_both and _dot < _off and not _mistake_shows(),
		"zero: the angle is 90°": has_both and absf(_dot) <= _off,
		"positive: the angle is below 90°": has_both and _dot > -_off and not _mistake_shows(),
		"wrong: |%s| =" % _w_letter: _can_be_wrong(),
	}
	var found := false_claim(seen.verdict, claims)
	if found:
		return found
	for line in seen.verdict:
		var scalar := SeenLesson.number_behind("Scalar projection", line)
		if not is_nan(scalar) and not SeenLesson.is_close(scalar, _scalar(), _scalar_off()):
			return "it is %s: “%s”" % [_scalar(), line]
		var times := SeenLesson.number_behind("wrong: |%s| =" % _w_letter, line)
		if not is_nan(times) and not SeenLesson.is_close(times, _w_length, 0.0):
			return "|%s| is %s: “%s”" % [_w_letter, _w_length, line]
		if times == 1.0:
			return "once is not wrong: “%s”" % line
	return _problem_of_sign(seen.verdict_sign)


func _problem_of_sign(sign_text: String) -> String:
	var is_so := false
	match sign_text:
		"+":
			is_so = _dot > -_off and not _mistake_shows()
		"0":
			is_so = absf(_dot) <= _off
		NumberText.MINUS:
			is_so = _dot < _off and not _mistake_shows()
		"✗":
			is_so = _can_be_wrong()
	return "" if is_so else "the ball of the card has a “%s”" % sign_text


func _problem_of_sentence(seen: SeenLesson) -> String:
	var sentence := seen.sentence
	var step := seen.step
	var has_w := _w_length > 0.0
	var ends_at_head := absf(_dot - _w_length * _w_length) <= 1e-8 * _w_length * _w_length
	var is_right := has_w and _normalizes
	var is_wrong := has_w and not _normalizes
	var letters := {u = _u_letter, w = _w_letter, e = _HATS[_w_letter], v = _HATS[_u_letter]}
	var is_both := has_w and _u_length > 0.0 and step == Step.BOTH
	var is_level := absf(_u_length - _w_length) <= _ROUNDING * _u_length
	var differs := absf(_dot) > 0.0 and _u_length != _w_length
	var q_is_u := absf(_dot - _u_length * _u_length) <= 1e-8 * _u_length * _u_length
	var claims: Dictionary[String, bool] = {
		"A vector is a difference": step == Step.VECTORS,
		"{w} is zero: it has no direction, and no shadow": not has_w and step > Step.VECTORS,
		"{u} is zero: it has no direction, and there is no angle":
		has_w and _u_length == 0.0 and step >= Step.ANGLE,
		"Divide {w} by its length": is_right and step == Step.UNIT,
		"The dot product with {e} is the scalar projection": is_right and step == Step.SCALAR,
		"{e} times the scalar projection is":
		is_right and step == Step.PROJECTION and not ends_at_head,
		"Here it is {w} itself": is_right and step == Step.PROJECTION and ends_at_head,
		"What is left of {u}, the rest {u} − p, is perpendicular to {w}":
		is_right and step == Step.REJECTION and _rest > 0.0,
		"Nothing is left of {u} here: the rest {u} − p is zero":
		is_right and step == Step.REJECTION and _rest <= _ROUNDING * _u_length,
		"Here {w} is NOT divided by its length": is_wrong and step == Step.UNIT,
		"The dot product with {w} itself": is_wrong and step == Step.SCALAR,
		"That times {w} is |{w}|² times the shadow": is_wrong and step == Step.PROJECTION,
		"The rest {u} − p is not perpendicular to {w}":
		has_w and _can_be_wrong() and step == Step.REJECTION,
		"the mistake changes nothing":
		is_wrong and not _mistake_shows() and step in [Step.REJECTION, Step.SURE],
		"Be sure of it. Try: drag {u}. Measure p": is_right and step == Step.SURE,
		"Measured, p has a wrong length": has_w and _can_be_wrong() and step == Step.SURE,
		"{u} is zero: it has no direction, and no shadow falls on it":
		has_w and _u_length == 0.0 and step == Step.BOTH,
		"{u} · {e} is not {w} · {v}": is_both and _normalizes and differs and not q_is_u,
		"Here the shadow q is {u} itself": is_both and _normalizes and q_is_u and differs,
		"Both shadows are equally long here": is_both and _normalizes and is_level,
		"At a right angle both shadows are zero": is_both and _normalizes and absf(_dot) <= _off,
		"Without dividing, both are {u} · {w}": is_both and not _normalizes,
		"The scalar projection is |{u}| cos φ": has_w and _u_length > 0.0 and step == Step.ANGLE,
		"The primitive way": has_w and _u_length > 0.0 and step == Step.PRIMITIVE,
	}
	var with_letters: Dictionary[String, bool] = {}
	for words in claims:
		with_letters[words.format(letters)] = claims[words]
	# Of two that are there, the chance is the one that says more.
	if sentence.contains("Here it is %s itself" % _w_letter):
		with_letters.erase("{e} times the scalar projection is".format(letters))
	if sentence.contains("Here the shadow q is %s itself" % _u_letter):
		with_letters.erase("{u} · {e} is not {w} · {v}".format(letters))
	return false_claim([sentence], with_letters)


# Value and error, in this order; the error is what the value is off by.
func _problem_of_rows(seen: SeenLesson) -> String:
	var rows := seen.rows
	if rows.is_empty():
		return ""
	if _w_length == 0.0 or seen.step != Step.PRIMITIVE:
		return "there is nothing to compare: “%s”" % "  ".join(rows[0])
	for row in rows:
		var value := SeenLesson.first_number(row[1])
		var error := SeenLesson.first_number(row[2])
		var right := _dot / _w_length
		var off := _ROUNDING * _u_length + 1.1 * error
		if is_nan(value) or not SeenLesson.is_close(value, right, off):
			return "it is %s: “%s”" % [right, "  ".join(row)]
		if row[0].ends_with("by the dot product"):
			if not SeenLesson.is_close(value, _scalar(), off):
				return "it is %s: “%s”" % [_scalar(), "  ".join(row)]
	return ""


# What is measured stands behind the sign of equality.
func _problem_of_labels(seen: SeenLesson) -> String:
	var labels: PackedStringArray = []
	for label in seen.labels:
		labels.append("|p| = " if label.begins_with("|p| = ") else label)
	var length := absf(_scalar()) * (1.0 if _normalizes else _w_length)
	var off := absf(_scalar_off()) * (1.0 if _normalizes else _w_length)
	return first_of(
		[
			false_label(labels, _claims_of_labels(seen.step)),
			false_number(seen.labels, {"|p| =": length}, off),
		]
	)


func _claims_of_labels(step: int) -> Dictionary[String, bool]:
	var has_w := _w_length > 0.0
	var has_angle := has_w and _u_length > 0.0
	return {
		"a": true,
		"b": true,
		_HATS[_w_letter]: has_w and _normalizes and step >= Step.UNIT and step != Step.SURE,
		"φ = ": has_angle and step >= Step.SCALAR,
		"p": has_w and step >= Step.PROJECTION,
		"%s − p" % _u_letter: has_w and _normalizes and step == Step.REJECTION and _rest > 0.0,
		"|p| = ": has_w and step == Step.SURE,
		"q": has_angle and _normalizes and step == Step.BOTH,
		"α = ": has_angle and step == Step.PRIMITIVE,
		"β = ": has_angle and step == Step.PRIMITIVE,
	}
