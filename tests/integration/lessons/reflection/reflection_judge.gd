extends LessonJudge
## Judges what the lesson on reflection says.

# What a sum of doubles may be off by, and one of the 32 bits of Vector2, as a share of its terms.
const _ROUNDING := 1e-14
const _SINGLE_ROUNDING := 1e-6
# Where rounding alone decides, both may be said: below this, in degrees and of the speed.
const _SLACK := 1e-9

const _NOT_UNIT := 11
const _NORMAL_OF_NORMAL := 12
const _BOUNCY_TANGENT := 13
const _REFLECTED_AGAIN := 14

# Steps, counted from 0.
const _SPLIT := 1
const _SLIDE := 2
const _MIRROR := 3
const _BOUNCE := 4
const _NEXT_FRAME := 5

var _step: int
var _vx: float
var _vy: float
var _speed: float
# The unit normal, and how fast the ball moves along it and along the line.
var _nx: float
var _ny: float
var _across: float
var _along: float
var _bounciness: float
var _mistake: int
var _normal_length: float
var _is_refused: bool


func problem(seen: SeenLesson) -> String:
	_take(seen.state)
	_step = seen.step
	return first_of(
		[
			false_claim([seen.sentence], _claims_of_sentences()),
			_problem_of_card(seen),
			_problem_of_rows(seen.rows),
			_problem_of_labels(seen.labels),
			_problem_of_table(seen.labels),
			_problem_of_notice(seen.notice),
		]
	)


func _take(state: Dictionary) -> void:
	var velocity: PackedFloat64Array = state["velocity"]
	var line: PackedFloat64Array = state["along"]
	_vx = velocity[0]
	_vy = velocity[1]
	_speed = _length(_vx, _vy)
	_nx = -line[1] / _length(line[0], line[1])
	_ny = line[0] / _length(line[0], line[1])
	_across = _vx * _nx + _vy * _ny
	_along = _vx * _ny - _vy * _nx
	_bounciness = state["bounciness"]
	_mistake = state["mistake"]
	_normal_length = state["normal_length"]
	var has_unit_normal: bool = state["has_unit_normal"]
	_is_refused = not has_unit_normal and absf(_normal_length - 1.0) > 1e-9


# Scaled first: squares of tiny numbers are 0.
static func _length(x: float, y: float) -> float:
	var largest := maxf(absf(x), absf(y))
	return largest * sqrt((x / largest) ** 2.0 + (y / largest) ** 2.0) if largest > 0.0 else 0.0


# The velocity that moves so fast along the normal, and so fast along the line.
func _velocity(across: float, along: float) -> PackedFloat64Array:
	return [across * _nx + along * _ny, across * _ny - along * _nx]


func _times() -> float:
	match _step:
		_SLIDE:
			return 1.0
		_MIRROR:
			return 2.0
	return 1.0 + _bounciness


func _is_at_rest() -> bool:
	return _speed == 0.0


func _can_be_along() -> bool:
	return not _is_at_rest() and absf(_across) <= _ROUNDING * _speed


func _can_have_part() -> bool:
	return not _is_at_rest() and _across != 0.0


func _can_be_head_on() -> bool:
	return not _is_at_rest() and absf(_along) <= _ROUNDING * _speed


func _can_slide() -> bool:
	return not _is_at_rest() and _along != 0.0


# Of what is left after so many subtractions.
func _can_stop() -> bool:
	return _can_be_head_on() and absf((_times() - 1.0) * _across) <= _ROUNDING * _speed


func _degrees_in() -> float:
	return rad_to_deg(atan2(absf(_along), absf(_across)))


func _degrees_out() -> float:
	return rad_to_deg(atan2(absf(_along), (_times() - 1.0) * absf(_across)))


# What the angle out may be off by: of a ball that nearly stops, rounding is a large part.
func _out_off() -> float:
	var leaving := _length(_along, (_times() - 1.0) * _across)
	return 1e-12 + rad_to_deg(_ROUNDING * _speed / leaving) if leaving > 0.0 else 1e-12


func _energy() -> float:
	var across := (_times() - 1.0) * _across / _speed
	return across * across + (_along / _speed) ** 2.0


# How fast the ball of the mistake moves along the normal and along the line.
func _wrong() -> PackedFloat64Array:
	match _mistake:
		_NOT_UNIT:
			return [_across * (1.0 - (1.0 + _bounciness) * _normal_length ** 2.0), _along]
		_NORMAL_OF_NORMAL:
			return [_across, -_bounciness * _along]
		_BOUNCY_TANGENT:
			return [-_across, _bounciness * _along]
		_REFLECTED_AGAIN:
			return [_bounciness ** 2.0 * _across, _along]
	return [-_bounciness * _across, _along]


