extends LessonJudge
## Judges what the lesson on leading a target says.

# What a sum of doubles may be off by, as a share of its terms.
const _ROUNDING := 1e-12
const _EPSILON := 2.220446049250313e-16

# The steps, counted from 0.
const _RELATIVE := 1
const _REACH := 2
const _TIME := 3
const _AIM := 4
const _FIRE := 5

const _AT_PRESENT := 101
const _ONE_STEP := 102
const _BELOW_ZERO := 103
const _WITHOUT_OWN := 104
const _OWN_TWICE := 105

# A later hit is not flown.
const _LONGEST := 1e6

var _shooter: Vec2
var _target: Vec2
var _velocity: Vec2
var _own: Vec2
var _speed: float
var _radius: float
var _mistake: int
# From the shooter to the target, and how it moves as the shooter sees it.
var _way: Vec2
var _seen: Vec2
# The first hit, NAN where there is none.
var _hit: float
# The direction of the mistake; zero where it has none.
var _wrong: Vec2


func problem(seen: SeenLesson) -> String:
	_take(seen.state)
	return first_of(
		[
			false_claim([seen.sentence], _claims_of_sentences(seen.step)),
			false_claim(seen.verdict, _claims_of_card(seen.step)),
			_problem_of_sign(seen),
			_problem_of_numbers(seen.verdict),
			_problem_of_rows(seen.rows),
			_problem_of_labels(seen.labels, seen.step),
			_problem_of_time(seen),
		]
	)


func _take(state: Dictionary) -> void:
	_shooter = _vector(state["shooter"])
	_target = _vector(state["target"])
	_velocity = _vector(state["velocity"])
	_own = _vector(state["own"])
	_speed = state["speed"]
	_radius = state["radius"]
	_mistake = state["mistake"]
	_way = Vec2.new(_target.x - _shooter.x, _target.y - _shooter.y)
	_seen = Vec2.new(_velocity.x - _own.x, _velocity.y - _own.y)
	_hit = _first_hit(_seen)
	_wrong = _wrong_direction()


static func _vector(stored: Variant) -> Vec2:
	var pair: PackedFloat64Array = stored
	return Vec2.new(pair[0], pair[1])


# How far the target is beyond the reach after so many seconds, if it moves with this velocity.
func _gap(seconds: float, moving: Vec2) -> float:
	var x := _way.x + moving.x * seconds
	var y := _way.y + moving.y * seconds
	return sqrt(x * x + y * y) - _radius - _speed * seconds


# What rounding may make of a gap.
func _off(seconds: float, moving: Vec2) -> float:
	var size := absf(_way.x) + absf(_way.y) + _radius
	return _ROUNDING * (size + (moving.length() + _speed) * seconds)


# The gap falls, and may rise again: it is curved to one side only.
func _first_hit(moving: Vec2) -> float:
	if _gap(0.0, moving) <= 0.0:
		return 0.0
	var last := 1e-9 * (_way.length() + 1e-300) / (_speed + moving.length())
	while _gap(last, moving) > 0.0 and last < 1e25:
		last *= 2.0
	if last >= 1e25:
		last = _lowest(moving)
	if _gap(last, moving) > 0.0:
		return NAN
	return _bisected(0.0, last, moving)


# The moment with the smallest gap.
func _lowest(moving: Vec2) -> float:
	var from := 0.0
	var to := 1e3 * (_way.length() + _radius + 1e-300) / maxf(moving.length(), 1e-300)
	for i: int in 300:
		var third := (to - from) / 3.0
		if _gap(from + third, moving) <= _gap(to - third, moving):
			to -= third
		else:
			from += third
	return from


func _bisected(low: float, high: float, moving: Vec2) -> float:
	var from := low
	var to := high
	for i: int in 200:
		var middle := (from + to) / 2.0
		if (_gap(middle, moving) > 0.0) == (_gap(low, moving) > 0.0):
			from = middle
		else:
			to = middle
	return to


