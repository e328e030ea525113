extends LessonJudge
## Judges what the lesson on line ends says.
##
## It finds the touch on the segment with round caps without a quadratic: along the way the distance
## from a segment first falls, then rises, so the touch can be searched for by halves.

# What a sum of doubles may be off by, as a share of its terms.
const _ROUNDING := 1e-13
const _HALVES := 50
const _SEGMENT := 2
const _CAP := 3
const _ROOTS := 5
const _BOUNCE := 6

const _TITLES: PackedStringArray = [
	"Infinite, one side",
	"Infinite, two sides",
	"Segment, one side",
	"Segment, two sides",
	"Segment, two sides, round caps",
]
# From which step on each field is shown.
const _FIRST_STEPS: PackedInt32Array = [0, 1, 2, 2, 3]

var _step: int
var _mistake: int
var _start: Vector2D
var _motion: Vector2D
var _radius: float
var _from: Vector2D
var _to: Vector2D
# What a place may be off by.
var _off: float
# The unit vector along the line, and the one across it to the side of the ball.
var _along: Vector2D
var _across: Vector2D
# Of the start, never below 0 and with its sign.
var _distance: float
var _signed: float
var _approach: float
# Of the touch with the infinite line, before it is kept within the frame.
var _line_time: float
# Where the ball then is along the line: 0 at A, 1 at B.
var _share: float
# The touch on the segment with round caps; NAN for none. Where it is along the line.
var _touch: float
var _touch_share: float
# How near the ball comes to the segment.
var _nearest: float
# Something is so near its limit that rounding decides: then the words of fields are not judged.
var _is_close_call: bool


## Two numbers, as no core has them.
class Vector2D:
	extends RefCounted
	var x: float
	var y: float

	func _init(with_x: float, with_y: float) -> void:
		x = with_x
		y = with_y

	func plus(other: Vector2D, times: float = 1.0) -> Vector2D:
		return Vector2D.new(x + times * other.x, y + times * other.y)

	func minus(other: Vector2D) -> Vector2D:
		return plus(other, -1.0)

	func dot(other: Vector2D) -> float:
		return x * other.x + y * other.y

	func size() -> float:
		return sqrt(x * x + y * y)


func problem(seen: SeenLesson) -> String:
	_take(seen.state)
	_step = seen.step
	for found: String in [
		false_claim([seen.sentence], _claims_of_sentences()),
		_problem_of_fields(seen.labels),
		_problem_of_lines(seen.lines),
		_problem_of_rows(seen.rows),
	]:
		if found:
			return found
	return ""


func _take(state: Dictionary) -> void:
	var shot: PackedFloat64Array = state["shot"]
	var line: PackedFloat64Array = state["line"]
	_mistake = state["mistake"]
	_start = Vector2D.new(shot[0], shot[1])
	_motion = Vector2D.new(shot[2], shot[3])
	_radius = shot[4]
	_from = Vector2D.new(line[0], line[1])
	_to = Vector2D.new(line[2], line[3])
	_off = _radius + _start.size() + _motion.size() + _from.size() + _to.size()
	_off *= _ROUNDING
	_take_line()
	_take_touch()
	_is_close_call = _is_near_a_limit()


func _take_line() -> void:
	var way := _to.minus(_from)
	_along = Vector2D.new(way.x / way.size(), way.y / way.size())
	_across = Vector2D.new(-_along.y, _along.x)
	_signed = _start.minus(_from).dot(_across)
	if _signed < 0.0:
		_across = Vector2D.new(_along.y, -_along.x)
	_distance = absf(_signed)
	_approach = -_motion.dot(_across)
	_line_time = (_distance - _radius) / _approach if _approach > 0.0 else NAN
	_share = _share_at(maxf(_line_time, 0.0)) if _approach > 0.0 else NAN


func _at(time: float) -> Vector2D:
	return _start.plus(_motion, time)


func _share_at(time: float) -> float:
	return _at(time).minus(_from).dot(_along) / _length()


func _length() -> float:
	return _to.minus(_from).size()


func _nearest_point(time: float) -> Vector2D:
	return _from.plus(_to.minus(_from), clampf(_share_at(time), 0.0, 1.0))


func _distance_at(time: float) -> float:
	return _at(time).minus(_nearest_point(time)).size()


func _take_touch() -> void:
	var nearest_time := _time_of_nearest()
	_nearest = _distance_at(nearest_time)
	_touch = NAN
	if _distance_at(0.0) <= _radius:
		if _start.minus(_nearest_point(0.0)).dot(_motion) < 0.0:
			_touch = 0.0
	elif _nearest < _radius:
		_touch = _time_of_radius(nearest_time)
	_touch_share = _share_at(_touch)


