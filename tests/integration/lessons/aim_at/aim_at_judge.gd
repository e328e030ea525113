extends LessonJudge
## Judges what the lesson on aiming at a target says. Angles in degrees.

const _EPSILON := 2.220446049250313e-16
# What an angle may be off by, in degrees.
const _OFF := 1e-9

# The steps, counted from 0.
const _SPRITE := 1
const _LOOK := 2
const _NESTED := 3
const _TURN := 4
const _EARLY := 5
const _FIRE := 6

const _DEGREES := 4
const _SWAPPED := 30
const _NOT_REDUCED := 101
const _LONG_WAY := 102

var _hull: PackedFloat64Array
var _target: PackedFloat64Array
var _alpha: float
var _beta: float
var _length: float
var _speed: float
var _half_life: float
var _fire: float
var _radius: float
var _mistake: int
# From the hull to the target.
var _x: float
var _y: float
var _distance: float
var _theta: float
# From the barrel to the target, the short way.
var _delta: float


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
	_hull = state["hull"]
	_target = state["target"]
	_alpha = state["hull_degrees"]
	_beta = state["barrel_degrees"]
	_length = state["length"]
	_speed = state["speed"]
	_half_life = state["half_life"]
	_fire = state["fire"]
	_radius = state["radius"]
	_mistake = state["mistake"]
	_x = _target[0] - _hull[0]
	_y = _target[1] - _hull[1]
	_distance = sqrt(_x * _x + _y * _y)
	_theta = rad_to_deg(atan2(_y, _x))
	_delta = _short(_theta - _alpha - _beta)


static func _short(degrees: float) -> float:
	var turn := fposmod(degrees, 360.0)
	return turn - 360.0 if turn > 180.0 else turn


func _has_direction() -> bool:
	return _distance > 0.0


# Where rounding may decide, both are so.
func _can_be_near() -> bool:
	return _distance <= _length * (1.0 + 1e-12)


func _can_be_far() -> bool:
	return _distance >= _length * (1.0 - 1e-12)


func _left() -> float:
	return absf(_delta) * pow(2.0, -_fire / _half_life)


# By how much a barrel misses that is off by so many degrees; nothing is nearer than the nozzle for
# one that points away.
func _miss_of(off: float) -> float:
	var angle := deg_to_rad(absf(_short(off)))
	var ahead := _distance * cos(angle) - _length
	if ahead <= 0.0:
		return sqrt(ahead * ahead + pow(_distance * sin(angle), 2.0))
	return _distance * sin(angle)


func _wrong_off() -> float:
	match _mistake:
		_DEGREES:
			return _alpha + rad_to_deg(_theta - _alpha) - _theta
		_SWAPPED:
			return rad_to_deg(atan2(_x, _y)) - _theta
		_NOT_REDUCED:
			return _alpha
	return 0.0


func _hits(miss: float) -> bool:
	return miss <= _radius + 1e-7 * (_distance + _length)


func _misses(miss: float) -> bool:
	return miss >= _radius - 1e-7 * (_distance + _length)


# The turn of a barrel that does not take the short way.
func _long_turn() -> float:
	return _theta - _short(_alpha + _beta)


# An angle that is almost half a turn may be either way round.
func _is_half_turn(degrees: float) -> bool:
	return absf(absf(_short(degrees)) - 180.0) <= _OFF


func _claims_of_sentences(step: int) -> Dictionary[String, bool]:
	var sees := _has_direction()
	var is_early := step == _EARLY and sees
	var is_fire := step == _FIRE and sees
	return {
		"it points along γ = α + β": step == 0,
		"its angle is atan2(vy, vx)": step == _SPRITE,
		"The hull sees the target at θ": step == _LOOK and sees,
		"Hull and target are in one place": step == _LOOK and not sees,
		"What is left for the barrel itself is θ − α": step == _NESTED and sees,
		"Without a direction there is no angle": step == _NESTED and not sees,
		"Nothing has to be turned": step == _TURN and (not sees or absf(_delta) <= _OFF),
		"It turns the short way": step == _TURN and sees,
		"nothing to fire at": step >= _EARLY and not sees,
		"the bullet starts behind it": (is_early or is_fire) and _can_be_near(),
		"near enough: it hits the disc": is_early and _hits(_miss_of(_left())),
		"before the barrel is aligned, and misses": is_early and _misses(_miss_of(_left())),
		"Aligned, it fires from the nozzle": is_fire and _can_be_far(),
	}


