extends LessonJudge
## Judges what the lesson on the easy bounce says in frame 0.
##
## A wall is judged as the floor that it becomes when x and y change places.

# What a sum of doubles may be off by, as a share of its terms.
const _ROUNDING := 1e-13
# Numbers on the card have three digits.
const _THREE_DIGITS := 0.0051
const _FRAMES_AFTER := 4

var _is_wall: bool
var _radius: float
var _sine: float
var _cosine: float
# Of the ball from the middle of the line, with y down.
var _x: float
var _y: float
var _vx: float
var _vy: float
# What a place and a velocity may be off by.
var _off: float
var _v_off: float


func problem(seen: SeenLesson) -> String:
	_take(seen.state)
	for found: String in [
		false_claim([seen.sentence], _claims_of_sentences()),
		false_claim(seen.verdict, _claims_of_card()),
		_problem_of_card_numbers(seen.verdict),
		_problem_of_sign(seen.verdict_sign),
		_problem_of_rows(seen.rows),
		_problem_of_labels(seen.labels),
		_problem_of_hits(seen.lines),
	]:
		if found:
			return found
	return ""


func _take(state: Dictionary) -> void:
	_is_wall = state["is_wall"]
	var ball: PackedFloat64Array = state["ball"]
	var pivot: PackedFloat64Array = state["pivot"]
	var tilt: float = state["tilt_degrees"]
	var across := 1 if _is_wall else 0
	var down := 1 - across
	_sine = sin(deg_to_rad(-tilt if _is_wall else tilt))
	_cosine = cos(deg_to_rad(tilt))
	_x = ball[across] - pivot[across]
	_y = ball[down] - pivot[down]
	_vx = ball[2 + across]
	_vy = ball[2 + down]
	_radius = ball[4]
	_off = _radius
	for number: float in ball.slice(0, 4) + pivot:
		_off += absf(number)
	_off *= _ROUNDING
	_v_off = _ROUNDING * (absf(_vx) + absf(_vy))


func _is_level() -> bool:
	return _sine == 0.0


func _straight() -> float:
	return _x * _sine / _cosine - _y


func _shortest() -> float:
	return _x * _sine - _y * _cosine


# By how much straight is longer than shortest.
func _too_long() -> float:
	return absf(_straight()) - absf(_shortest())


# Where rounding alone decides, both a hit and no hit may be said.
func _can_hit() -> bool:
	return _shortest() < _radius + _off


func _can_miss() -> bool:
	return _shortest() >= _radius - _off


func _easy_can_hit() -> bool:
	return _straight() < _radius + _off


func _easy_can_miss() -> bool:
	return _straight() >= _radius - _off


func _into_line() -> float:
	return -(_vx * _sine - _vy * _cosine)


func _can_reflect() -> bool:
	return _can_hit() and _into_line() > -_v_off


func _can_keep() -> bool:
	return _can_miss() or _into_line() <= _v_off


func _easy_can_keep() -> bool:
	return _easy_can_miss() or _vy <= 0.0


func _easy_can_flip() -> bool:
	return _easy_can_hit() and _vy > 0.0


# What a program makes of place and velocity [x, y, vx, vy].
func _easy(ball: PackedFloat64Array) -> PackedFloat64Array:
	var straight := ball[0] * _sine / _cosine - ball[1]
	if straight >= _radius:
		return ball
	var flipped := -absf(ball[3])
	return [ball[0], ball[1] + straight - _radius, ball[2], flipped]


func _right(ball: PackedFloat64Array) -> PackedFloat64Array:
	var deep := _radius - (ball[0] * _sine - ball[1] * _cosine)
	if deep <= 0.0:
		return ball
	var into := minf(ball[2] * _sine - ball[3] * _cosine, 0.0)
	return [
		ball[0] + deep * _sine,
		ball[1] - deep * _cosine,
		ball[2] - 2.0 * into * _sine,
		ball[3] + 2.0 * into * _cosine,
	]


