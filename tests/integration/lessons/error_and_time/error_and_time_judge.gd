extends LessonJudge
## Judges what the lesson on error and run time says: by the figures in its own table, by those on
## the card beside a mark, and by what each case of the table of stability asks for.

const _MICROSECONDS: Dictionary[String, float] = {"ns": 1e-3, "µs": 1.0, "ms": 1e3}
# The table has two digits of an error and three of a run time.
const _OFF := 0.012
# The same where two of them are compared that were rounded apart.
const _ERROR_OFF := 0.051
const _HOLDS := "holds"
const _FAILS := "does not hold"
const _WAITS := "not tried yet"
const _LEFT_OUT := "not tried here"
const _TOO_LONG := "takes too long here"


func problem(seen: SeenLesson) -> String:
	var is_plotted: bool = not seen.state["stability"]
	var texts: PackedStringArray = [seen.progress]
	if is_plotted:
		texts.append(seen.sentence)
	return first_of(
		[
			false_claim(texts, _claims(seen.step, is_plotted)),
			_problem_of_count(seen.progress),
			_problem_of_rows(seen),
			_problem_of_card(seen) if is_plotted else _problem_of_table(seen),
			false_claim([seen.notice] if seen.notice else [], {}),
		]
	)


func _claims(step: int, is_plotted: bool) -> Dictionary[String, bool]:
	return {
		"Each mark is a method at one setting": step == 0,
		"The dashed frontier joins": step == 1,
		"to see its order p": step == 2,
		"Run ": is_plotted,
		"Stopped after ": is_plotted,
		"Done: the median of 5 runs of each method": is_plotted,
		"Only one method can be measured here": is_plotted,
		"Tried ": not is_plotted,
	}


# "Run 3 of 95: ..." cannot count beyond the end.
func _problem_of_count(progress: String) -> String:
	var numbers := progress.split(" of ")
	if numbers.size() < 2 or progress.begins_with("Done"):
		return ""
	var done := numbers[0].get_slice(" ", numbers[0].get_slice_count(" ") - 1).to_int()
	return "it is beyond the end: " + progress if done > numbers[1].to_int() else ""


# Name, error, run time, times the fastest one's: the fastest, the closest, the one pointed at.
func _problem_of_rows(seen: SeenLesson) -> String:
	if not seen.rows:
		return ""
	if seen.step == 0 or seen.state["stability"]:
		return "the table belongs to the second step"
	for row in seen.rows:
		if row[1] != "–":
			var found := _problem_of_row(row, seen.rows)
			if found:
				return found
	return ""


func _problem_of_row(row: PackedStringArray, rows: Array[PackedStringArray]) -> String:
	var text := " | ".join(row)
	var times := _time(row) / _time(rows[0])
	if absf(SeenLesson.first_number(row[3]) - times) > _OFF * times:
		return "that is %s times the fastest: %s" % [times, text]
	if times < 1.0 - _OFF:
		return "faster than the fastest: " + text
	if _error(row) < _error(rows[1]):
		return "closer than the closest: " + text
	return ""


func _error(row: PackedStringArray) -> float:
	return SeenLesson.first_number(row[1])


func _time(row: PackedStringArray) -> float:
	return _microseconds(row[2])


static func _microseconds(text: String) -> float:
	return SeenLesson.first_number(text) * _MICROSECONDS[text.get_slice(" ", 1)]


# Of the mark that is pointed at: "error 3 px, run time 20 µs", and more lines.
func _problem_of_card(seen: SeenLesson) -> String:
	var card := ""
	for label in seen.labels:
		card = label if label.contains("run time ") else card
	if not card:
		return "" if seen.lines.size() < 4 else "an order needs a mark"
	if card.contains("on the frontier") and seen.step == 0:
		return "the frontier belongs to the second step: " + card
	var run_time := card.get_slice("run time ", 1).get_slice("\n", 0)
	var error := INF
	if not card.contains("no answer"):
		error = SeenLesson.number_behind("error ", card)
	if seen.rows and (seen.rows[-1][2] != run_time or not _is_same(_error(seen.rows[-1]), error)):
		return "that is another mark: " + card
	# e₁ / e₂ = ... and t₂ / t₁ = ...
	if seen.step == 2 and seen.lines.size() == 4:
		var first := SeenLesson.number_behind(" = ", seen.lines[1])
		if absf(first - error) > _ERROR_OFF * error:
			return "e₁ is not that of %s: %s" % [card, seen.lines[1]]
		var behind := seen.lines[2].get_slice(" = ", 1)
		var time := SeenLesson.number_behind(" / ", behind)
		if absf(time - _microseconds(run_time)) > _OFF * time:
			return "t₁ is not that of %s: %s" % [card, seen.lines[2]]
	return ""


