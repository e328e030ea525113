extends LessonJudge
## Judges what the lesson on bank shots says.

const _BOARD := preload("bank_shot_board.gd")

# What doubles may be off by, as a share of the largest number of the board.
const _ROUNDING := 1e-12

# Steps, counted from 0.
const _MOVED_WALL := 1
const _IMAGE := 2
const _BOUNCE := 3
const _ORDERS := 4
const _FIRE := 5

var _step: int
var _board: _BOARD


func problem(seen: SeenLesson) -> String:
	_step = seen.step
	_board = _BOARD.new(seen.state)
	return first_of(
		[
			false_claim([seen.sentence], _claims_of_sentences()),
			_problem_of_card(seen),
			false_label(seen.labels, _claims_of_labels(seen.labels)),
			_problem_of_depths(seen.labels),
			_problem_of_rows(seen.rows),
		]
	)


func _has_images() -> bool:
	return not _board.way.images.is_empty()


# Whether words about this outcome may be said.
func _can_be(found: _BOARD.Found) -> bool:
	return _board.is_close or _board.way.found == found


func _claims_of_reasons() -> Dictionary[String, bool]:
	var claims: Dictionary[String, bool] = {
		"a wall is in the way": _can_be(_BOARD.Found.BLOCKED), "A wall is in the way": false
	}
	for wall in _board.walls.size():
		var is_there: bool = _board.is_close or _board.way.at == wall
		var number := str(wall + 1)
		var texts: Dictionary[String, _BOARD.Found] = {
			"S and T are on different sides of wall ": _BOARD.Found.NONE,
			"the ball would be on the wrong side of wall ": _BOARD.Found.BEHIND,
			"the ball would not come to wall ": _BOARD.Found.NOT_REACHED,
			"it would bounce beside an end of wall ": _BOARD.Found.BESIDE,
		}
		for words in texts:
			claims[words + number] = is_there and _can_be(texts[words])
	return claims


func _claims_of_sentences() -> Dictionary[String, bool]:
	var is_one := _board.count == 1
	var can_hit := _can_be(_BOARD.Found.HIT)
	var claims: Dictionary[String, bool] = {
		"to come to T after exactly one bounce. Where to?": _step == 0 and is_one,
		"to come to T after exactly %d bounces. Where to?" % _board.count:
		_step == 0 and not is_one,
		"The centre turns back a radius before the wall.": _step == _MOVED_WALL,
		"Mirror T in the moved wall: T′ is as far":
		_step == _IMAGE and is_one and _board.bounciness == 1.0,
		"T′ is 1/C times as far behind": _step == _IMAGE and is_one and _board.bounciness < 1.0,
		(
			"Mirror T in the last wall first, then go backwards to the first one: %s is"
			% _image_name()
		):
		_step == _IMAGE and not is_one,
		"Shoot straight at T′. Where this line": _step == _BOUNCE and is_one and can_hit,
		"Shoot straight at %s. At each bounce" % _image_name():
		_step == _BOUNCE and not is_one and can_hit,
		"Orders of walls that lead to T: %d of %d." % [_hits(), _board.ways.size()]:
		_step == _ORDERS,
		"Play: the right ball flies": _step == _FIRE and can_hit and _board.mistake != 0,
		"Play: the shot flies": _step == _FIRE and can_hit,
	}
	if _board.is_close:
		claims["Orders of walls that lead to T: "] = _step == _ORDERS
	var reasons := _claims_of_reasons()
	for words in reasons:
		claims["Straight at %s? Not here: %s." % [_image_name(), words]] = (
			reasons[words] and _step == _BOUNCE
		)
		claims["There is nothing to fire: %s." % words] = reasons[words] and _step == _FIRE
		claims[words.trim_prefix(words[0]).insert(0, words[0].to_upper())] = (
			reasons[words] and _step > 0 and not _has_images()
		)
	return claims


func _image_name() -> String:
	return "T′" if _board.count == 1 else "T" + "₀₁₂₃"[_board.count]


func _hits() -> int:
	return _board.ways.values().filter(_BOARD.is_hit).size()


func _problem_of_card(seen: SeenLesson) -> String:
	if seen.verdict.is_empty():
		return ""
	if _step < _BOUNCE:
		return "it is not known yet: “%s”" % seen.verdict[0]
	var problem_of_words := false_claim(seen.verdict, _claims_of_card())
	if problem_of_words:
		return problem_of_words
	for line in seen.verdict:
		var problem_of_line := _problem_of_numbers(line)
		if problem_of_line:
			return problem_of_line
	return _problem_of_sign(seen)


func _problem_of_sign(seen: SeenLesson) -> String:
	if seen.verdict_sign == "✓" and not _can_be(_BOARD.Found.HIT):
		return "it does not hit: “%s”" % seen.verdict_sign
	var shows := seen.verdict[-1].begins_with("with the mistake")
	if seen.verdict_sign == "✗" and _BOARD.is_hit(_board.way) and not shows and not _board.is_close:
		return "it hits: “%s”" % seen.verdict_sign
	return ""


