extends LabTest
## The judges of what lessons say find what is false, and let pass what is true.

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
	{
		id = &"reflection",
		state =
		{
			velocity = [3, 4],
			along = [-7, 0],
			bounciness = 0.5,
			has_unit_normal = true,
			normal_length = 2.0,
			mistake = 0,
		},
		step = [4, 3, 2, 1],
		verdict_sign = ["≠", "=", "0", "✗"],
		verdict =
		[
			["in 36.87°, out 56.31° to the normal", "keeps 52 % of its energy"],
			["in 36.87°, out 36.87° to the normal", "keeps 52 % of its energy"],
			["in 53.13°, out 56.31° to the normal", "keeps 52 % of its energy"],
			["in 36.87°, out 56.31° to the normal", "keeps 50 % of its energy"],
			["in 36.87° to the normal, and it stops", "keeps 52 % of its energy"],
			["it moves along the line", "keeps 52 % of its energy"],
			["in 36.87°, out 56.31° to the normal", "the mistake says: (3, −28)"],
			["in 36.87°, out 56.31° to the normal", "something new"],
		],
		sentence =
		[
			"Subtract it (1 + C) times. C is the bounciness, the coefficient of restitution.",
			"Subtract it twice: the law of reflection. Both angles are equal.",
			"v · n = 0: no part of v goes into the line. v stays as it is.",
			"n does not have length 1. reflect refuses it, and v stays as it is.",
			"v = 0: the ball does not move.",
		],
		rows =
		[
			[["reflect(n, C)", "(3, −2)", "0"]],
			[["reflect(n, C)", "(3, −4)", "0"]],
			[["reflect(n, C)", "(3, −2)", "0.1"]],
			[["reflect(n, C)", "refused", ""]],
		],
		labels =
		[
			[
				"v in",
				"v",
				"slide",
				"−C (v·n) n",
				"v out",
				"Vector2",
				"is our",
				"value",
				"error",
				"bounce(n)",
				"reflect(n, 1)",
				"(3, −4)",
				"0",
				"slide(n)",
				"reflect(n, 0)",
				"(3, 0)",
				"0",
				"reflect(n)",
				"−reflect(n, 1)",
				"(−3, 4)",
				"0"
			],
			[
				"v in",
				"Vector2",
				"is our",
				"value",
				"error",
				"bounce(n)",
				"reflect(n, 1)",
				"(3, −4)",
				"0",
				"slide(n)",
				"reflect(n, 0)",
				"(3, 0)",
				"0",
				"reflect(n)",
				"−reflect(n, 1)",
				"(3, −4)",
				"0"
			],
			[
				"v in",
				"Vector2",
				"is our",
				"value",
				"error",
				"bounce(n)",
				"reflect(n, 1)",
				"(3, −4)",
				"0",
				"slide(n)",
				"reflect(n, 1)",
				"(3, 0)",
				"0",
				"reflect(n)",
				"−reflect(n, 1)",
				"(−3, 4)",
				"0"
			],
			[
				"v in",
				"Vector2",
				"is our",
				"value",
				"error",
				"bounce(n)",
				"reflect(n, 1)",
				"(3, −4)",
				"0",
				"slide(n)",
				"reflect(n, 0)",
				"(3, 0)",
				"0.1",
				"reflect(n)",
				"−reflect(n, 1)",
				"(−3, 4)",
				"0"
			],
			[
				"v in",
				"(v·n) n",
				"Vector2",
				"is our",
				"value",
				"error",
				"bounce(n)",
				"reflect(n, 1)",
				"(3, −4)",
				"0",
				"slide(n)",
				"reflect(n, 0)",
				"(3, 0)",
				"0",
				"reflect(n)",
				"−reflect(n, 1)",
				"(−3, 4)",
				"0"
			],
			[
				"v in",
				"wrong",
				"Vector2",
				"is our",
				"value",
				"error",
				"bounce(n)",
				"reflect(n, 1)",
				"(3, −4)",
				"0",
				"slide(n)",
				"reflect(n, 0)",
				"(3, 0)",
				"0",
				"reflect(n)",
				"−reflect(n, 1)",
				"(−3, 4)",
				"0"
			],
			[
				"v in",
				"v new",
				"Vector2",
				"is our",
				"value",
				"error",
				"bounce(n)",
				"reflect(n, 1)",
				"(3, −4)",
				"0",
				"slide(n)",
				"reflect(n, 0)",
				"(3, 0)",
				"0",
				"reflect(n)",
				"−reflect(n, 1)",
				"(−3, 4)",
				"0"
			],
			["v in"],
		],
	},
	{
		id = &"reflection",
		state =
		{
			velocity = [4, 0],
			along = [-7, 0],
			bounciness = 0.5,
			has_unit_normal = true,
			normal_length = 2.0,
			mistake = 11,
		},
		step = [2],
		verdict_sign = ["=", "✗", "≠"],
		verdict =
		[
			["it moves along the line", "the mistake changes nothing here"],
			["it moves along the line", "the mistake says: (4, 0)"],
			["in 90°, out 45° to the normal", "the mistake changes nothing here"],
		],
		sentence =
		[
			"v · n = 0: no part of v goes into the line. v stays as it is.",
			"Subtract that part once: nothing goes into the line. The ball slides.",
			"Subtract that part once: nothing is left of v. The ball stops.",
		],
		labels = [["v in", "slide"], ["−(v·n) n"], ["wrong"]],
	},
	{
		id = &"reflection",
		state =
		{
			velocity = [3, 4],
			along = [-7, 0],
			bounciness = 1.0,
			has_unit_normal = false,
			normal_length = 2.0,
			mistake = 0,
		},
		step = [2],
		sentence =
		[
			"n does not have length 1. reflect refuses it, and v stays as it is.",
			"Subtract that part once: nothing goes into the line. The ball slides.",
		],
		rows = [[["reflect(n, C)", "refused", ""]], [["reflect(n, C)", "(3, −4)", "0"]]],
		labels = [["v in", "n"], ["v in", "v"]],
		notice =
		[
			"Vec2.reflect: the normal must have length 1, but has length 2.0.",
			"Vec2.reflect: the normal must have length 1, but has length 3.0.",
			"",
		],
	},
	{
		id = &"line_ends",
		state = {shot = [-6, -8, 6, 16, 5], line = [1, 3, 13, 8], time = 1.0, mistake = 20},
		step = [6, 4, 3, 2],
		sentence =
		[
			"n points from the end to the ball's centre. Reflect v on it as before.",
			"This ball bounces on the line, with the line's normal, as before.",
			"This ball touches neither the line nor an end: v stays as it is.",
			"|d + t v| = r, squared, is a quadratic: a t² + b t + c = 0.",
			"Something new.",
		],
		lines =
		[
			["t₂ = 0.9932     t₁ counts"],
			["t₂ = 0.9932     t₁ > 1: none"],
			["t₂ = 0.9932     the line is met first"],
			["D < 0: no root. This end is not touched."],
			["t = (7.462 − 5) / 12.46 = 0.1975     overlap: t = 0"],
			["−v · n = 1: it moves away, no impact"],
		],
		rows =
		[
			[["t, infinite line", "0.1975", "0"], ["t, end A", "0.5", "0"]],
			[["t, infinite line", "0.2975", "0"]],
			[["t, infinite line", "none", "–"]],
			[["t, end A", "0.9932", "0"]],
			[["t, end B", "0.5", "0"]],
			[["t, end A", "0.5", "0.1"]],
		],
		labels =
		[
			[
				"Infinite, one side",
				"passes through from behind",
				"Infinite, two sides",
				"bounces in the air, t = 0.1975",
				"Segment, two sides",
				"finds no hit, cuts through the end",
				"Segment, two sides, round caps",
				"v",
				"A",
				"n",
				"t₁",
				"wrong",
				"bounces on the end, t = 0.5\n✗ the wrong ball: t = −0.5"
			],
			["Infinite, one side", "bounces in the air, t = 0.1975"],
			["Infinite, two sides", "bounces in the air, t = 0.2975"],
			["Infinite, two sides", "bounces in the air"],
			["Infinite, two sides", "✗ bounces in the air, t = 0.1975"],
			["Segment, two sides", "passes beside"],
			["Segment, two sides", "something new"],
			[
				"Segment, two sides, round caps",
				"v",
				"A",
				"n",
				"t₁",
				"wrong",
				"touches the end, t = 0.5\n✗ the wrong ball: t = −0.5"
			],
			[
				"Segment, two sides, round caps",
				"v",
				"A",
				"n",
				"t₁",
				"wrong",
				"bounces on the end, t = 0.5"
			],
			[
				"Segment, two sides, round caps",
				"v",
				"A",
				"n",
				"t₁",
				"wrong",
				"bounces on the end, t = 0.5\n✗ the wrong ball: t = 0.5"
			],
			[
				"Segment, two sides, round caps",
				"v",
				"A",
				"n",
				"t₁",
				"wrong",
				"bounces on the end, t = 0.5\n✗ the wrong ball passes"
			],
			[
				"Segment, two sides, round caps",
				"v",
				"A",
				"n",
				"t₁",
				"wrong",
				"bounces on the end, t = 0.5\nthe wrong ball does the same here"
			],
			["d"],
			["t₂"],
		],
	},
]


func test_what_is_true_passes_and_what_is_false_is_told() -> void:
	for case: Dictionary in _CASES:
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