func _claims_of_card(step: int) -> Dictionary[String, bool]:
	var sees := _has_direction()
	var is_near := sees and step >= _EARLY and _can_be_near()
	var is_early := step == _EARLY and sees and _can_be_far()
	var is_fire := step == _FIRE and sees and _can_be_far()
	var is_long := step == _TURN and _mistake == _LONG_WAY and sees
	var is_wrong := is_fire and _mistake != 0 and _mistake != _LONG_WAY
	var long_is_same := absf(_long_turn() - _delta) <= 1e-6 or _is_half_turn(_delta)
	var wrong_is_same := absf(_short(_wrong_off())) <= 1e-6
	return {
		"no direction: hull and target": not sees,
		"the target is nearer than the nozzle": is_near,
		"the bullet starts behind it": is_near,
		"on the hull:": step == _NESTED and sees,
		"the short way:": step == _TURN and sees,
		"still ": is_early,
		"it passes within R: it hits": is_early and _hits(_miss_of(_left())),
		"it misses by": is_early and _misses(_miss_of(_left())),
		"s on it hits": is_early and _misses(_miss_of(_left())),
		"s after the shot": is_fire,
		"miss ": is_fire,
		"px; ε × condition": is_fire,
		"the mistake changes nothing here": is_long and long_is_same or is_wrong and wrong_is_same,
		"the mistake: ": is_long,
		"the mistake hits all the same": is_wrong and _hits(_miss_of(_wrong_off())),
		"the mistake misses by": is_wrong and _misses(_miss_of(_wrong_off())),
	}


func _problem_of_sign(seen: SeenLesson) -> String:
	var is_compared := _mistake != 0 and seen.step in [_TURN, _FIRE]
	var hits := _has_direction() and _can_be_far()
	var early_misses := seen.step == _EARLY and _misses(_miss_of(_left()))
	var is_so: Dictionary[String, bool] = {
		"": true,
		"!": hits and (seen.step != _EARLY or _hits(_miss_of(_left()))),
		"×": not _has_direction() or _can_be_near() or early_misses,
		"✗": is_compared
	}
	var is_right: bool = is_so.get(seen.verdict_sign, false)
	return "" if is_right else "the ball of the card has a “%s”" % seen.verdict_sign


func _problem_of_numbers(verdict: PackedStringArray) -> String:
	for line in verdict:
		if not _is_angle(line, "on the hull: ", _in_range(_short(_theta - _alpha))):
			return "it is %s: “%s”" % [_short(_theta - _alpha), line]
		if not _is_turn(line, "the short way: ", _delta):
			return "it is %s: “%s”" % [_delta, line]
		if not _is_turn(line, "the mistake: ", _long_turn()):
			return "it is %s: “%s”" % [_long_turn(), line]
		if not _has_times(line):
			return "it is another number: “%s”" % line
	return _problem_of_misses(verdict)


# What is left of the turn, until when to wait, and how long the bullet flies.
func _has_times(line: String) -> bool:
	var left := SeenLesson.degrees_behind("still ", line)
	var wait := SeenLesson.number_behind("from t = ", line)
	var flight := SeenLesson.number_behind("it hits ", line)
	var right := (_distance - _length) / _speed
	var off := 1.1e-3 * right + 1e-12 * _distance / _speed
	return (
		(is_nan(left) or absf(left - _left()) <= 0.0051 * _left() + _OFF)
		and (is_nan(wait) or _is_least_wait(wait))
		and (is_nan(flight) or absf(flight - right) <= off)
	)