static func _is_same(one: float, other: float) -> bool:
	if is_inf(one) or is_inf(other):
		return one == other
	return absf(one - other) <= _ERROR_OFF * absf(other)


# Mark, title, criterion, figure; there is no figure before the case is tried.
func _problem_of_table(seen: SeenLesson) -> String:
	var rows: Array[PackedStringArray] = []
	for label in seen.labels:
		if label in [_HOLDS, _FAILS, _WAITS, _LEFT_OUT]:
			rows.append(PackedStringArray())
		if rows:
			rows[-1].append(label)
	var counts: Dictionary[String, int] = {_HOLDS: 0, _FAILS: 0, _WAITS: 0, _LEFT_OUT: 0}
	for row in rows:
		counts[row[0]] += 1
		var found := _problem_of_case(row)
		if found:
			return "%s: %s" % [found, " | ".join(row)]
	var tried := counts[_HOLDS] + counts[_FAILS]
	var all := tried + counts[_WAITS]
	var words := "Tried %d of %d: %d hold." % [tried, all, counts[_HOLDS]]
	if tried == all:
		words += " %d more take too long here." % counts[_LEFT_OUT]
	return "" if seen.progress == words else "it is “%s”: %s" % [words, seen.progress]


func _problem_of_case(row: PackedStringArray) -> String:
	if row[0] == _WAITS:
		return "" if row.size() == 3 else "it has not been tried"
	if row[0] == _LEFT_OUT:
		return "" if row.size() == 4 and row[3] == _TOO_LONG else "it is left out"
	if row.size() != 4 or row[3] == _TOO_LONG:
		return "it has a figure"
	var found := _problem_of_pi(row)
	if found or row[0] == _FAILS:
		return found
	found = _problem_of_bounces(row)
	return found if found else _problem_of_limit(row)


# A ratio of 100^k has the first k + 1 digits of pi.
func _problem_of_pi(row: PackedStringArray) -> String:
	var power := SeenLesson.number_behind("mass ratio 100^", row[1])
	if is_nan(power):
		return ""
	var impacts := floorf(PI * 10.0 ** power)
	var is_right := SeenLesson.number_behind("impacts: ", row[3]) == impacts
	return "" if is_right == (row[0] == _HOLDS) else "there must be %d impacts" % impacts


# Mirrored at its walls, a wedge of an angle is passed by a straight way through 180° of them.
func _problem_of_bounces(row: PackedStringArray) -> String:
	var angle := SeenLesson.number_behind("wedge of ", row[1])
	var wanted := SeenLesson.first_number(row[2])
	var shown := SeenLesson.number_behind("bounces: ", row[3])
	if not is_nan(angle):
		if absf(shown - 180.0 / angle) > 1.0:
			return "there must be about %d bounces" % (180.0 / angle)
		if shown != wanted:
			return "there must be as many bounces as asked for"
	return ""


# What is off is within what the case asks for; where it asks for several, the last is compared.
func _problem_of_limit(row: PackedStringArray) -> String:
	var limit := SeenLesson.first_number(row[2].substr(row[2].rfind("within ") + 7))
	if not row[2].contains("within ") or is_nan(limit):
		return ""
	var found := SeenLesson.first_number(row[3])
	if row[3].contains("off by "):
		found = SeenLesson.first_number(row[3].substr(row[3].rfind("off by ") + 7))
	elif not row[3].get_slice(" ", 1) in ["px", row[3]]:
		return ""
	return "it holds only within %s" % limit if found > limit else ""
