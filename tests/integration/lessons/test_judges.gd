extends LabTest
## The judges of what lessons say find what is false, and let pass what is true.

const LineEndsCases := preload("res://tests/integration/lessons/line_ends/line_ends_judge_cases.gd")
const ReflectionCases := preload(
	"res://tests/integration/lessons/reflection/reflection_judge_cases.gd"
)

## By lesson: a state, and what is seen of it that is true. Then what is false, by the member of
## [SeenLesson] in which it stands.
const _CASES: Array[Dictionary] = [
	{
		id = &"dot_product",
		state = {a = [-5, 2], b = [8, -6], is_swapped = false, normalizes = true},
		verdict_sign = ["−", "+", "0", "✗"],
		verdict =
		[
			["Scalar projection −5.2", "negative: the angle is above 90°"],
			["Scalar projection −5.3", "negative: the angle is above 90°"],
			["Scalar projection −5.2", "positive: the angle is below 90°"],
			["Scalar projection −5.2", "zero: the angle is 90°"],
			["No projection", "b is zero: it has no direction"],
			["Scalar projection −5.2", "something new"],
		],
		sentence =
		[
			"What is left of a, the rest a − p, is perpendicular to b.",
			"What is left of b, the rest b − p, is perpendicular to a.",
			"b is zero: it has no direction, and no shadow falls on it.",
		],
		rows = [[["by atan2 and cos", "−5.2", "8e−16"]], [["by atan2 and cos", "−5", "8e−16"]]],
		labels = [["a − p"], ["b − p"]],
	},
	{
		id = &"dot_product",
		state = {a = [7, 1], b = [0, 0.5], is_swapped = false, normalizes = false},
		verdict_sign = ["✗", "+"],
		verdict =
		[
			["Scalar projection 0.5", "wrong: |b| = 0.5 times the right one"],
			["Scalar projection 0.5", "wrong: |b| = 2 times the right one"],
			["Scalar projection 1", "wrong: |b| = 0.5 times the right one"],
		],
		sentence =
		[
			"The rest a − p is not perpendicular to b: that is how a test finds the mistake.",
			"With these numbers the mistake changes nothing: a test needs others.",
		],
		rows =
		[[["a · b by the dot product", "0.5", "0.5"]], [["a · b by the dot product", "1", "0"]]],
	},
	{
		id = &"line_distance",
		state = {line = [200, 150, -200, -150], ball = [24, 93, 30], mistake = 0},
		verdict_sign = ["−", "+"],
		verdict =
		[
			["Behind the line: gap −90 px", "d · n̂ is negative on this side"],
			["Behind the line: gap −60 px", "d · n̂ is negative on this side"],
			["Too close: gap −90 px", "d · n̂ is negative on this side"],
			["Behind the line: gap −90 px", "on the good side, where n̂ points"],
			["Behind the line: gap −90 px", "but the gap to the segment is −90 px"],
		],
		sentence =
		[
			"The distance to the segment has no sign: it does not tell the sides apart.",
			"Here the distance to the segment is the same. Drag the ball past an end of the line.",
			"Beside an end the segment is farther away than the line without ends.",
			"Compare the distance of the mistake with the right one.",
		],
		rows = [[["from p", "−60", "0"]], [["from p", "60", "0"]]],
		labels = [["behind", "gap −90"], ["too close"], ["gap −60"], ["segment 90"]],
	},
]


func test_what_is_true_passes_and_what_is_false_is_told() -> void:
	for case: Dictionary in _CASES + ReflectionCases.CASES + LineEndsCases.CASES:
		for member: String in case:
			if member in ["id", "state"]:
				continue
			var choices: Array = case[member]
			assert_eq(_problem(case, {}), "", "%s is true" % case["id"])
			for wrong: Variant in choices.slice(1):
				assert_ne(_problem(case, {member: wrong}), "", "%s: %s" % [case["id"], wrong])


func test_a_lesson_without_a_judge_has_no_problem() -> void:
	assert_eq(LessonJudge.of(&"no_such_lesson").problem(SeenLesson.new()), "")


# With the true choice of each member, but for those in [param wrong].
func _problem(case: Dictionary, wrong: Dictionary) -> String:
	var seen := SeenLesson.new()
	seen.state = _state(case)
	for member: String in case:
		if not member in ["id", "state"]:
			var choices: Array = case[member]
			_put(seen, member, wrong.get(member, choices[0]))
	var id: StringName = case["id"]
	return LessonJudge.of(id).problem(seen)


func _state(case: Dictionary) -> Dictionary:
	var found := {a_from = PackedFloat64Array([0, 0]), b_from = PackedFloat64Array([0, 0])}
	var numbers: Dictionary = case["state"]
	for name_of_value: String in numbers:
		var value: Variant = numbers[name_of_value]
		found[name_of_value] = (
			type_convert(value, TYPE_PACKED_FLOAT64_ARRAY) if value is Array else value
		)
	return found


func _put(seen: SeenLesson, member: String, texts: Variant) -> void:
	if member == "rows":
		var rows: Array = texts
		for row: Array in rows:
			seen.rows.append(PackedStringArray(row))
	else:
		seen.set(member, type_convert(texts, typeof(seen.get(member))))
