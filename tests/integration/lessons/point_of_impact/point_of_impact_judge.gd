extends LessonJudge
## Judges what the lesson on the point of impact says.

# What a sum of doubles may be off by, as a share of its terms.
const _ROUNDING := 1e-13
const _NOTHING := 1e-15

# The steps, counted from 0.
const _RESET := 1
const _DISTANCES := 2
const _WAYS := 3
const _FRACTION := 4
const _IMPACT := 5

const _OVER_NEW := 15
const _UNSIGNED := 16
const _NOT_LIMITED := 17
const _FROM_NEW := 20

# Distances from the line before and after the frame, and the radius.
var _old: float
var _new: float
var _radius: float
# Of the way to the contact, and of the whole frame.
var _a: float
var _b: float
var _t: float
var _moment: float
var _mistake: int
# What the mistake has for t.
var _wrong: float
# What a distance may be off by, and t; a difference of distances up to this is nothing.
var _off: float
var _nothing: float
var _t_off: float
# Where the ball touches, and where the reset puts it.
var _impact: PackedFloat64Array
var _reset: PackedFloat64Array
var _is_at_rest: bool


func problem(seen: SeenLesson) -> String:
	_take(seen.state)
	var numbers := _wanted_numbers()
	return first_of(
		[
			false_claim([seen.sentence], _claims_of_sentences(seen.step)),
			false_claim(seen.verdict, _claims_of_card()),
			_problem_of_sign(seen.verdict_sign),
			false_number(seen.verdict, numbers, _t_off),
			_problem_of_rows(seen.rows),
			_problem_of_labels(seen.labels, seen.step),
			_problem_of_time(seen),
		]
	)


func _take(state: Dictionary) -> void:
	var line: PackedFloat64Array = state["line"]
	var old: PackedFloat64Array = state["old"]
	var new: PackedFloat64Array = state["new"]
	_radius = state["radius"]
	_moment = state["moment"]
	_mistake = state["mistake"]
	var length := sqrt((line[2] - line[0]) ** 2.0 + (line[3] - line[1]) ** 2.0)
	var normal_x := -(line[3] - line[1]) / length
	var normal_y := (line[2] - line[0]) / length
	_old = (old[0] - line[0]) * normal_x + (old[1] - line[1]) * normal_y
	_new = (new[0] - line[0]) * normal_x + (new[1] - line[1]) * normal_y
	_off = _radius
	for number: float in line + old + new:
		_off += absf(number)
	_nothing = _NOTHING * (_off - absf(line[2]) - absf(line[3]))
	_off *= _ROUNDING
	_a = _old - _radius
	_b = _old - _new
	_t = _a / _b
	_t_off = _off * (1.0 + absf(_t)) / absf(_b)
	_is_at_rest = old == new
	_wrong = _wrong_t()
	var share := clampf(_t, 0.0, 1.0)
	var back := _radius - _new
	_impact = [old[0] + share * (new[0] - old[0]), old[1] + share * (new[1] - old[1])]
	_reset = [new[0] + back * normal_x, new[1] + back * normal_y]


func _wrong_t() -> float:
	match _mistake:
		_OVER_NEW:
			_t_off += _off * (1.0 + absf(_a / _new)) / absf(_new)
			return _a / _new
		_UNSIGNED:
			var way := absf(_old) - absf(_new)
			_t_off += _off * (1.0 + absf((absf(_old) - _radius) / way)) / absf(way)
			return (absf(_old) - _radius) / way
		_FROM_NEW:
			_t_off += _off * (1.0 + absf((_new - _radius) / _b)) / absf(_b)
			return (_new - _radius) / _b
	return _t


# Where rounding may decide, both are so; but what it alone leaves of a difference is 0.


func _can_be_below_0(difference: float) -> bool:
	return difference < _off and absf(difference) > _nothing


func _can_be_above_0(difference: float) -> bool:
	return difference > -_off and absf(difference) > _nothing


func _is_in_frame() -> bool:
	return _can_be_above_0(_b) and _a > -_off and _is_new_at_line()


func _overlaps() -> bool:
	return _can_be_above_0(_b) and _can_be_below_0(_a)


# Whether a may be 0, or b: then there is another name for the case.
func _can_be_at_contact() -> bool:
	return _a > -_off or _b < _off


func _is_too_far() -> bool:
	return _can_be_above_0(_b) and _can_be_above_0(_new - _radius)


func _is_parallel() -> bool:
	return absf(_b) <= _off


func _moves_away() -> bool:
	return _can_be_below_0(_b)


func _can_touch() -> bool:
	return _is_in_frame() or _overlaps()