# By how much the mistake is off, as a share of the speed.
func _wrong_by() -> float:
	if _is_at_rest():
		return 0.0
	var wrong := _wrong()
	return _length(wrong[0] + _bounciness * _across, wrong[1] - _along) / _speed


func _can_show() -> bool:
	return _mistake != 0 and _wrong_by() > 0.5 * _SLACK


func _can_hide() -> bool:
	return _mistake != 0 and _wrong_by() < 2.0 * _SLACK


func _claims_of_sentences() -> Dictionary[String, bool]:
	var moves := not _is_refused and not _is_at_rest()
	var has_part := not _is_refused and _can_have_part()
	var off := _ROUNDING * _speed
	return {
		"A ball with velocity v meets a line. n̂ is the line's unit normal": moves and _step == 0,
		"n does not have length 1. reflect refuses it, and v stays": _is_refused,
		"v = 0: the ball does not move": not _is_refused and _is_at_rest(),
		"v · n̂ = 0: no part of v goes into the line. v stays":
		moves and _step > 0 and _can_be_along(),
		"v · n̂ < 0: n̂ points to the ball's side. (v · n̂) n̂ is the part of v along n̂":
		has_part and _step == _SPLIT and _across < off,
		"v · n̂ > 0: n̂ points to the other side. (v · n̂) n̂ is the part of v along n̂":
		has_part and _step == _SPLIT and _across > -off,
		"Subtract that part once: nothing is left of v. The ball stops":
		has_part and _step == _SLIDE and _can_be_head_on(),
		"Subtract that part once: nothing goes into the line. The ball slides":
		has_part and _step == _SLIDE and _can_slide(),
		"Subtract it twice: the law of reflection. Both angles are equal":
		has_part and _step == _MIRROR,
		"Subtract it (1 + C) times. C is the coefficient": has_part and _step == _BOUNCE,
		"Reflect only if v · n̂ < 0: now it is 0, v stays":
		has_part and _step == _NEXT_FRAME and _bounciness * absf(_across) <= off,
		"Reflect only if v · n̂ < 0: now it is above 0, v stays":
		has_part and _step == _NEXT_FRAME and _bounciness > 0.0 and _across < off,
		"Reflect only if v · (−n̂) < 0, −n̂ being on its side: v stays":
		has_part and _step == _NEXT_FRAME and _bounciness > 0.0 and _across > -off,
	}


func _problem_of_card(seen: SeenLesson) -> String:
	if seen.verdict.is_empty():
		return ""
	if _is_refused or _step < _SLIDE:
		return "it is not known yet: “%s”" % seen.verdict[0]
	return first_of(
		[
			false_claim(seen.verdict, _claims_of_card()),
			_problem_of_sign(seen.verdict_sign),
			_problem_of_card_numbers(seen.verdict),
		]
	)


func _claims_of_card() -> Dictionary[String, bool]:
	var has_angles := _can_have_part()
	return {
		"v = 0: the ball does not move": _is_at_rest(),
		"it moves along the line": _can_be_along(),
		" from n̂, and it stops": has_angles and _can_stop(),
		" from n̂": has_angles and _length(_along, (_times() - 1.0) * _across) > 0.0,
		"% of its energy": not _is_at_rest(),
		"elastic: it keeps all its energy": _can_have_part() and _times() == 2.0,
		"the mistake says: ": _can_show(),
		"the mistake changes nothing here": _can_hide(),
	}


func _problem_of_sign(sign_text: String) -> String:
	var apart := absf(_degrees_in() - _degrees_out())
	var is_right := _mistake == 0 or _can_hide()
	var is_so := false
	match sign_text:
		"✗":
			is_so = _can_show()
		"0":
			is_so = is_right and _is_at_rest()
		"=":
			is_so = is_right and not _is_at_rest() and (apart < 2.0 * _SLACK or _can_be_along())
		"≠":
			is_so = is_right and (apart > 0.5 * _SLACK or _can_stop())
	return "" if is_so else "the ball of the card has a “%s”" % sign_text