func _wrong_direction() -> Vec2:
	match _mistake:
		_AT_PRESENT:
			return _way.normalized()
		_ONE_STEP:
			return _unit_after(_way.length() / _speed, _seen)
		_BELOW_ZERO:
			var root := (sqrt(_discriminant()) - _b()) / _a()
			var is_one := root < 0.0 and root > -INF and not _can_touch()
			return _unit_after(root, _seen) if is_one else Vec2.new()
		_WITHOUT_OWN:
			return _direction_for(_velocity)
		_OWN_TWICE:
			return _direction_for(_seen.minus(_own))
	return Vec2.new()


func _direction_for(moving: Vec2) -> Vec2:
	var hit := _first_hit(moving)
	return Vec2.new() if is_nan(hit) else _unit_after(hit, moving)


func _unit_after(seconds: float, moving: Vec2) -> Vec2:
	return Vec2.new(_way.x + moving.x * seconds, _way.y + moving.y * seconds).normalized()


func _a() -> float:
	return _seen.length_squared() - _speed * _speed


func _b() -> float:
	return _way.dot(_seen) - _speed * _radius


func _discriminant() -> float:
	return _b() * _b() - _a() * (_way.length_squared() - _radius * _radius)


# Where rounding may decide, both are so.


func _can_touch() -> bool:
	return _way.length() <= _radius + _off(0.0, _seen)


func _can_be_apart() -> bool:
	return _way.length() >= _radius - _off(0.0, _seen)


func _can_be_equal() -> bool:
	return absf(_a()) <= 10.0 * _ROUNDING * (_seen.length_squared() + _speed * _speed)


func _can_be_faster() -> bool:
	return _a() > 0.0 or _can_be_equal()


func _can_be_slower() -> bool:
	return _a() < 0.0 or _can_be_equal()


func _can_come_nearer() -> bool:
	return _b() < _ROUNDING * (_way.length() * _seen.length() + _speed * _radius)


# Both roots may be one.
func _can_graze() -> bool:
	var c := _way.length_squared() + _radius * _radius
	return absf(_discriminant()) <= 1e-8 * (_b() * _b() + absf(_a()) * c) and _can_be_faster()


func _can_hit_once() -> bool:
	var is_one := _can_be_slower() or _can_graze()
	return _can_be_apart() and (is_one or _can_be_equal()) and not is_nan(_hit) or _can_graze()


func _can_hit_twice() -> bool:
	var comes_by := not is_nan(_hit) or _can_graze()
	return _can_be_apart() and _can_be_faster() and _can_come_nearer() and comes_by


func _can_hit() -> bool:
	return not is_nan(_hit) or _can_touch() or _can_graze() or _is_far()


func _can_miss() -> bool:
	return is_nan(_hit) or _can_graze() or _is_far()


# Nearly as fast, and hardly coming nearer: rounding decides.
func _is_far() -> bool:
	return _can_be_equal()


func _is_flown() -> bool:
	return _can_hit() and not _hit > _LONGEST * 1.001


# By how much a shot along a direction misses, and what the number may be off by.
func _miss_of(direction: Vec2) -> float:
	var relative := _own.plus(direction.scaled(_speed)).minus(_velocity)
	var along := _way.dot(relative)
	if along <= 0.0 or relative.length() == 0.0:
		return _way.length()
	return absf(_way.cross(relative)) / relative.length()


func _misses(direction: Vec2) -> bool:
	return _miss_of(direction) > _radius - 1e-8 * (_way.length() + _radius)


func _hits(direction: Vec2) -> bool:
	return _miss_of(direction) <= _radius + 1e-8 * (_way.length() + _radius)


func _right_direction() -> Vec2:
	return Vec2.new() if is_nan(_hit) else _unit_after(_hit, _seen)