# Before it the ball approaches the nearest point, then it moves away.
func _time_of_nearest() -> float:
	var early := 0.0
	var late := 1.0
	for i in _HALVES:
		var middle := (early + late) / 2.0
		if _at(middle).minus(_nearest_point(middle)).dot(_motion) < 0.0:
			early = middle
		else:
			late = middle
	return late


func _time_of_radius(latest: float) -> float:
	var early := 0.0
	var late := latest
	for i in _HALVES:
		var middle := (early + late) / 2.0
		if _distance_at(middle) > _radius:
			early = middle
		else:
			late = middle
	return late


func _is_near_a_limit() -> bool:
	var share_off := 1e-7 + _off / _length()
	var time_off := 1e-7
	var speed_off := 1e-9 * _motion.size()
	var nearest_off := _off + 1e-9 * _radius
	for pair_of_limits: Array in [
		[_signed, 0.0, _off],
		[_distance, _radius, _off],
		[_approach, 0.0, speed_off if _approach != 0.0 else -1.0],
		[_line_time, 1.0, time_off],
		[_share, 0.0, share_off],
		[_share, 1.0, share_off],
		[_touch_share, 0.0, share_off],
		[_touch_share, 1.0, share_off],
		[_touch, 1.0, time_off],
		[_nearest, _radius, nearest_off],
		[_distance_at(0.0), _radius, _off],
		[_start.minus(_nearest_point(0.0)).dot(_motion), 0.0, _off * _motion.size()],
	]:
		var value: float = pair_of_limits[0]
		var limit: float = pair_of_limits[1]
		var off: float = pair_of_limits[2]
		if absf(value - limit) <= off:
			return true
	return false


func _moves() -> bool:
	return _motion.size() > 0.0


func _hits_line() -> bool:
	return _approach > 0.0 and maxf(_line_time, 0.0) <= 1.0


func _is_beside() -> bool:
	return _share >= 0.0 and _share <= 1.0


func _is_in_front() -> bool:
	return _signed >= 0.0


func _hits_capsule() -> bool:
	return not is_nan(_touch)


func _hits_end() -> bool:
	return _hits_capsule() and not (_touch_share >= 0.0 and _touch_share <= 1.0)


# The end that is touched; else the one to which the ball comes nearer.
func _end() -> Vector2D:
	if _hits_end():
		return _from if _touch_share < 0.0 else _to
	return _from if _clearance(_from) <= _clearance(_to) else _to


func _clearance(point: Vector2D) -> float:
	var squared := _motion.dot(_motion)
	var time := clampf(point.minus(_start).dot(_motion) / squared, 0.0, 1.0) if squared else 0.0
	return _at(time).minus(point).size()


func _can_be_either_end() -> bool:
	return _is_close_call or absf(_clearance(_from) - _clearance(_to)) <= _off + 1e-9 * _radius


func _claims_of_sentences() -> Dictionary[String, bool]:
	var is_last := _step == _BOUNCE
	return {
		"As before: an infinite line with one good side. A ball from behind passes": _step == 0,
		"Turn n to the ball's side: now both sides work. Still infinite": _step == 1,
		"With ends, 0 ≤ s ≤ 1 must hold: the ball's centre F is beside the line": _step == _SEGMENT,
		"Round caps: the ball touches an end when its centre is r away": _step == _CAP,
		"|d + t v| = r, squared, is a quadratic: a t² + b t + c = 0": _step == 4,
		"D < 0: the ball misses. D > 0: t₁ is the first touch; it counts within 0..1":
		_step == _ROOTS,
		"n points from the end to the ball's centre. Reflect v on it":
		is_last and (_hits_end() or _is_close_call),
		"This ball bounces on the line, with the line's normal":
		is_last and (_hits_capsule() and not _hits_end() or _is_close_call),
		"This ball touches neither the line nor an end: v stays":
		is_last and (not _hits_capsule() or _is_close_call),
	}


# A field begins with its title and ends with its words; between them are names of arrows.
func _problem_of_fields(labels: PackedStringArray) -> String:
	var field := -1
	for label in labels:
		var text := label.replace("\u00a0", " ")
		var found := ""
		if text in _TITLES:
			field = _TITLES.find(text)
			if _step < _FIRST_STEPS[field]:
				found = "it does not come before its step"
		elif text.length() <= 2 or text == "wrong":
			found = _problem_of_name(text)
		else:
			found = _problem_of_words(field, text)
		if found:
			return "%s: “%s”" % [found, text]
	return ""


func _problem_of_name(text: String) -> String:
	var names: Dictionary[String, bool] = {
		"v": true,
		"d": _step == _CAP,
		"A": _step >= _CAP,
		"B": _step >= _CAP,
		"t₁": _step >= _ROOTS,
		"t₂": _step == _ROOTS,
		"n": _step == _BOUNCE and (_hits_end() or _is_close_call),
		"wrong": _mistake != 0 and _step >= _CAP,
	}
	return "" if names.get(text, false) else "no such name is to be seen"