func _can_miss() -> bool:
	return _moves_away() or _is_parallel() or _is_too_far()


# Whether the new position overlaps the line, or touches it.
func _is_new_at_line() -> bool:
	return _new < _radius + _off


func _is_reset() -> bool:
	return _can_be_below_0(_new - _radius)


func _is_new_free() -> bool:
	return _new > _radius - _off


# Whether the wrong t is the right one, or the mistake is not to limit a t that is within 0..1.
func _can_change_nothing() -> bool:
	if _mistake == _NOT_LIMITED:
		return _is_in_frame()
	return absf(_wrong - _t) <= _t_off or _is_parallel()


func _divides_by_0() -> bool:
	match _mistake:
		_OVER_NEW:
			return absf(_new) <= _off
		_UNSIGNED:
			return absf(absf(_old) - absf(_new)) <= _off
	return _mistake != 0 and _is_parallel()


# From the impact to where the reset puts the ball.
func _reset_is_off() -> float:
	return sqrt((_reset[0] - _impact[0]) ** 2.0 + (_reset[1] - _impact[1]) ** 2.0)


func _claims_of_sentences(step: int) -> Dictionary[String, bool]:
	var is_compared := _mistake != 0 and step >= _FRACTION
	var is_fraction := step == _FRACTION and not is_compared
	var is_impact := step == _IMPACT and not is_compared
	var is_close := _reset_is_off() <= 100.0 * _off
	var is_off := _reset_is_off() > 0.01 * _off
	return {
		"One frame moves the ball by v": step == 0 and not _is_at_rest,
		"Old and new are the same point": step == 0 and _is_at_rest,
		"Position reset: back along n̂ until the ball touches": step == _RESET and _is_reset(),
		"Position reset: new does not overlap the line": step == _RESET and _is_new_free(),
		"old and new are now distances from the line, below 0 behind it": step == _DISTANCES,
		"a = old − r is the way along n̂ to the contact": step == _WAYS,
		"Compare the t of the mistake": is_compared,
		"0 is the start of the frame, 1 its end": is_fraction and _is_in_frame(),
		"t is below 0: the contact lies before this frame": is_fraction and _overlaps(),
		"t is above 1: the contact lies after this frame": is_fraction and _is_too_far(),
		"b is 0: there is nothing to divide by": is_fraction and _is_parallel(),
		"b is below 0: the ball moves away": is_fraction and _moves_away(),
		"POI = old + t v is on the path.": is_impact and _is_in_frame() and _is_new_free(),
		"POI = old + t v is on the path. The reset is not":
		is_impact and _is_in_frame() and _is_reset() and is_off,
		"POI = old + t v. Here the reset leads to the same place": is_impact and is_close,
		"The contact is at the start of the frame: t counts as 0": is_impact and _overlaps(),
		"No impact in this frame: the ball may go to new":
		is_impact and _can_miss() and _is_new_free(),
		"No impact in this frame, but new is behind the line":
		is_impact and _can_miss() and _can_be_below_0(_new),
		"No impact in this frame, but new is too close":
		is_impact and _can_miss() and _is_reset() and _new > -_off,
	}


func _claims_of_card() -> Dictionary[String, bool]:
	var is_finite_wrong := _mistake != 0 and not is_nan(_wrong) and not is_inf(_wrong)
	return {
		", within 0..1": _is_in_frame(),
		"it touches in this frame": _is_in_frame(),
		"it touches at the start of the frame, in old": _is_in_frame() and absf(_a) <= _off,
		"it touches at the end of the frame, in new":
		_is_in_frame() and absf(_new - _radius) <= _off,
		", below 0": _overlaps(),
		"too close already: contact at once": _overlaps() and _old > -_off,
		"behind the line already: contact at once": _overlaps() and _can_be_below_0(_old),
		", above 1": _is_too_far(),
		"no contact in this frame yet": _is_too_far(),
		"b is below 0": _moves_away(),
		"it moves away: no impact": _moves_away() and _a > -_off,
		"it is on its way out: no impact": _moves_away() and _can_be_below_0(_a),
		"v = 0: no t": _is_at_rest,
		"it does not move": _is_at_rest,
		"b = 0: no t": _is_parallel() and not _is_at_rest,
		"it moves along the line": _is_parallel() and not _is_at_rest,
		"the mistake divides by 0: the ball is lost": _divides_by_0(),
		"the mistake changes nothing here": _mistake != 0 and _can_change_nothing(),
		"the mistake takes t =": _mistake == _NOT_LIMITED and _can_miss() or _overlaps(),
		"the mistake says t =": is_finite_wrong and _mistake != _NOT_LIMITED,
	}


