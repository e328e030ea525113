extends LessonJudge
## Judges what the lesson on the easy bounce says in the frame that is shown.
##
## The frames before frame 0 are free flight; after it the easy program leads the ball that is
## shown.
## A wall is judged as the floor that it becomes when x and y change places.

# What a sum of doubles may be off by, as a share of its terms.
const _ROUNDING := 1e-13
# Numbers on the card have three digits.
const _THREE_DIGITS := 0.0051
const _FRAMES_AFTER := 4
# How many rows the table has at each step.
const _ROWS: Array[int] = [0, 2, 3, 4, 4]

var _step: int
var _frame: int
var _is_wall: bool
var _pivot: PackedFloat64Array
var _radius: float
var _sine: float
var _cosine: float
# Place and velocity in frame 0, from the middle of the line, with y down: x, y, vx, vy.
var _first: PackedFloat64Array
# The same in the frame that is shown, after its move.
var _x: float
var _y: float
var _vx: float
var _vy: float
# What a place and a velocity may be off by.
var _off: float
var _v_off: float


func problem(seen: SeenLesson) -> String:
	_step = seen.step
	_frame = _frame_in(seen.lines)
	_take(seen.state)
	return first_of(
		[
			false_claim([seen.sentence], _claims_of_sentences()),
			_problem_of_card(seen.verdict),
			false_claim(seen.verdict, _claims_of_card()),
			_problem_of_card_numbers(seen.verdict),
			_problem_of_sign(seen.verdict_sign, seen.verdict),
			_problem_of_rows(seen.rows),
			_problem_of_labels(seen.labels),
			_problem_of_hits(seen.lines),
			"there is no reason for “%s”" % seen.notice if seen.notice else "",
		]
	)


func _take(state: Dictionary) -> void:
	_is_wall = state["is_wall"]
	var ball: PackedFloat64Array = state["ball"]
	var pivot: PackedFloat64Array = state["pivot"]
	var tilt: float = state["tilt_degrees"]
	_pivot = pivot
	var across := 1 if _is_wall else 0
	var down := 1 - across
	_sine = sin(deg_to_rad(-tilt if _is_wall else tilt))
	_cosine = cos(deg_to_rad(tilt))
	_radius = ball[4]
	_first = [
		ball[across] - pivot[across],
		ball[down] - pivot[down],
		ball[2 + across],
		ball[2 + down],
	]
	_move_to_frame()
	_off = _radius
	for number: float in ball.slice(0, 4) + pivot:
		_off += absf(number)
	_off *= _ROUNDING
	_v_off = _ROUNDING * (absf(_vx) + absf(_vy))


# The number in the line `r = 60     tilt = 30°     frame 1`; 0 where there is none.
static func _frame_in(lines: PackedStringArray) -> int:
	for line in lines:
		var number := SeenLesson.number_behind("     frame ", line)
		if not is_nan(number):
			return int(number)
	return 0


func _move_to_frame() -> void:
	var ball := _first
	for i in absi(_frame):
		ball = _moved(_easy(ball), 1.0) if _frame > 0 else _moved(ball, -1.0)
	_x = ball[0]
	_y = ball[1]
	_vx = ball[2]
	_vy = ball[3]


static func _moved(ball: PackedFloat64Array, times: float) -> PackedFloat64Array:
	return [ball[0] + times * ball[2], ball[1] + times * ball[3], ball[2], ball[3]]


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


# How far the balls of both programs are from each other at the end of each frame from frame 0 on.
func _distances_apart() -> PackedFloat64Array:
	var easy := _easy(_first)
	var right := _right(_first)
	var distances: PackedFloat64Array = []
	for i in _FRAMES_AFTER + 1:
		distances.append(Vec2.new(easy[0] - right[0], easy[1] - right[1]).length())
		easy = _easy(_moved(easy, 1.0))
		right = _right(_moved(right, 1.0))
	return distances


func _farthest_apart() -> float:
	var farthest := 0.0
	for distance in _distances_apart():
		farthest = maxf(farthest, distance)
	return farthest


# Before frame 0 there is one ball.
func _apart_now() -> float:
	return _distances_apart()[_frame] if _frame >= 0 else 0.0


func _claims_of_sentences() -> Dictionary[String, bool]:
	var is_tilted := not _is_level()
	var is_floor := _is_level() and not _is_wall
	var is_upright := _is_level() and _is_wall
	return {
		"Here the ball does not reach the line": _can_miss(),
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
		"Flip: only the part of v along the normal": _can_reflect() and is_tilted,
		"Flip: x of v changes its sign": _can_reflect() and is_upright,
		"Flip: y of v changes its sign": _can_reflect() and is_floor,
		"Then tilt the line": _is_level(),
		"Here both programs do the same": is_tilted and _farthest_apart() <= 100.0 * _off,
		"the easy ball goes astray": is_tilted and _farthest_apart() > 0.0,
	}