func _problem_of_words(field: int, text: String) -> String:
	var lines := text.split("\n")
	var words := lines[0].trim_prefix("✗ ").get_slice(", t = ", 0)
	if not words in _known_words():
		return "no claim is known"
	if _is_close_call:
		return ""
	if words != _right_words(field):
		return "it is “%s”" % _right_words(field)
	if lines[0].begins_with("✗ ") and (_mistake != 23 or not _differs(_end_of_field(field))):
		return "that line is not wrong here"
	var time := SeenLesson.number_behind(", t = ", lines[0])
	if is_nan(time) == _tells_time(field) or not is_nan(time) and not _is_time(field, time):
		return "the touch is at %s" % _time_in(field)
	if lines.size() > 1:
		return _problem_of_wrong_ball(lines[1])
	return "" if _mistake == 0 or field != 4 else "what the wrong ball does is missing"


func _known_words() -> PackedStringArray:
	return [
		"bounces on the line",
		"bounces in the air",
		"bounces on the end",
		"touches the end",
		"passes through from behind",
		"finds no hit, cuts through the end",
		"passes beside",
		"does not get there",
		"moves away",
		"moves along the line",
		"does not move",
	]


func _right_words(field: int) -> String:
	var has_sides := field in [1, 3, 4]
	if _touches(field):
		if field == 4 and _hits_end():
			return "bounces on the end" if _step == _BOUNCE else "touches the end"
		return "bounces on the line" if _is_beside() else "bounces in the air"
	if not _moves():
		return "does not move"
	var passes := _touches(1) if field == 0 else _touches(3)
	if not has_sides and not _is_in_front() and passes:
		return "passes through from behind"
	if field >= 2 and _hits_capsule():
		return "finds no hit, cuts through the end"
	if _approach == 0.0:
		return "moves along the line"
	if _approach < 0.0:
		return "moves away"
	return "passes beside" if _line_time <= 1.0 else "does not get there"


# Whether this kind of line finds a touch.
func _touches(field: int) -> bool:
	match field:
		0:
			return _hits_line() and _is_in_front()
		1:
			return _hits_line()
		2:
			return _hits_line() and _is_beside() and _is_in_front()
		3:
			return _hits_line() and _is_beside()
	return _hits_capsule()


func _time_in(field: int) -> float:
	return _touch if field == 4 else maxf(_line_time, 0.0)


func _tells_time(field: int) -> bool:
	return _touches(field) and not (field == 4 and _hits_end() and _step < _ROOTS)


func _is_time(field: int, shown: float) -> bool:
	return SeenLesson.is_close(shown, _time_in(field), 1e-7)


# Where the ball is at the end of the frame in a field.
func _end_of_field(field: int) -> Vector2D:
	if not _touches(field):
		return _at(1.0)
	if field == 4:
		return _bounced(_touch, _at(_touch).minus(_nearest_point(_touch)))
	return _bounced(maxf(_line_time, 0.0), _across)


# Where it is after a bounce at a time, off what lies against this direction.
func _bounced(time: float, towards: Vector2D) -> Vector2D:
	if time > 1.0:
		return _at(1.0)
	var normal := Vector2D.new(towards.x / towards.size(), towards.y / towards.size())
	var after := _motion.plus(normal, -2.0 * _motion.dot(normal))
	return _at(time).plus(after, 1.0 - time)


func _differs(place: Vector2D) -> bool:
	return place.minus(_end_of_field(4)).size() > 1e-7


# The time at which the mistake has a touch: NAN where it has a root of less than 0, INF for none.
func _wrong_time() -> float:
	match _mistake:
		22:
			if _takes_line():
				return maxf(_line_time, 0.0)
			return INF if _hits_capsule() and not _hits_end() else _right_time()
		23:
			return maxf(_line_time, 0.0) if _hits_line() else INF
	var difference := _start.minus(_end())
	var b := 2.0 * difference.dot(_motion)
	if _hits_capsule() and not _hits_end() or b >= 0.0:
		return _right_time()
	var a := _motion.dot(_motion)
	var discriminant := b * b - 4.0 * a * (difference.dot(difference) - _radius * _radius)
	match _mistake:
		18:
			return (-b - discriminant * discriminant) / (2.0 * a)
		19:
			return NAN if discriminant < 0.0 else _right_time()
	return (-b - sqrt(discriminant)) / (2.0 * a) - 1.0 if _hits_end() else _right_time()


# Whether the mistake has the ball bounce on the line as if that had no ends.
func _takes_line() -> bool:
	var new_share := _share_at(1.0)
	var is_taken := _mistake == 22 and new_share >= 0.0 and new_share <= 1.0
	return _hits_line() and (is_taken or _mistake == 23)