func _problem_of_misses(verdict: PackedStringArray) -> String:
	for line in verdict:
		var early := line.begins_with("it misses by ")
		var miss := SeenLesson.number_behind("misses by ", line)
		if not is_nan(miss) and not _is_miss(miss, _left() if early else _wrong_off()):
			return "it is another number: “%s”" % line
		if line.begins_with("miss "):
			miss = SeenLesson.number_behind("miss ", line)
			if not miss <= 1.5 * _from_rounding():
				return "a right shot is not so far off: “%s”" % line
		var bound := SeenLesson.number_behind("; ε × condition ", line)
		if not is_nan(bound) and absf(bound - _from_rounding()) > 0.07 * _from_rounding():
			return "it is %s: “%s”" % [_from_rounding(), line]
	return ""


# Three digits; an angle in radians has few digits where it counts many turns.
func _is_miss(shown: float, off: float) -> bool:
	return absf(shown - _miss_of(off)) <= 0.0051 * _miss_of(off) + 1e-7 * (_distance + _length)


# A shot before that time misses, and one after it hits.
func _is_least_wait(wait: float) -> bool:
	var before := _delta * pow(2.0, -wait * 0.99 / _half_life)
	var after := _delta * pow(2.0, -wait * 1.01 / _half_life)
	return _misses(_distance * sin(deg_to_rad(minf(absf(before), 90.0)))) and _hits(_miss_of(after))


# Over all numbers of the shot: places, direction, length, speed, time.
func _from_rounding() -> float:
	var sizes := absf(_hull[0]) + absf(_hull[1]) + absf(_target[0]) + absf(_target[1])
	sizes += _length + 2.0 * maxf(_distance - _length, 0.0)
	sizes += maxf(_distance, _length) * (absf(_x) + absf(_y)) / _distance
	return _EPSILON * sizes


func _in_range(degrees: float) -> float:
	return Conventions.in_range(degrees)


func _is_angle(line: String, words: String, wanted: float) -> bool:
	var shown := SeenLesson.degrees_behind(words, line)
	return is_nan(shown) or _is_half_turn(wanted) or _is_close(shown, wanted)


func _is_turn(line: String, words: String, wanted: float) -> bool:
	var shown := SeenLesson.degrees_behind(words, line)
	if is_nan(shown):
		return true
	var is_clockwise := not line.contains("counter-clockwise")
	var has_way := is_clockwise == (wanted > 0.0) or absf(wanted) <= _OFF or _is_half_turn(wanted)
	return has_way and _is_close(shown, absf(wanted))


func _is_close(shown: float, wanted: float) -> bool:
	return SeenLesson.is_close_angle(shown, wanted, _OFF)


func _problem_of_rows(rows: Array[PackedStringArray]) -> String:
	for row in rows:
		if not is_pair(row[1], _x / _distance, _y / _distance, 1e-12):
			return "it is another direction: “%s”" % "  ".join(row)
		if not SeenLesson.first_number(row[2]) <= 1e-14:
			return "it is not so far off: “%s”" % "  ".join(row)
	return ""


func _problem_of_labels(labels: PackedStringArray, step: int) -> String:
	var sees := _has_direction()
	var is_arc := step in [0, _NESTED]
	var claims: Dictionary[String, bool] = {
		"α = ": is_arc,
		"β = ": step == 0,
		"θ = ": sees and step in [_LOOK, _NESTED],
		"β′ = ": sees and step == _NESTED,
		"δ = ": sees and step == _TURN,
		"v": step == _SPRITE,
	}
	for label in labels:
		if label.ends_with(" px"):
			var off := _left() if step == _EARLY else _wrong_off()
			if step < _EARLY or not _is_miss(SeenLesson.first_number(label), off):
				return "it is another number: “%s”" % label
		elif not claims.get(label, false):
			return "it should not be on the board: “%s”" % label
	return ""


# What a step introduces is not shown before it.
func _problem_of_time(seen: SeenLesson) -> String:
	if seen.rows and seen.step < _LOOK:
		return "the table comes before the direction"
	if seen.verdict and seen.step < _NESTED:
		return "the card comes before the angle"
	return ""
