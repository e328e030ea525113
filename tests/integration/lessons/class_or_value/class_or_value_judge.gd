extends LessonJudge
## Judges what the lesson on objects and values says in words; its code is run by [CodeReader].

## 0.1 added up, by the titles of the rows; worked out with another language's numbers of 64 bits
## and of 32. Then the exact sum.
const _SUMS: Dictionary[String, Array] = {
	"Vec2, 1000 times": [99.9999999999986, 100.0],
	"Vector2, 1000 times": [99.99904632568359, 100.0],
	"Vec2, 1000000 times": [100000.00000133288, 100000.0],
	"Vector2, 1000000 times": [100958.34375, 100000.0],
}
const _DIGITS_OF_SUM := 8
# Of errors two digits are shown.
const _TWO_DIGITS := 0.051

var _step: int
var _copies: bool


func problem(seen: SeenLesson) -> String:
	_step = seen.step
	_copies = seen.state["copies"]
	return first_of(
		[
			false_claim([seen.sentence], _claims_of_sentences()),
			false_claim(seen.labels, _claims_of_labels()),
			_problem_of_rows(seen.rows),
			"a card says “%s”" % seen.verdict[0] if seen.verdict else "",
			"there is no reason for “%s”" % seen.notice if seen.notice else "",
		]
	)


func _claims_of_sentences() -> Dictionary[String, bool]:
	return {
		"The same place, stored twice: in a Vec2, an object": _step == 0,
		"old = position gives the Vec2 a second name": _step == 1 and not _copies,
		"old = position.copy() makes a second Vec2": _step == 1 and _copies,
		"set_xy changes the one Vec2, so old changes, too. old_value stays":
		_step == 2 and not _copies,
		"set_xy changes only the first Vec2. old is a copy and stays": _step == 2 and _copies,
		"It keeps 64 bits of each number, Vector2 only 32": _step == 3,
	}


# A second name is there from the second step on: for the same Vec2, or for a copy.
func _claims_of_labels() -> Dictionary[String, bool]:
	var has_second := _step > 0
	return {
		"position": true,
		"value": true,
		"old": has_second,
		"old_value": has_second,
		"one name, one object": not has_second,
		"one name, one value": not has_second,
		"two names, one object": has_second and not _copies,
		"two names, two objects": has_second and _copies,
		"two names, two values": has_second,
	}


func _problem_of_rows(rows: Array[PackedStringArray]) -> String:
	if rows and _step < 3:
		return "nothing is added up yet: “%s”" % "  ".join(rows[0])
	for row in rows:
		if not _SUMS.has(row[0]):
			return "no sum is known for “%s”" % row[0]
		var sum: float = _SUMS[row[0]][0]
		var exact: float = _SUMS[row[0]][1]
		var unit := 10.0 ** (floorf(log(sum) / log(10.0)) + 1.0 - _DIGITS_OF_SUM)
		if absf(SeenLesson.first_number(row[1]) - sum) > unit / 2.0 * 1.0001:
			return "the sum is %s: “%s”" % [sum, "  ".join(row)]
		var error := absf(sum - exact)
		if absf(SeenLesson.first_number(row[2]) - error) > _TWO_DIGITS * error:
			return "the error is %s: “%s”" % [error, "  ".join(row)]
	return ""