func _right_time() -> float:
	return _touch if _hits_capsule() else INF


func _wrong_end() -> Vector2D:
	var time := _wrong_time()
	if time == INF or is_nan(time):
		return _at(1.0)
	if _takes_line():
		return _bounced(time, _across)
	if time == _touch:
		return _end_of_field(4)
	return _bounced(time, _at(time).minus(_end()))


func _problem_of_wrong_ball(line: String) -> String:
	if _can_be_either_end():
		return ""
	var wanted := _wrong_time()
	match line:
		"the wrong ball does the same here":
			var is_same := not is_nan(wanted) and _wrong_end().minus(_end_of_field(4)).size() < 1e-5
			return "" if is_same else "the wrong ball does something else"
		"✗ the wrong ball passes":
			return "" if wanted == INF else "the wrong ball touches at %s" % wanted
	var shown := line.trim_prefix("✗ the wrong ball: t = ")
	if line.begins_with("✗ the wrong ball: t = ") and _differs(_wrong_end()):
		return _problem_of_wrong_time(shown, wanted)
	if shown == "NaN" and is_nan(wanted):
		return ""
	return "the wrong ball does not do that"


func _problem_of_wrong_time(shown: String, wanted: float) -> String:
	if is_nan(wanted):
		return "" if shown == "NaN" else "it is NaN"
	var off := 1e-6 + 1e-3 * absf(wanted)
	var is_so := absf(SeenLesson.first_number(shown) - wanted) <= off
	return "" if is_so else "the wrong touch is at %s" % wanted


# What is said in the formula in words.
func _problem_of_lines(lines: PackedStringArray) -> String:
	if _is_close_call or _can_be_either_end():
		return ""
	var difference := _start.minus(_end())
	var a := _motion.dot(_motion)
	var b := difference.dot(_motion)
	var c := difference.dot(difference) - _radius * _radius
	# Near 0, rounding decides.
	var is_graze := absf(b * b - a * c) <= 1e-9 * (b * b + absf(a * c))
	var has_root := b * b > a * c
	var overlaps := _distance <= _radius if _step < _CAP else c <= 0.0
	var claims: Dictionary[String, bool] = {
		"along the line, no time of impact": _approach == 0.0,
		"it moves away, no impact": _approach < 0.0,
		"a = 0: the ball does not move": not _moves(),
		"D < 0: no root": is_graze or not has_root,
		"the line is met first": _hits_capsule() and not _hits_end(),
		"moving away: none": b >= 0.0 or _overlaps_and_leaves(),
		"overlap: t = 0": overlaps,
		"it only grazes: none": is_graze,
		"t₁ counts": is_graze or has_root and _hits_end() and _touch > 0.0,
		"t₁ > 1: none": is_graze or has_root and not _hits_capsule() and b < 0.0 and c > 0.0,
	}
	for line in lines:
		for words in claims:
			if line.contains(words) and not claims[words]:
				return "it is not so: “%s”" % line
	return ""


func _overlaps_and_leaves() -> bool:
	return _distance_at(0.0) <= _radius and not _hits_capsule()


func _problem_of_rows(rows: Array[PackedStringArray]) -> String:
	if rows and _step < _ROOTS:
		return "the times are not known yet"
	if _is_close_call or _can_be_either_end():
		return ""
	for row in rows:
		var wanted := NAN
		if row[0] == "t, infinite line":
			wanted = maxf(_line_time, 0.0) if _hits_line() else NAN
		elif row[0] == "t, end %s" % ("A" if _end() == _from else "B"):
			wanted = _time_at_end()
		else:
			return "no claim is known for “%s”" % row[0]
		var shown := SeenLesson.first_number(row[1])
		if is_nan(wanted) != (row[1] == "none"):
			return "it is %s: “%s”" % [wanted, "  ".join(row)]
		if not is_nan(wanted) and not SeenLesson.is_close(shown, wanted, 1e-7):
			return "it is %s: “%s”" % [wanted, "  ".join(row)]
		if not is_nan(wanted) and not SeenLesson.first_number(row[2]) < 1e-6:
			return "the error cannot be that: “%s”" % "  ".join(row)
	return ""


# Of the touch on the end alone, as if there were no line; NAN for none.
func _time_at_end() -> float:
	var difference := _start.minus(_end())
	var a := _motion.dot(_motion)
	var b := difference.dot(_motion)
	var c := difference.dot(difference) - _radius * _radius
	if b >= 0.0:
		return NAN
	if c <= 0.0:
		return 0.0
	if b * b <= a * c:
		return NAN
	var time := c / (-b + sqrt(b * b - a * c))
	return time if time <= 1.0 else NAN
