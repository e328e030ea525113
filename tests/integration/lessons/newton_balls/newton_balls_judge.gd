extends LessonJudge
## Judges what the lesson on balls that meet says.

# What a sum of doubles may be off by, as a share of its terms.
const _ROUNDING := 1e-9
# The steps, counted from 0.
const _NORMAL := 1
const _CENTER := 2
const _FRAME := 3
const _IMPULSE := 4
const _AFTER := 5
const _MOMENTUM := 6
const _ENERGY := 7

var _c: float
var _has_newton: bool
var _mistake: int
var _count: int
var _has_box: bool
# What becomes of the balls: the same in each step.
var _meetings: Dictionary[String, Meeting] = {}
var _meeting: Meeting
# The velocities after the bounce.
var _after: Array[Vec2] = []
var _wrong: Array[Vec2] = []


## The first meeting of two balls, by trying all pairs and all walls.
class Meeting:
	extends RefCounted
	const LONGEST := 60.0
	const HALF: Array[float] = [12.0, 6.5]
	var found := false
	# Another pair meets as soon, or both only just touch.
	var is_unsure := false
	var m: PackedFloat64Array = [1, 1]
	var v: Array[Vec2] = [Vec2.new(), Vec2.new()]
	var n := Vec2.new(1.0, 0.0)
	var _places: Array[Vec2] = []
	var _moving: Array[Vec2] = []
	var _masses: PackedFloat64Array = []

	var _c := 1.0

	func _init(balls: Array, has_box: bool, c: float) -> void:
		_c = c
		for ball: PackedFloat64Array in balls:
			_places.append(Vec2.new(ball[0], ball[1]))
			_moving.append(Vec2.new(ball[2], ball[3]))
			_masses.append(ball[4])
		var time := 0.0
		for bounce: int in 3000:
			var seconds := _meet(LONGEST - time)
			var wall := _first_wall() if has_box else Vector3(INF, 0, 0)
			if found and seconds <= wall.x:
				return
			found = false
			time += wall.x
			if time > LONGEST:
				return
			_fly(wall.x)
			_moving[int(wall.y)].set("xy"[int(wall.z)], _turned(int(wall.y), int(wall.z)))

	func _turned(ball: int, axis: int) -> float:
		var speed: float = _moving[ball].get("xy"[axis])
		return -_c * speed

	func _fly(seconds: float) -> void:
		for ball: int in _places.size():
			_places[ball].add(_moving[ball].scaled(seconds))

	# Seconds, ball and axis of the first bounce off a wall.
	func _first_wall() -> Vector3:
		var first := Vector3(INF, 0, 0)
		for ball: int in _places.size():
			for axis: int in 2:
				var speed: float = _moving[ball].get("xy"[axis])
				var at: float = _places[ball].get("xy"[axis])
				var room := HALF[axis] - sqrt(_masses[ball])
				var seconds := (room * signf(speed) - at) / speed if absf(speed) > 1e-12 else INF
				if seconds < first.x:
					first = Vector3(maxf(seconds, 0.0), ball, axis)
		return first

	func _meet(longest: float) -> float:
		var first := INF
		for one: int in _places.size():
			for other: int in one:
				var seconds := _time_of(other, one)
				if seconds < first - 1e-9 * (1.0 + seconds) and seconds <= longest:
					first = seconds
					is_unsure = false
					_take(other, one, seconds)
				elif absf(seconds - first) < 1e-6:
					is_unsure = true
		found = first < INF
		is_unsure = is_unsure or absf(first - longest) < 1e-6
		return first

	func _time_of(one: int, other: int) -> float:
		var way := _places[other].minus(_places[one])
		var moving := _moving[other].minus(_moving[one])
		var reach := sqrt(_masses[one]) + sqrt(_masses[other])
		var approach := -way.dot(moving)
		var square := moving.length_squared()
		if approach <= 1e-12 * way.length() * moving.length():
			return INF
		var across := way.cross(moving)
		var left := reach * reach * square - across * across
		if left < 0.0:
			return INF
		return maxf((approach - sqrt(left)) / square, 0.0)

	func _take(one: int, other: int, seconds: float) -> void:
		m = [_masses[one], _masses[other]]
		v = [_moving[one].copy(), _moving[other].copy()]
		var way := _places[other].minus(_places[one])
		n = way.plus(v[1].minus(v[0]).scaled(seconds)).normalized()
		var across := absf(v[1].minus(v[0]).normalized().cross(n))
		is_unsure = across > 1.0 - 1e-9