func _wanted_numbers() -> Dictionary[String, float]:
	if _mistake == 0:
		return {"t =": _t}
	return {"the mistake takes t =": _wrong, "the mistake says t =": _wrong}


func _problem_of_sign(sign_text: String) -> String:
	var is_so: Dictionary[String, bool] = {"": true, "!": _can_touch(), "×": _can_miss()}
	return "" if is_so.get(sign_text, false) else "the ball of the card has a “%s”" % sign_text


# The place, to three digits, and how far it is from the contact.
func _problem_of_rows(rows: Array[PackedStringArray]) -> String:
	for row in rows:
		var is_reset := row[0] == "reset"
		if row[1] == "none":
			if not (_is_new_free() if is_reset else _can_miss()):
				return "there is one: “%s”" % "  ".join(row)
			continue
		if not (_is_reset() if is_reset else _can_touch()):
			return "there is none: “%s”" % "  ".join(row)
		if not _is_place(row[1], _reset if is_reset else _impact):
			return "it is at %s: “%s”" % [_reset if is_reset else _impact, "  ".join(row)]
		var error := SeenLesson.first_number(row[2])
		if row[2] and not _is_in_frame():
			return "there is no contact to be off from: “%s”" % "  ".join(row)
		var right := _reset_is_off() if is_reset else 0.0
		# Three digits, or two of a small one.
		var unit := 0.0051 if right > 0.0009 else 0.051
		if row[2] and not absf(error - right) <= unit * right + _place_off():
			return "it is off by %s: “%s”" % [right, "  ".join(row)]
	return ""


func _is_place(text: String, place: PackedFloat64Array) -> bool:
	var numbers := text.trim_prefix("(").trim_suffix(")").split(", ")
	for i in 2:
		var shown := SeenLesson.first_number(numbers[i])
		if not absf(shown - place[i]) <= 0.0051 * absf(place[i]) + _place_off():
			return false
	return numbers.size() == 2


# A place on the path is off by what t is off by; where the ball nearly moves along the line, much.
func _place_off() -> float:
	var way := sqrt((_impact[0] - _reset[0]) ** 2.0 + (_impact[1] - _reset[1]) ** 2.0)
	return 100.0 * _off * (1.0 + way / maxf(absf(_b), _off))


func _problem_of_labels(labels: PackedStringArray, step: int) -> String:
	var is_compared := _mistake != 0 and step >= _FRACTION
	var is_reset := step in [_RESET, _IMPACT] and _is_reset() and not is_compared
	var is_so: Dictionary[String, bool] = {
		"line": true,
		"v": true,
		"new": true,
		"old": step < _IMPACT or not _overlaps() or _can_be_at_contact(),
		"old = POI": step == _IMPACT and (_overlaps() or absf(_a) <= _off),
		"reset": is_reset,
		"POI": step == _IMPACT and _is_in_frame(),
		"wrong": is_compared,
	}
	var wanted: Dictionary[String, float] = {"t = ": _moment}
	if step == _DISTANCES:
		wanted["old "] = _old
		wanted["new "] = _new
		wanted["r "] = _radius
	if step >= _WAYS:
		wanted["a "] = _a
		wanted["b "] = _b
	for label in labels:
		var has_number := func(words: String) -> bool: return label.begins_with(words)
		var is_known: bool = wanted.keys().any(has_number)
		is_known = is_known or label.ends_with(" n̂") and step >= _RESET
		is_known = is_known or label.ends_with(" px off") and step == _IMPACT and is_reset
		if not is_so.get(label, is_known):
			return "the board says “%s”" % label
		var off := SeenLesson.first_number(label)
		if label.ends_with(" px off"):
			if not absf(off - _reset_is_off()) <= 0.0051 * _reset_is_off() + _place_off():
				return "it is %s: “%s”" % [_reset_is_off(), label]
		# Two digits of the moment are shown.
		var moment := SeenLesson.number_behind("t = ", label)
		if absf(moment - _moment) > 0.051 * _moment:
			return "the moment is %s: “%s”" % [_moment, label]
	wanted.erase("t = ")
	return false_number(labels, wanted, _off)


# What a step introduces is not shown before it.
func _problem_of_time(seen: SeenLesson) -> String:
	if seen.rows and seen.step < _IMPACT:
		return "the table comes before the impact"
	if seen.verdict and seen.step < _FRACTION:
		return "the card comes before t"
	for line in seen.lines:
		if line.contains("wrong:") and (_mistake == 0 or seen.step < _FRACTION):
			return "no wrong t is shown yet: “%s”" % line
	return ""
