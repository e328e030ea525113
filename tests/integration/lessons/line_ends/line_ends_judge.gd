extends LessonJudge
## Judges what the lesson on line ends says.

const Facts := preload("res://tests/integration/lessons/line_ends/line_ends_facts.gd")

# Steps, counted from 0.
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
var _facts: Facts


func problem(seen: SeenLesson) -> String:
	_facts = Facts.new()
	_facts.take(seen.state)
	_step = seen.step
	return first_of(
		[
			false_claim([seen.sentence], _claims_of_sentences()),
			_problem_of_fields(seen.labels),
			_problem_of_lines(seen.lines),
			_problem_of_rows(seen.rows),
		]
	)


func _claims_of_sentences() -> Dictionary[String, bool]:
	var is_last := _step == _BOUNCE
	return {
		"As before: an infinite line with one good side. A ball from behind passes": _step == 0,
		"Turn n̂ to the ball's side: now both sides work. Still infinite": _step == 1,
		"With ends, 0 ≤ s ≤ 1 must hold: the ball's centre F is beside the line": _step == _SEGMENT,
		"Round caps: the ball touches an end when its centre is r away": _step == _CAP,
		"|d + t v| = r, squared, is a quadratic: a t² + b t + c = 0": _step == 4,
		"D < 0: the ball misses. D > 0: t₁ is the first touch; it counts within 0..1":
		_step == _ROOTS,
		"n̂ points from the end to the ball's centre. Reflect v on it":
		is_last and (_facts.hits_end() or _facts.is_close_call),
		"This ball bounces on the line, with the line's normal":
		is_last and (_facts.hits_capsule() and not _facts.hits_end() or _facts.is_close_call),
		"This ball touches neither the line nor an end: v stays":
		is_last and (not _facts.hits_capsule() or _facts.is_close_call),
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
		"n̂": _step == _BOUNCE and (_facts.hits_end() or _facts.is_close_call),
		"wrong": _facts.mistake != 0 and _step >= _CAP,
	}
	return "" if names.get(text, false) else "no such name is to be seen"


func _problem_of_words(field: int, text: String) -> String:
	var lines := text.split("\n")
	var words := lines[0].trim_prefix("✗ ").get_slice(", t = ", 0)
	if not words in _known_words():
		return "no claim is known"
	return "" if _facts.is_close_call else _problem_of_known_words(field, words, lines)


func _problem_of_known_words(field: int, words: String, lines: PackedStringArray) -> String:
	if words != _right_words(field):
		return "it is “%s”" % _right_words(field)
	if (
		lines[0].begins_with("✗ ")
		and (_facts.mistake != 23 or not _facts.differs(_facts.end_of_field(field)))
	):
		return "that line is not wrong here"
	var time := SeenLesson.number_behind(", t = ", lines[0])
	if is_nan(time) == _tells_time(field) or not is_nan(time) and not _is_time(field, time):
		return "the touch is at %s" % _facts.time_in(field)
	if lines.size() > 1:
		return _problem_of_wrong_ball(lines[1])
	return "" if _facts.mistake == 0 or field != 4 else "what the wrong ball does is missing"


func _known_words() -> PackedStringArray:
	return [
		"bounces on the line",
		"bounces in the air",
		"bounces on the end",
		"touches the end",
		"passes through from behind",
		"finds no hit, cuts through the end",
		"finds no hit, drives in lengthwise",
		"passes beside",
		"does not get there",
		"moves away",
		"moves along the line",
		"does not move",
	]


func _right_words(field: int) -> String:
	var has_sides := field in [1, 3, 4]
	if _facts.touches(field):
		return _words_of_touch(field)
	if not _facts.moves():
		return "does not move"
	var passes := _facts.touches(1) if field == 0 else _facts.touches(3)
	if not has_sides and not _facts.is_in_front() and passes:
		return "passes through from behind"
	if field >= 2 and _facts.hits_capsule():
		var is_along := _facts.approach == 0.0
		return "finds no hit, " + ("drives in lengthwise" if is_along else "cuts through the end")
	return _words_of_miss()