func _place_error() -> float:
	var ball: PackedFloat64Array = [_x, _y, _vx, _vy]
	var easy := _easy(ball)
	var right := _right(ball)
	return Vec2.new(easy[0] - right[0], easy[1] - right[1]).length()


func _velocity_error() -> float:
	var ball: PackedFloat64Array = [_x, _y, _vx, _vy]
	var easy := _easy(ball)
	var right := _right(ball)
	return Vec2.new(easy[2] - right[2], easy[3] - right[3]).length()


# The farthest that the balls of both programs get from each other in the frames that are shown.
func _farthest_apart() -> float:
	var easy := _easy([_x, _y, _vx, _vy])
	var right := _right([_x, _y, _vx, _vy])
	var farthest := 0.0
	for i in _FRAMES_AFTER + 1:
		farthest = maxf(farthest, Vec2.new(easy[0] - right[0], easy[1] - right[1]).length())
		easy = _easy([easy[0] + easy[2], easy[1] + easy[3], easy[2], easy[3]])
		right = _right([right[0] + right[2], right[1] + right[3], right[2], right[3]])
	return farthest


func _claims_of_sentences() -> Dictionary[String, bool]:
	var is_tilted := not _is_level()
	var is_floor := _is_level() and not _is_wall
	var is_upright := _is_level() and _is_wall
	return {
		"Here the ball stays off the line": _can_miss(),
		"Now the ball is behind the line": _shortest() <= -_radius + _off,
		"Now the ball overlaps the line": _can_hit() and _shortest() > -_radius - _off,
		"Detect: on a tilted line": is_tilted,
		"Detect: x is enough. If wall": is_upright,
		"Detect: y is enough. If floor": is_floor,
		"Put back: only after a hit": _can_miss(),
		"Put back: along the normal": _can_hit() and is_tilted,
		"Put back: change only x": _can_hit() and is_upright,
		"Put back: change only y": _can_hit() and is_floor,
		"Flip: only after a hit": _can_miss(),
		"Here v stays": _can_hit() and _can_keep(),
		"Flip: only v's part along the normal": _can_reflect() and is_tilted,
		"Flip: x of v changes its sign": _can_reflect() and is_upright,
		"Flip: y of v changes its sign": _can_reflect() and is_floor,
		"Then tilt the line": _is_level(),
		"Here both programs do the same": is_tilted and _farthest_apart() <= 100.0 * _off,
		"the easy ball goes astray": is_tilted and _farthest_apart() > 0.0,
	}


func _claims_of_card() -> Dictionary[String, bool]:
	var misses := _easy_can_miss() and _can_hit()
	return {
		"Right on a level line": _is_level() and not _is_wall,
		"Right on an upright line": _is_level() and _is_wall,
		"straight is the shortest way": _is_level(),
		"straight is along the normal": _is_level() and _can_hit(),
		"its sign is all that changes": _is_level() and _can_reflect(),
		"Here both distances": absf(_too_long()) <= _off,
		"Here both places": _place_error() <= _off,
		"Here flipped and reflected": _velocity_error() <= 10.0 * _v_off,
		"are the same": true,
		"The easy way misses the hit": misses,
		"its distance is": misses,
		"Straight is not shortest": not _is_level() and _straight() != 0.0,
		"px too far": not _is_level(),
		"No hit": _can_miss(),
		"nothing to put back": _can_miss(),
		"v stays": _can_miss(),
		"v stays:": _can_keep() and _easy_can_keep(),
		"it does not point into the line": _into_line() <= _v_off,
		"the ball stays": misses,
		"Put back": not _is_level() and _can_hit() and _easy_can_hit(),
		"and still": _easy_can_hit() and not _is_level(),
		"v points into the line, yet it stays": _can_reflect() and _easy_can_keep(),
		"v does not point into the line, yet it flips": _can_keep() and _easy_can_flip(),
		"Flipped is not reflected": not _is_level() and _can_reflect() and _easy_can_flip(),
		"px per frame off": true,
		"The easy way is right": _is_level(),
		"in all three steps": _is_level(),
		"Frame 0:": true,
		"both balls are in one place": _place_error() <= _off,
		"the easy ball is": not _is_level(),
	}