func problem(seen: SeenLesson) -> String:
	_take(seen.state)
	return first_of(
		[
			false_claim([seen.sentence], _claims_of_sentences(seen.step)),
			_problem_of_card(seen),
			_problem_of_rows(seen.rows),
			_problem_of_labels(seen),
			_problem_of_time(seen),
		]
	)


func _take(state: Dictionary) -> void:
	var balls: Array = state["balls"]
	_c = state["bounciness"]
	_has_box = state["has_box"]
	_has_newton = state["has_newton"]
	_mistake = state["mistake"]
	if _mistake == 0 and not _has_newton:
		_mistake = 25
	_count = balls.size()
	var key := "%s %s %s" % [balls, _has_box, _c]
	if not _meetings.has(key):
		_meetings[key] = Meeting.new(balls, _has_box, _c)
	_meeting = _meetings[key]
	var total := _meeting.m[0] + _meeting.m[1]
	_after = _pushed((1.0 + _c) * _meeting.m[0] * _meeting.m[1] / total * _closing())
	_wrong = _wrong_velocities(total)


func _closing() -> float:
	return _meeting.v[0].minus(_meeting.v[1]).dot(_meeting.n)


# After each ball has got this push along n.
func _pushed(push: float) -> Array[Vec2]:
	return [
		_meeting.v[0].minus(_meeting.n.scaled(push / _meeting.m[0])),
		_meeting.v[1].plus(_meeting.n.scaled(push / _meeting.m[1]))
	]


func _wrong_velocities(total: float) -> Array[Vec2]:
	var v := _meeting.v
	var m := _meeting.m
	var n := _meeting.n
	var change := (1.0 + _c) * _closing() / total
	var found := _after
	match _mistake:
		25:
			found = [
				v[0].minus(n.scaled((1.0 + _c) * v[0].dot(n))),
				v[1].minus(n.scaled((1.0 + _c) * v[1].dot(n)))
			]
		101:
			found = [v[1], v[0]]
		102:
			var elastic := _pushed(2.0 * m[0] * m[1] / total * _closing())
			found = [elastic[0].scaled(_c), elastic[1].scaled(_c)]
		103:
			var center := _momentum(v).divided(total).scaled(1.0 + _c)
			found = [center.minus(v[0].scaled(_c)), center.minus(v[1].scaled(_c))]
		104:
			found = [v[0].minus(n.scaled(change * m[0])), v[1].plus(n.scaled(change * m[1]))]
		105:
			var closing := _after[0].minus(v[1]).dot(n)
			var late := (1.0 + _c) * m[0] / total * closing
			found = [_after[0], v[1].plus(n.scaled(late))]
	return found


func _momentum(velocities: Array[Vec2]) -> Vec2:
	return velocities[0].scaled(_meeting.m[0]).plus(velocities[1].scaled(_meeting.m[1]))


func _energy(velocities: Array[Vec2]) -> float:
	var found := 0.0
	for place: int in 2:
		found += _meeting.m[place] * velocities[place].length_squared() / 2.0
	return found


func _can_meet() -> bool:
	return _meeting.found or _meeting.is_unsure


func _can_part() -> bool:
	return not _meeting.found or _meeting.is_unsure


func _is_pair() -> bool:
	return _count == 2 and not _has_box