func _claims_of_sentences(step: int) -> Dictionary[String, bool]:
	var present := _way.normalized()
	var is_now := step == 0
	var is_time := step == _TIME
	var is_aim := step == _AIM
	var is_fire := step == _FIRE
	var stands := _own.length() == 0.0
	return {
		"The target touches the shooter already": is_now and _can_touch(),
		"Here a shot at where the target is now hits": is_now and _hits(present),
		"A shot at where the target is now misses it": is_now and _misses(present),
		"The shooter stands still, so V is v": step == _RELATIVE and stands,
		"The bullet takes u along": step == _RELATIVE and not stands,
		"the bullet is somewhere on a circle of radius s t": step == _REACH,
		"They touch already: t is 0": is_time and _can_touch(),
		"holds at two moments. The earlier one counts": is_time and _can_hit_twice(),
		"The target is as fast as the bullet: a is 0": is_time and _can_be_equal() and _can_hit(),
		"a grazing shot": is_time and (_can_graze() or _can_be_equal()),
		"The one below 0 is no hit": is_time and _can_be_slower() and _can_be_apart(),
		"the target is faster and gets away": is_time and _can_be_faster() and _can_miss(),
		"the target is as fast as the bullet and comes no nearer":
		is_time and _can_be_equal() and _can_miss(),
		"No direction hits": is_aim and _can_miss(),
		"They touch already: aim straight": is_aim and _can_touch(),
		"Aim along P + V t, at where": is_aim and _can_hit() and stands,
		"On the ground the bullet flies with u + s d": is_aim and _can_hit() and not stands,
		"Nothing is fired": is_fire and _can_miss(),
		"The hit is too late to be flown": is_fire and _hit > 0.999 * _LONGEST or _is_far(),
		"They touch already: no shot": is_fire and _can_touch(),
		"Press Play: the shot flies": is_fire and _is_flown() and _can_be_apart(),
	}


func _claims_of_card(step: int) -> Dictionary[String, bool]:
	var is_flown := step == _FIRE and _is_flown()
	var is_compared := _mistake != 0 and step >= _AIM
	var is_same := _wrong.distance_to(_right_direction()) <= 1e-6 or _is_far()
	var has_none := _wrong.length() == 0.0
	# Its root may be one or none, or the first place where it touches.
	var is_unsure := _is_far() or _can_graze() or _mistake >= _WITHOUT_OWN
	return {
		"they touch already: t = 0": _can_touch(),
		"it hits after t =": _can_hit() and _can_be_apart(),
		"or later, after": _can_hit_twice(),
		"no hit: the target is faster": _can_be_faster() and _can_miss(),
		"than the bullet and gets away": _can_be_faster() and _can_miss(),
		"no hit: the target is as fast": _can_be_equal() and _can_miss(),
		"as the bullet and comes no nearer": _can_be_equal() and _can_miss(),
		"miss ": is_flown,
		"px; ε × condition": is_flown,
		"the mistake finds no direction": is_compared and (has_none or is_unsure),
		"the mistake changes nothing here": is_compared and is_same,
		"the mistake hits all the same": is_compared and _hits(_wrong),
		"the mistake misses by": is_compared and not has_none and _misses(_wrong),
	}


func _problem_of_numbers(verdict: PackedStringArray) -> String:
	for line in verdict:
		var first := SeenLesson.number_behind("it hits after t = ", line)
		if not is_nan(first) and not _is_root(first, 1.0):
			return "it does not hit then: “%s”" % line
		var later := SeenLesson.number_behind("or later, after ", line)
		if not is_nan(later) and not _is_root(later, -1.0):
			return "it does not hit then: “%s”" % line
		var miss := SeenLesson.number_behind("misses by ", line)
		if not is_nan(miss) and not _is_miss(miss, _wrong):
			return "it misses by %s: “%s”" % [_miss_of(_wrong), line]
		if line.begins_with("miss ") and not _is_rounding(SeenLesson.number_behind("miss ", line)):
			return "a right shot is not so far off: “%s”" % line
		var bound := SeenLesson.number_behind("; ε × condition ", line)
		if not is_nan(bound) and not _is_bound(bound):
			return "rounding moves it by %s: “%s”" % [_from_rounding(), line]
	return ""


# Whether the gap closes (1), or opens (-1), within the last digit that is shown.
func _is_root(shown: float, sign_before: float) -> bool:
	var before := sign_before * _gap(shown * (1.0 - 6e-4), _seen)
	var after := sign_before * _gap(shown * (1.0 + 6e-4), _seen)
	var off := _off(shown, _seen) * 1e3
	# Where rounding decides whether there is a hit, it comes late.
	var is_late := shown * _speed > 1e6 * (_way.length() + _radius)
	return before >= -off and after <= off or _can_graze() or _is_far() and is_late


# Three digits. A shot that nearly follows the target has few digits.
func _is_miss(shown: float, direction: Vec2) -> bool:
	var wanted := _miss_of(direction)
	return absf(shown - wanted) <= 0.006 * wanted + 1e-6 * _way.length()