func _problem_of_card_numbers(lines: PackedStringArray) -> String:
	var wanted: Dictionary[String, float] = {
		"its distance is": _too_long(),
		"the ball stays": _radius - _shortest(),
		"Put back": _place_error(),
		"and still": _radius * (1.0 - _cosine),
		"the easy ball is": _place_error(),
	}
	var wanted_before: Dictionary[String, float] = {
		"px too far": _too_long(), "px per frame off": _velocity_error()
	}
	for line in lines:
		for words in wanted:
			var shown := SeenLesson.number_behind(words, line)
			if not is_nan(shown) and not _is_like(shown, wanted[words]):
				return "it is %s: “%s”" % [wanted[words], line]
		for words in wanted_before:
			if (
				line.ends_with(words)
				and not _is_like(SeenLesson.first_number(line), wanted_before[words])
			):
				return "it is %s: “%s”" % [wanted_before[words], line]
	return ""


func _is_like(shown: float, wanted: float) -> bool:
	return absf(shown - wanted) <= _THREE_DIGITS * absf(wanted) + _off + _v_off


func _problem_of_sign(sign_text: String) -> String:
	var is_so := true
	match sign_text:
		"✓":
			is_so = _is_level()
		"✗":
			is_so = not _is_level()
		"0":
			is_so = _can_miss() or _can_keep() and _easy_can_keep()
	return "" if is_so else "the ball of the card has a “%s”" % sign_text


# Value and error of each row, in the order of the table.
func _problem_of_rows(rows: Array[PackedStringArray]) -> String:
	var values: Dictionary[String, float] = {
		"easy distance": _straight(), "by the normal": _shortest()
	}
	var errors: Dictionary[String, float] = {
		"easy distance": absf(_straight() - _shortest()),
		"by the normal": 0.0,
		"easy place": _place_error(),
		"easy velocity": _velocity_error(),
	}
	for row in rows:
		var value := SeenLesson.first_number(row[1])
		if values.has(row[0]) and not SeenLesson.is_close(value, values[row[0]], _off):
			return "it is %s: “%s”" % [values[row[0]], "  ".join(row)]
		if not _is_like(SeenLesson.first_number(row[2]), errors[row[0]]):
			return "the error is %s: “%s”" % [errors[row[0]], "  ".join(row)]
	return ""


func _problem_of_labels(labels: PackedStringArray) -> String:
	var lengths: Dictionary[String, float] = {"shortest ": _shortest(), "easy ": _straight()}
	for label in labels:
		for words in lengths:
			var shown := SeenLesson.number_behind(words, label)
			if not is_nan(shown) and not SeenLesson.is_close(shown, lengths[words], _off):
				return "it is %s: “%s”" % [lengths[words], label]
	return ""


# What the lines of either program say of a hit and of the velocity.
func _problem_of_hits(lines: PackedStringArray) -> String:
	for line in lines:
		var claims: Dictionary[String, bool] = {"": true}
		if line.begins_with("easy:"):
			claims = {
				"": true,
				": hit": _easy_can_hit(),
				"no hit": _easy_can_miss(),
				"is not above 0: v stays": _vy <= 0.0,
			}
		elif line.begins_with("right:"):
			claims = {
				"": true,
				": hit": _can_hit(),
				"no hit": _can_miss(),
				"v · n̂ is not below 0: v stays": _can_keep(),
			}
		for words in claims:
			if line.contains(words) and not claims[words]:
				return "it is not so: “%s”" % line
	return ""