func _words_of_touch(field: int) -> String:
	if field == 4 and _facts.hits_end():
		return "bounces on the end" if _step == _BOUNCE else "touches the end"
	return "bounces on the line" if _facts.is_beside() else "bounces in the air"


func _words_of_miss() -> String:
	if _facts.approach == 0.0:
		return "moves along the line"
	if _facts.approach < 0.0:
		return "moves away"
	return "passes beside" if _facts.line_time <= 1.0 else "does not get there"


func _tells_time(field: int) -> bool:
	return _facts.touches(field) and not (field == 4 and _facts.hits_end() and _step < _ROOTS)


func _is_time(field: int, shown: float) -> bool:
	return SeenLesson.is_close(shown, _facts.time_in(field), 1e-7)


func _problem_of_wrong_ball(line: String) -> String:
	if _facts.can_be_either_end():
		return ""
	var wanted := _facts.wrong_time()
	match line:
		"the wrong ball does the same here":
			var is_alike := (
				not is_nan(wanted)
				and _facts.wrong_end().minus(_facts.end_of_field(4)).size() < 1e-5
			)
			return "" if is_alike else "the wrong ball does something else"
		"✗ the wrong ball passes":
			return "" if wanted == INF else "the wrong ball touches at %s" % wanted
	var shown := line.trim_prefix("✗ the wrong ball: t = ")
	if line.begins_with("✗ the wrong ball: t = ") and _facts.differs(_facts.wrong_end()):
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
	if _facts.is_close_call or _facts.can_be_either_end():
		return ""
	var difference := _facts.start.minus(_facts.end())
	var a := _facts.motion.dot(_facts.motion)
	var b := difference.dot(_facts.motion)
	var c := difference.dot(difference) - _facts.radius * _facts.radius
	# Near 0, rounding decides.
	var is_graze := absf(b * b - a * c) <= 1e-9 * (b * b + absf(a * c))
	var has_root := b * b > a * c
	var overlaps := _facts.distance <= _facts.radius if _step < _CAP else c <= 0.0
	var claims: Dictionary[String, bool] = {
		"along the line, no time of impact": _facts.approach == 0.0,
		"it moves away, no impact": _facts.approach < 0.0,
		"a = 0: the ball does not move": not _facts.moves(),
		"D < 0: no root": is_graze or not has_root,
		"the line is met first": _facts.hits_capsule() and not _facts.hits_end(),
		"moving away: none": b >= 0.0 or _facts.overlaps_and_leaves(),
		"overlap: t = 0": overlaps,
		"it only grazes: none": is_graze,
		"t₁ counts": is_graze or has_root and _facts.hits_end() and _facts.touch > 0.0,
		"t₁ > 1: none": is_graze or has_root and not _facts.hits_capsule() and b < 0.0 and c > 0.0,
	}
	for line in lines:
		for words in claims:
			if line.contains(words) and not claims[words]:
				return "it is not so: “%s”" % line
	return ""


func _problem_of_rows(rows: Array[PackedStringArray]) -> String:
	if rows and _step < _ROOTS:
		return "the times are not known yet"
	if _facts.is_close_call or _facts.can_be_either_end():
		return ""
	for row in rows:
		var wanted := NAN
		if row[0] == "t, infinite line":
			wanted = maxf(_facts.line_time, 0.0) if _facts.hits_line() else NAN
		elif row[0] == "t, end %s" % ("A" if _facts.end() == _facts.from else "B"):
			wanted = _facts.time_at_end()
		else:
			return "no claim is known for “%s”" % row[0]
		var shown := SeenLesson.first_number(row[1])
		var is_so := (
			SeenLesson.is_close(shown, wanted, 1e-7) if row[1] != "none" else is_nan(wanted)
		)
		if not is_so:
			return "it is %s: “%s”" % [wanted, "  ".join(row)]
		if not is_nan(wanted) and not SeenLesson.first_number(row[2]) < 1e-6:
			return "the error cannot be that: “%s”" % "  ".join(row)
	return ""