func _is_rounding(miss: float) -> bool:
	return miss <= 1.5 * _from_rounding() or _can_graze() or _can_touch() or _is_far()


func _is_bound(shown: float) -> bool:
	var wanted := _from_rounding()
	return absf(shown - wanted) <= 0.07 * wanted or _can_graze() or _is_far()


# Over all numbers of the shot: places, velocities, speed, radius, direction, time.
func _from_rounding() -> float:
	if is_nan(_hit):
		return INF
	var direction := _right_direction()
	var flies := _own.plus(direction.scaled(_speed)).minus(_velocity)
	var sizes := 0.0
	for place: Vec2 in [_shooter, _target]:
		sizes += absf(place.x) + absf(place.y)
	for moving: Vec2 in [_velocity, _own]:
		sizes += (absf(moving.x) + absf(moving.y)) * _hit
	sizes += (1.0 + absf(direction.x) + absf(direction.y)) * (_speed * _hit + _radius)
	return _EPSILON * (sizes + flies.length() * _hit)


func _problem_of_sign(seen: SeenLesson) -> String:
	var is_compared := _mistake != 0 and seen.step >= _AIM
	var is_so: Dictionary[String, bool] = {
		"": true, "!": _can_hit(), "×": _can_miss(), "✗": is_compared
	}
	var is_right: bool = is_so.get(seen.verdict_sign, false)
	return "" if is_right else "the ball of the card has a “%s”" % seen.verdict_sign


func _problem_of_rows(rows: Array[PackedStringArray]) -> String:
	for row in rows:
		var is_careful := row[0] == "t, careful"
		var time := SeenLesson.first_number(row[1])
		var error := SeenLesson.first_number(row[2])
		if row[1] == "none":
			if is_careful and not _can_miss():
				return "there is a hit: “%s”" % "  ".join(row)
		elif is_careful and not (_is_root(time, 1.0) or _can_touch()):
			return "it does not hit then: “%s”" % "  ".join(row)
		elif is_careful and not error <= 1e-9 * (1.0 + time) and not _can_graze() and not _is_far():
			return "it is not so far off: “%s”" % "  ".join(row)
		elif not is_careful and not _is_error(time, error):
			return "it is off by another number: “%s”" % "  ".join(row)
	return ""


# Of the time as it is shown, with four digits.
func _is_error(time: float, error: float) -> bool:
	if is_nan(_hit) or is_nan(error) or _can_graze() or _is_far():
		return true
	return absf(error - absf(time - _hit)) <= 0.06 * error + 1e-3 * (time + _hit)


func _problem_of_labels(labels: PackedStringArray, step: int) -> String:
	var is_hit := step >= _TIME and _can_hit()
	var stands := _own.length() == 0.0
	var is_seen := step >= _RELATIVE and step < _AIM
	var claims: Dictionary[String, bool] = {
		"v": true,
		"u": true,
		"R": true,
		"P": step >= _RELATIVE and step < _FIRE,
		"V": is_seen and not stands,
		"−u": is_seen and not stands,
		"V t": is_hit and step == _TIME,
		"P + V t": is_hit and step == _TIME,
		"s d": is_hit and step == _AIM,
		"s · 1 s": step == _REACH,
	}
	for label in labels:
		if label.ends_with(" px"):
			var shot := _way.normalized() if step == 0 else _wrong
			var is_drawn := step == 0 or _mistake != 0 and step >= _AIM
			if not is_drawn or not _is_miss(SeenLesson.first_number(label), shot):
				return "it misses by %s: “%s”" % [_miss_of(shot), label]
		elif not claims.get(label, false):
			return "it should not be on the board: “%s”" % label
	return ""


# What a step introduces is not shown before it.
func _problem_of_time(seen: SeenLesson) -> String:
	if seen.rows and seen.step < _TIME:
		return "the table comes before the moment of the hit"
	if seen.verdict and seen.step < _TIME:
		return "the card comes before the moment of the hit"
	for line in seen.lines:
		if line.contains("mistake:") and (_mistake == 0 or seen.step < _AIM):
			return "no wrong direction is shown yet: “%s”" % line
	return ""
