extends LessonJudge
## Judges what the lesson on error and run time says, by the figures in its own table.

const _MICROSECONDS: Dictionary[String, float] = {"ns": 1e-3, "µs": 1.0, "ms": 1e3}
# The table has two digits of an error and three of a run time.
const _OFF := 0.012


func problem(seen: SeenLesson) -> String:
	var claims: Dictionary[String, bool] = {
		"Each mark is a method": seen.step == 0,
		"The dashed frontier joins": seen.step == 1,
		"its slope is the order p": seen.step == 2,
	}
	var found := false_claim([seen.sentence], claims)
	return found if found else _problem_of_rows(seen)


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
	return SeenLesson.first_number(row[2]) * _MICROSECONDS[row[2].get_slice(" ", 1)]