# It comes with the first step that can be wrong.
func _problem_of_card(lines: PackedStringArray) -> String:
	if lines.is_empty() != (_step == 0):
		return "the card says “%s” at step %d" % ["".join(lines), _step + 1]
	return ""


func _claims_of_card() -> Dictionary[String, bool]:
	var misses := _easy_can_miss() and _can_hit()
	return {
		"Right on a level line": _is_level() and not _is_wall,
		"Right on an upright line": _is_level() and _is_wall,
		"straight is the shortest way": _is_level(),
		"straight is along the normal": _is_level() and _can_hit(),
		"only the sign of y changes": _is_level() and _can_reflect() and not _is_wall,
		"only the sign of x changes": _is_level() and _can_reflect() and _is_wall,
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
		"Frame %s:" % str(_frame).replace("-", NumberText.MINUS): _step == 4,
		"both balls are in one place": _apart_now() <= 100.0 * _off,
		"the easy ball is": not _is_level(),
	}


func _problem_of_card_numbers(lines: PackedStringArray) -> String:
	var wanted: Dictionary[String, float] = {
		"its distance is": _too_long(),
		"the ball stays": _radius - _shortest(),
		"Put back": _place_error(),
		"and still": _radius * (1.0 - _cosine),
		"the easy ball is": _apart_now(),
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


# A tilted line can be as good as level by luck: then the lines of the card are judged.
func _problem_of_sign(sign_text: String, lines: PackedStringArray) -> String:
	var words := " ".join(lines)
	var is_so := false
	match sign_text:
		"":
			is_so = lines.is_empty()
		"✓":
			is_so = _is_level() and words.contains("ight")
		"✗":
			is_so = not _is_level() and (words.contains(" px "))
		"=":
			is_so = not _is_level() and (words.contains("the same") or words.contains("one place"))
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
	if rows.size() != _ROWS[_step]:
		return "the table has %d rows at step %d" % [rows.size(), _step + 1]
	for row in rows:
		if not errors.has(row[0]):
			return "no value is known for “%s”" % row[0]
		var value := SeenLesson.first_number(row[1])
		if row[0] in ["easy place", "easy velocity"] and not _is_pair(row[1], row[0]):
			return "the easy program makes %s: “%s”" % [_easy(_now()), "  ".join(row)]
		if values.has(row[0]) and not SeenLesson.is_close(value, values[row[0]], _off):
			return "it is %s: “%s”" % [values[row[0]], "  ".join(row)]
		if not _is_like(SeenLesson.first_number(row[2]), errors[row[0]]):
			return "the error is %s: “%s”" % [errors[row[0]], "  ".join(row)]
	return ""


func _now() -> PackedFloat64Array:
	return [_x, _y, _vx, _vy]


# Whether a pair with three digits is the place or the velocity that the easy program makes. Where
# rounding alone decides whether it is a hit, both are.
func _is_pair(text: String, title: String) -> bool:
	var at := 0 if title == "easy place" else 2
	var parts := text.trim_prefix("(").trim_suffix(")").split(", ")
	for ball: PackedFloat64Array in [_easy(_now()), _now()]:
		var is_so := _easy_can_miss() or ball != _now() or _easy(_now()) == _now()
		for i in 2:
			var wanted := ball[at + ((1 - i) if _is_wall else i)]
			if at == 0:
				wanted += _pivot[i]
			is_so = is_so and _is_like(SeenLesson.first_number(parts[i]), wanted)
		if is_so:
			return true
	return false


# What is drawn at each step; what belongs to a hit or to a tilted line only where there is one.
func _claims_of_labels() -> Dictionary[String, bool]:
	var tilted := not _is_level()
	return {
		"before": _step == 0,
		"v": _step in [0, 3, 4],
		"L": _step == 1 and tilted,
		"P − L": _step == 1 and tilted,
		"n̂": _step == 3 and tilted,
		"flipped": _step == 3 and _is_level() and _can_reflect(),
		"easy": tilted and (_step == 4 or _step in [2, 3] and (_can_hit() or _easy_can_hit())),
		"right": tilted and (_step == 4 or _step in [2, 3] and (_can_hit() or _easy_can_hit())),
	}


func _problem_of_labels(labels: PackedStringArray) -> String:
	var claims := _claims_of_labels()
	var lengths: Dictionary[String, float] = {"shortest ": _shortest(), "easy ": _straight()}
	for label in labels:
		if label in claims:
			if not claims[label]:
				return "nothing is to be called “%s” at step %d" % [label, _step + 1]
			continue
		var known := false
		for words in lengths:
			var start := words if not _is_level() else ""
			var shown := SeenLesson.first_number(label.trim_prefix(start))
			if is_nan(shown) or not label.begins_with(start):
				continue
			known = true
			if not SeenLesson.is_close(shown, lengths[words], _off) or _step != 1:
				return "it is %s: “%s”" % [lengths[words], label]
		if not known:
			return "no claim is known for “%s”" % label
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