func _claims_of_sentences(step: int) -> Dictionary[String, bool]:
	var meets := _can_meet()
	return {
		"no two balls meet": _can_part(),
		"Newton is off": step == 0 and not _has_newton,
		"The steps are about the first two balls": step == 0 and _count > 2 and meets,
		"Press Play: two balls meet": step == 0 and _count == 2 and meets and _has_newton,
		"n points from ball 1 to ball 2": step == _NORMAL and meets,
		"No push between the two balls changes it": step == _CENTER and meets,
		"Seen from the centre of mass, each ball": step == _FRAME and meets and _is_pair(),
		"For somebody who moves with V": step == _FRAME and meets and not _is_pair(),
		"action and reaction": step == _IMPULSE and meets,
		"Across n nothing changes": step == _AFTER and meets,
		"the same sum P": step == _MOMENTUM and meets,
		"no kinetic energy is lost": step == _ENERGY and meets and _c == 1.0,
		"With C = 0": step == _ENERGY and meets and _c == 0.0,
		"only the share C² stays": step == _ENERGY and meets and _c < 1.0 and _c > 0.0,
	}


func _claims_of_card(step: int) -> Dictionary[String, bool]:
	var meets := _can_meet()
	var is_compared := _mistake != 0 and step >= _AFTER and meets
	var lost := _energy(_meeting.v) - _energy(_after)
	var keeps := lost <= 1e-9 * _energy(_meeting.v)
	return {
		"no two balls meet": _can_part(),
		"V = ": step in [_CENTER, _FRAME] and meets,
		"both feel J = ": step == _IMPULSE and meets,
		"v₁′ = ": step == _AFTER and meets,
		"v₂′ = ": step == _AFTER and meets,
		"P = ": step == _MOMENTUM and meets,
		"E = ": step == _ENERGY and meets and (keeps or _meeting.is_unsure),
		"E: ": step == _ENERGY and meets and _c < 1.0,
		"the mistake changes nothing here": is_compared and (_is_same() or _meeting.is_unsure),
		"the mistake makes E = ": is_compared and step == _ENERGY,
		"the mistake makes P = ": is_compared and step == _MOMENTUM,
		"the mistake: v₁′ = ": is_compared and step == _AFTER,
	}


func _is_same() -> bool:
	var off := maxf(_after[0].distance_to(_wrong[0]), _after[1].distance_to(_wrong[1]))
	return off <= 1e-8 * _scale()


func _scale() -> float:
	return _meeting.v[0].length() + _meeting.v[1].length()


func _problem_of_card(seen: SeenLesson) -> String:
	var claimed := false_claim(seen.verdict, _claims_of_card(seen.step))
	if claimed:
		return claimed
	var signs: Dictionary[String, bool] = {
		"": true,
		"=": _can_meet(),
		"×": _can_part(),
		"✗": _mistake != 0 and seen.step >= _AFTER and _can_meet(),
	}
	if not signs.get(seen.verdict_sign, false):
		return "the ball of the card has a “%s”" % seen.verdict_sign
	for line in seen.verdict if not _meeting.is_unsure else PackedStringArray():
		if not _is_card_line_right(line):
			return "the numbers are others: “%s”" % line
	return ""


# The words that come first in this list count.
func _is_card_line_right(line: String) -> bool:
	var total := _meeting.m[0] + _meeting.m[1]
	var momentum := _momentum(_meeting.v)
	var push := (1.0 + _c) * _meeting.m[0] * _meeting.m[1] / total * _closing()
	var is_wrong := line.begins_with("the mistake")
	var velocities := _wrong if is_wrong else _after
	var pairs: Dictionary[String, Vec2] = {
		"V = ": momentum.divided(total),
		"P = ": _momentum(_wrong) if is_wrong else momentum,
		"v₁′ = ": velocities[0],
		"v₂′ = ": velocities[1],
	}
	var numbers: Dictionary[String, float] = {
		"E: ": _energy(_meeting.v) - _energy(_after),
		"of ": _energy(_meeting.v),
		"E = ": _energy(_wrong) if is_wrong else _energy(_meeting.v),
		"J = ": push,
	}
	for words in pairs:
		var size := 10.0 * (1.0 + total) * _scale()
		if line.contains(words) and not _is_pair_shown(line, words, pairs[words], size):
			return false
	for words in numbers:
		if line.contains(words) and not _is_number_shown(line, words, numbers[words]):
			return false
	return true