func _claims_of_card() -> Dictionary[String, bool]:
	var can_hit := _can_be(_BOARD.Found.HIT)
	var claims := _claims_of_reasons()
	var is_fired := _step == _FIRE
	var none := not _board.order and (_board.is_close or _hits() == 0)
	claims["at S or T the ball overlaps wall "] = _board.is_overlapped() or _board.is_close
	claims["px long, as the line to %s" % _image_name()] = (
		can_hit and not is_fired and _board.bounciness == 1.0
	)
	claims["as late as on a straight way of "] = (
		can_hit and not is_fired and _board.bounciness < 1.0
	)
	claims["no order of walls leads to T"] = none
	claims["miss "] = can_hit and is_fired
	claims["so far rounding alone may move it"] = can_hit and is_fired
	claims["with the mistake it misses by "] = _board.mistake != 0
	claims["the mistake changes nothing here"] = _board.mistake != 0
	claims["the mistake has nothing to aim at here"] = _board.mistake != 0 and not _has_images()
	return claims


func _problem_of_numbers(line: String) -> String:
	for words: String in ["the way is ", "as late as on a straight way of "]:
		var shown := SeenLesson.number_behind(words, line)
		var distance: float = _board.way.distance
		if not is_nan(shown) and not SeenLesson.is_close(shown, distance, _ROUNDING * _board.size):
			return "it is %s: “%s”" % [distance, line]
	var miss := SeenLesson.number_behind("miss ", line)
	var bound := SeenLesson.number_behind("ε × condition ", line)
	if line.begins_with("miss ") and not (miss >= 0.0 and miss <= 4.0 * bound):
		return "rounding moves it no farther: “%s”" % line
	return _problem_of_mistake(line)


func _problem_of_mistake(line: String) -> String:
	if not line.contains("mistake") or not _has_images() or _board.is_close:
		return ""
	var wrong := _board.wrong_direction()
	var right := _board.start.to(_board.images_of_way()[0])
	var off := wrong.plus(right, -1.0 / right.length()).length()
	if line == "the mistake changes nothing here":
		return "" if off < 2.0 * _BOARD.SLACK else "it aims %s off: “%s”" % [off, line]
	if off < 0.5 * _BOARD.SLACK:
		return "it aims right: “%s”" % line
	var miss := _board.flown_miss(wrong)
	var shown := SeenLesson.number_behind("it misses by ", line)
	if not is_nan(miss) and absf(shown - miss) > 0.0051 * miss + 1e-6 * _board.size:
		return "it is %s: “%s”" % [miss, line]
	return ""


func _claims_of_labels(labels: PackedStringArray) -> Dictionary[String, bool]:
	var is_one := _board.count == 1
	var claims: Dictionary[String, bool] = {
		"S": true, "T": true, "n̂": _step in [_MOVED_WALL, _IMAGE, _BOUNCE]
	}
	for wall in 4:
		claims[str(wall + 1)] = wall < _board.walls.size()
	for place in range(1, 4):
		var is_there := place <= _board.count and _has_images()
		claims["T" + "₀₁₂₃"[place]] = is_there and not is_one and _step in [_IMAGE, _BOUNCE]
		var has_bounce := is_there and _step in [_BOUNCE, _FIRE]
		has_bounce = has_bounce and (_board.is_close or place <= _board.way.bounces)
		claims["B" + "₀₁₂₃"[place]] = has_bounce and not is_one
		if place == 1:
			claims["B"] = has_bounce and is_one
			claims["T′"] = is_there and is_one and _step in [_IMAGE, _BOUNCE]
	for label in labels:
		if label.begins_with("d "):
			claims[label] = _step == _IMAGE and is_one and _has_images()
	return claims


func _problem_of_depths(labels: PackedStringArray) -> String:
	if not _has_images() or _board.count > 1:
		return ""
	var wall := int(str(_board.way.order)) - 1
	var height := _board.height(_board.target, wall, _board.way.sides[0]) - _board.radius
	return false_number(
		labels, {"d = ": height, "d / C = ": height / _board.bounciness}, _ROUNDING * _board.size
	)


func _problem_of_rows(rows: Array[PackedStringArray]) -> String:
	for row in rows:
		if row[1] == "none":
			if _BOARD.is_hit(_board.way) and not _board.is_close:
				return "there is a direction: “%s”" % "  ".join(row)
			continue
		var right := _BOARD.unit(_board.start.to(_board.images_of_way()[0]))
		if not _can_be(_BOARD.Found.HIT) or not is_pair(row[1], right.x, right.y, 1e-9):
			return "it is (%s, %s): “%s”" % [right.x, right.y, "  ".join(row)]
		if not SeenLesson.first_number(row[2]) <= _BOARD.SLACK:
			return "the error cannot be that: “%s”" % "  ".join(row)
	return ""