func _problem_of_card_numbers(lines: PackedStringArray) -> String:
	for line in lines:
		var degrees := SeenLesson.degrees_behind("in ", line)
		var is_close := SeenLesson.is_close_angle(degrees, _degrees_in(), 1e-12)
		if line.contains(" from n̂") and not is_close:
			return "it comes in at %s°: “%s”" % [_degrees_in(), line]
		degrees = SeenLesson.degrees_behind("out ", line)
		is_close = SeenLesson.is_close_angle(degrees, _degrees_out(), _out_off())
		if line.contains("out ") and not is_close:
			return "it goes out at %s°: “%s”" % [_degrees_out(), line]
		var percent := SeenLesson.number_behind("keeps ", line)
		if line.contains("% of its energy") and not _is_percent(percent, 100.0 * _energy()):
			return "it keeps %s %%: “%s”" % [100.0 * _energy(), line]
		if line.begins_with("the mistake says: "):
			var wrong := _wrong()
			if not _is_velocity(line.trim_prefix("the mistake says: "), wrong[0], wrong[1]):
				return "it is %s: “%s”" % [_velocity(wrong[0], wrong[1]), line]
	return ""


# With three digits; what rounding leaves of the energy is none.
static func _is_percent(shown: float, wanted: float) -> bool:
	if wanted < 1e-24:
		return shown == 0.0
	return absf(shown - wanted) <= 0.0051 * wanted


func _is_velocity(text: String, across: float, along: float) -> bool:
	var wanted := _velocity(across, along)
	var off := _ROUNDING * (_speed + absf(across))
	return is_pair(text, wanted[0], wanted[1], off)


func _problem_of_rows(rows: Array[PackedStringArray]) -> String:
	for row in rows:
		if _is_refused != (row[1] == "refused"):
			return "the normal has length %s: “%s”" % [_normal_length, "  ".join(row)]
		if _is_refused:
			continue
		if _step != _BOUNCE or not _is_velocity(row[1], -_bounciness * _across, _along):
			var right := _velocity(-_bounciness * _across, _along)
			return "it is %s: “%s”" % [right, "  ".join(row)]
		if not SeenLesson.first_number(row[2]) <= _ROUNDING * _speed:
			return "the error cannot be that: “%s”" % "  ".join(row)
	return ""


# Of the arrows and balls; the cells of the table are judged by themselves.
func _problem_of_labels(labels: PackedStringArray) -> String:
	var is_split := not _is_refused and _step >= _SPLIT
	var turns := absf(_degrees_in() - _degrees_out()) > 0.5 * _SLACK or _can_stop()
	var claims: Dictionary[String, bool] = {
		"v in": true,
		"n": _is_refused,
		"n̂": not _is_refused,
		"v": is_split and _step < _NEXT_FRAME,
		"(v·n̂) n̂": is_split and (_step == _SPLIT or _step == _NEXT_FRAME) and _can_have_part(),
		"slide": is_split and _step >= _SLIDE and _step < _NEXT_FRAME and _can_slide(),
		"−(v·n̂) n̂": is_split and _step >= _SLIDE and _step < _NEXT_FRAME and _can_have_part(),
		"−C (v·n̂) n̂": is_split and _step == _BOUNCE and _can_have_part(),
		"C = 1": is_split and _step == _BOUNCE and _mistake == 0 and turns,
		"v out": is_split and _step >= _MIRROR,
		"wrong": _can_show(),
	}
	var table_begins := labels.find("Vector2")
	for label in labels if table_begins < 0 else labels.slice(0, table_begins):
		if not claims.has(label):
			return "no claim is known for the label “%s”" % label
		if not claims[label]:
			return "there is no such thing: label “%s”" % label
	return ""


# Godot's own calls, each with ours that is the same, its value and its error.
func _problem_of_table(labels: PackedStringArray) -> String:
	var at := labels.find("bounce(n̂)")
	if at < 0:
		return "" if _step != _BOUNCE else "the table of Godot's calls is missing"
	var answers: Array[PackedFloat64Array] = [
		_velocity(-_across, _along), _velocity(0.0, _along), _velocity(_across, -_along)
	]
	var ours: PackedStringArray = ["reflect(n̂, 1)", "reflect(n̂, 0)", "−reflect(n̂, 1)"]
	for i in answers.size():
		var row := labels.slice(at + 4 * i, at + 4 * i + 4)
		if _is_refused:
			if row.size() < 3 or row[2] != "an error":
				return "Godot refuses the normal, too: “%s”" % "  ".join(row)
			# The cell of the error is empty, and so no label.
			at -= 1
			continue
		var off := _SINGLE_ROUNDING * _speed
		var is_so := is_pair(row[2], answers[i][0], answers[i][1], off) and row[1] == ours[i]
		if not is_so or not SeenLesson.first_number(row[3]) <= off:
			return "it is %s: “%s”" % [answers[i], "  ".join(row)]
	return ""


func _problem_of_notice(notice: String) -> String:
	var length := SeenLesson.number_behind("must have length 1, but has length ", notice)
	if _is_refused and not SeenLesson.is_close(length, _normal_length, 0.0):
		return "n has length %s: “%s”" % [_normal_length, notice]
	return ""