func _is_number_shown(line: String, words: String, wanted: float) -> bool:
	var shown := SeenLesson.number_behind(words, line)
	return SeenLesson.is_close(shown, wanted, _ROUNDING * (_energy(_meeting.v) + absf(wanted)))


static func _is_pair_shown(line: String, words: String, wanted: Vec2, size: float) -> bool:
	var parts := line.substr(line.find(words) + words.length()).trim_prefix("(").get_slice(")", 0)
	var x := SeenLesson.first_number(parts.get_slice(", ", 0))
	var y := SeenLesson.first_number(parts.get_slice(", ", 1))
	var rounding := _ROUNDING * size
	return SeenLesson.is_close(x, wanted.x, rounding) and SeenLesson.is_close(y, wanted.y, rounding)


func _problem_of_rows(rows: Array[PackedStringArray]) -> String:
	for row in rows if not _meeting.is_unsure else ([] as Array[PackedStringArray]):
		var wanted := _after[0] if row[0] == "v₁′" else _after[1]
		var error := SeenLesson.first_number(row[2])
		var mass_share := _meeting.m[0] / _meeting.m[1] + _meeting.m[1] / _meeting.m[0]
		if not _is_pair_shown(row[1], "(", wanted, 10.0 * _scale()):
			return "the velocity is another: “%s”" % "  ".join(row)
		if not error <= 1e-14 * _scale() * (1.0 + mass_share):
			return "it is not so far off: “%s”" % "  ".join(row)
	return ""


func _problem_of_labels(seen: SeenLesson) -> String:
	var step := seen.step
	var meets := _can_meet()
	var is_seen := step == _FRAME and _is_pair() and meets
	var claims: Dictionary[String, bool] = {
		"v": true,
		"v₁": true,
		"v₂": true,
		"m₁": _is_pair(),
		"m₂": _is_pair(),
		"n": meets and step in [_NORMAL, _FRAME, _IMPULSE, _AFTER],
		"V": meets and step in [_CENTER, _FRAME],
		"u₁": is_seen,
		"u₂": is_seen,
		"u₁′": is_seen,
		"u₂′": is_seen,
		"J": meets and step == _IMPULSE,
		"−J": meets and step == _IMPULSE,
		"v₁′": meets and step >= _AFTER,
		"v₂′": meets and step >= _AFTER,
	}
	for label: String in ["p₁", "p₂", "P", "p₁′", "p₂′", "P′"]:
		claims[label] = meets and step >= _MOMENTUM
	for label in seen.labels:
		if label.begins_with("C = "):
			if not SeenLesson.is_close(SeenLesson.number_behind("C = ", label), _c, 1e-12):
				return "C is another: “%s”" % label
		elif label.begins_with("t = "):
			if step < _MOMENTUM or not _is_sum_right(label, seen.state):
				return "the sums are others: “%s”" % label
		elif not claims.get(label, false):
			return "it should not be on the board: “%s”" % label
	return ""


# At the start, over all balls.
static func _is_sum_right(label: String, state: Dictionary) -> bool:
	var sum := Vec2.new()
	var energy := 0.0
	var size := 0.0
	var balls: Array = state["balls"]
	for ball: PackedFloat64Array in balls:
		sum.add(Vec2.new(ball[2], ball[3]).scaled(ball[4]))
		size += absf(ball[4]) * (absf(ball[2]) + absf(ball[3]))
		energy += ball[4] * (ball[2] * ball[2] + ball[3] * ball[3]) / 2.0
	var shown := SeenLesson.number_behind("E = ", label)
	return (
		_is_pair_shown(label, "P = ", sum, size)
		and SeenLesson.is_close(shown, energy, 1e-12 * energy)
	)


# What a step introduces is not shown before it.
func _problem_of_time(seen: SeenLesson) -> String:
	if seen.rows and seen.step < _AFTER:
		return "the table comes before the velocities"
	for line in seen.lines:
		if line.contains("mistake:") and (_mistake == 0 or seen.step < _AFTER):
			return "no wrong velocity is shown yet: “%s”" % line
	return ""
