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
		# It falls by 140 px in 57.966 frames: v₁ = (40, √(2 · 300 · 140)).
		id = &"angled_lines",
		state =
		{
			balls = [[0, -50, 40, 0, 10]],
			lines = [[-200, 100, 200, 100]],
			gravity = [0, 300],
			bounciness = 1.0,
			method = "whole_frame",
			mistake = 0,
			selected = 0,
		},
		step = [1, 0, 2],
		sentence =
		[
			"The dots show its path. At the ring the ball touches a line: v₁ turns into v₂.",
			"The dots show its path in the next 1.5 s: no bounce.",
			"The ball is lost: it has left the board.",
			"At the ring something new.",
		],
		lines =
		[
			[
				"g = ( 0 , 300 )    C = 1",
				"P = ( 0 , -50 )   v = ( 40 , 0 )",
				"v₂ = v₁ − (1 + C) (v₁ · n) n",
				"v₂ = (40, 289.8) − 2 · (−289.8) (0, −1) = (40, −289.8)"
			],
			[
				"g = ( 0 , 200 )    C = 1",
				"P = ( 0 , -50 )   v = ( 40 , 0 )",
				"v₂ = v₁ − (1 + C) (v₁ · n) n",
				"v₂ = (40, 289.8) − 2 · (−289.8) (0, −1) = (40, −289.8)"
			],
			[
				"g = ( 0 , 300 )    C = 0.5",
				"P = ( 0 , -50 )   v = ( 40 , 0 )",
				"v₂ = v₁ − (1 + C) (v₁ · n) n",
				"v₂ = (40, 289.8) − 2 · (−289.8) (0, −1) = (40, −289.8)"
			],
			[
				"g = ( 0 , 300 )    C = 1",
				"P = ( 0 , 50 )   v = ( 40 , 0 )",
				"v₂ = v₁ − (1 + C) (v₁ · n) n",
				"v₂ = (40, 289.8) − 2 · (−289.8) (0, −1) = (40, −289.8)"
			],
			[
				"g = ( 0 , 300 )    C = 1",
				"P = ( 0 , -50 )   v = ( 0 , 40 )",
				"v₂ = v₁ − (1 + C) (v₁ · n) n",
				"v₂ = (40, 289.8) − 2 · (−289.8) (0, −1) = (40, −289.8)"
			],
			["g = ( 0 , 300 )    C = 1", "P = ( 0 , -50 )   v = ( 40 , 0 )"],
			[
				"g = ( 0 , 300 )    C = 1",
				"P = ( 0 , -50 )   v = ( 40 , 0 )",
				"v₂ = v₁ − (1 + C) (v₁ · n) n",
				"v₂ = (40, 270) − 2 · (−270) (0, −1) = (40, −270)"
			],
			[
				"g = ( 0 , 300 )    C = 1",
				"P = ( 0 , -50 )   v = ( 40 , 0 )",
				"v₂ = v₁ − (1 + C) (v₁ · n) n",
				"v₂ = (40, 289.8) − 1 · (−289.8) (0, −1) = (40, 0)"
			],
			[
				"g = ( 0 , 300 )    C = 1",
				"P = ( 0 , -50 )   v = ( 40 , 0 )",
				"v₂ = v₁ − (1 + C) (v₁ · n) n",
				"v₂ = (40, 289.8) − 2 · 289.8 (0, 1) = (40, −289.8)"
			],
		],
		labels =
		[
			[
				"A",
				"v",
				"g",
				"n",
				"t = 0.965",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n",
				"t = 0.95",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
			[
				"B",
				"v",
				"g",
				"n",
				"t = 0.965",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n",
				"t = 0.965",
				"something new",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n",
				"t = 0.965",
				"Frame 0, 0.00 s    bounces 0    lost 1\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n",
				"t = 0.965",
				"Frame 0, 0.00 s    bounces 1    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n",
				"t = 0.965",
				"Frame 0, 1.00 s    bounces 0    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n",
				"t = 0.965",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 0.9    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n",
				"t = 0.965",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1 ✗    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n",
				"t = 0.965",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1, mistake: 1    script 0.02 of 16.67 ms"
			],
		],
		notice = ["", "Something new."],
	},
	{
		id = &"angled_lines",
		state =
		{
			balls = [[0, -50, 40, 0, 10]],
			lines = [[-200, 140, 200, 140]],
			gravity = [0, 300],
			bounciness = 1.0,
			method = "event_world",
			mistake = 0,
			selected = 0,
		},
		step = [2, 1],
		sentence = ["The same minute, stepped in four ways.", "Drag on the board to draw a line."],
		lines = [["g = ( 0 , 300 )    C = 1", "P = ( 0 , -50 )   v = ( 40 , 0 )"]],
		labels =
		[
			[
				"A",
				"v",
				"g",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			]
		],
		rows =
		[
			[
				["position reset", "1.039 ✗", "0.039", "115 µs"],
				["rest dropped", "0.9124", "0.088", "68 µs"],
				["rest used", "1", "2.2e−15", "35 µs"],
				["event world", "1 lost", "–", "404 µs"]
			],
			[["position reset", "1.039", "0.039", "115 µs"]],
			[["position reset", "1.039 ✗", "0.088", "115 µs"]],
			[["position reset", "0.9124 ✗", "0.088", "115 µs"]],
			[["position reset", "1 lost", "1", "115 µs"]],
			[["rest used", "1", "0", "35 µs"]],
			[],
			[
				["position reset", "1", "0", "115 µs"],
				["rest dropped", "1", "0", "68 µs"],
				["rest used", "0.99", "0.01", "35 µs"]
			],
		],
	},
	{
		id = &"error_and_time",
		state = {problem = "ball_in_box", situation = 0, stability = false},
		step = [2, 1],
		sentence =
		[
			"Point at a mark on a line to see its order p. With p = 2, twice the time leaves 1/4.",
			"The dashed frontier joins the best: no other mark is both faster and closer.",
			"Something new.",
		],
		progress =
		[
			"Done: the median of 5 runs of each method, on this machine.",
			"Run 96 of 95: event world",
			"Tried 3 of 81: 3 hold.",
			"Something new.",
		],
		rows =
		[
			[
				["fastest", "1.4e−14", "2 µs", "1"],
				["closest", "0", "20 µs", "10"],
				["pointed at", "8.1", "0.9 ms", "450"]
			],
			[
				["fastest", "1.4e−14", "2 µs", "1"],
				["closest", "0", "20 µs", "10"],
				["pointed at", "8.1", "0.9 ms", "500"]
			],
			[
				["fastest", "1.4e−14", "2 µs", "1"],
				["closest", "0", "20 µs", "10"],
				["pointed at", "8.1", "0.8 ms", "400"]
			],
			[
				["fastest", "1.4e−14", "1 ms", "1"],
				["closest", "0", "20 µs", "0.02"],
				["pointed at", "8.1", "0.9 ms", "0.9"]
			],
			[
				["fastest", "1.4e−14", "2 µs", "1"],
				["closest", "9", "20 µs", "10"],
				["pointed at", "8.1", "0.9 ms", "450"]
			],
			[
				["fastest", "1.4e−14", "2 µs", "1"],
				["closest", "0", "20 µs", "10"],
				["pointed at", "2", "0.9 ms", "450"]
			],
		],
		labels =
		[
			["position reset\n60 Hz\nerror 8.1 px, run time 0.9 ms\n20 bounces"],
			["position reset\n60 Hz\nerror 2 px, run time 0.9 ms\n20 bounces"],
			["position reset\n60 Hz\nerror 8.1 px, run time 0.8 ms\n20 bounces"],
			["position reset\n60 Hz\nerror no answer, run time 0.9 ms\n20 bounces"],
			[],
		],
		lines =
		[
			["p", "e₁ / e₂ = 8.12 / 2 = 4.06", "t₂ / t₁ = 3600 / 900 = 4", "p = 1.01"],
			["p", "e₁ / e₂ = 2 / 8.12 = 0.2463", "t₂ / t₁ = 3600 / 900 = 4", "p = 1.01"],
			["p", "e₁ / e₂ = 8.12 / 2 = 4.06", "t₂ / t₁ = 900 / 3600 = 0.25", "p = 1.01"],
		],
		notice = ["", "Something new."],
	},
	{
		id = &"error_and_time",
		state = {problem = "ball_in_box", situation = 0, stability = true},
		progress =
		[
			"Tried 4 of 5: 3 hold.",
			"Tried 4 of 5: 4 hold.",
			"Tried 5 of 5: 3 hold.",
			"Tried 4 of 5: 3 hold. 1 more take too long here.",
			"Done: the median of 5 runs of each method, on this machine.",
		],
		labels =
		[
			[
				"holds",
				"Digits of pi, mass ratio 100^2",
				"the impacts spell pi, energy within 1e-12",
				"impacts: 314, energy off by 0",
				"holds",
				"A ball shot into a wedge of 60°",
				"3 bounces, speed within 1e-12",
				"bounces: 3, speed off by 2.2e−16",
				"holds",
				"Flat",
				"never more, within 1e-9 px",
				"0 px",
				"does not hold",
				"Narrow",
				"1 bounce",
				"bounces: 2",
				"not tried yet",
				"Deep",
				"no hop",
				"not tried here",
				"Long",
				"the same",
				"takes too long here"
			],
			[
				"holds",
				"Digits of pi, mass ratio 100^2",
				"the impacts spell pi, energy within 1e-12",
				"impacts: 313, energy off by 0",
				"holds",
				"A ball shot into a wedge of 60°",
				"3 bounces, speed within 1e-12",
				"bounces: 3, speed off by 2.2e−16",
				"holds",
				"Flat",
				"never more, within 1e-9 px",
				"0 px",
				"does not hold",
				"Narrow",
				"1 bounce",
				"bounces: 2",
				"not tried yet",
				"Deep",
				"no hop",
				"not tried here",
				"Long",
				"the same",
				"takes too long here"
			],
			[
				"holds",
				"Digits of pi, mass ratio 100^2",
				"the impacts spell pi, energy within 1e-12",
				"impacts: 314, energy off by 2e−12",
				"holds",
				"A ball shot into a wedge of 60°",
				"3 bounces, speed within 1e-12",
				"bounces: 3, speed off by 2.2e−16",
				"holds",
				"Flat",
				"never more, within 1e-9 px",
				"0 px",
				"does not hold",
				"Narrow",
				"1 bounce",
				"bounces: 2",
				"not tried yet",
				"Deep",
				"no hop",
				"not tried here",
				"Long",
				"the same",
				"takes too long here"
			],
			[
				"does not hold",
				"Digits of pi, mass ratio 100^2",
				"the impacts spell pi, energy within 1e-12",
				"impacts: 314, energy off by 0",
				"holds",
				"A ball shot into a wedge of 60°",
				"3 bounces, speed within 1e-12",
				"bounces: 3, speed off by 2.2e−16",
				"holds",
				"Flat",
				"never more, within 1e-9 px",
				"0 px",
				"does not hold",
				"Narrow",
				"1 bounce",
				"bounces: 2",
				"not tried yet",
				"Deep",
				"no hop",
				"not tried here",
				"Long",
				"the same",
				"takes too long here"
			],
			[
				"holds",
				"Digits of pi, mass ratio 100^2",
				"the impacts spell pi, energy within 1e-12",
				"impacts: 314, energy off by 0",
				"holds",
				"A ball shot into a wedge of 60°",
				"3 bounces, speed within 1e-12",
				"bounces: 5, speed off by 0",
				"holds",
				"Flat",
				"never more, within 1e-9 px",
				"0 px",
				"does not hold",
				"Narrow",
				"1 bounce",
				"bounces: 2",
				"not tried yet",
				"Deep",
				"no hop",
				"not tried here",
				"Long",
				"the same",
				"takes too long here"
			],
			[
				"holds",
				"Digits of pi, mass ratio 100^2",
				"the impacts spell pi, energy within 1e-12",
				"impacts: 314, energy off by 0",
				"holds",
				"A ball shot into a wedge of 60°",
				"3 bounces, speed within 1e-12",
				"bounces: 2, speed off by 0",
				"holds",
				"Flat",
				"never more, within 1e-9 px",
				"0 px",
				"does not hold",
				"Narrow",
				"1 bounce",
				"bounces: 2",
				"not tried yet",
				"Deep",
				"no hop",
				"not tried here",
				"Long",
				"the same",
				"takes too long here"
			],
			[
				"holds",
				"Digits of pi, mass ratio 100^2",
				"the impacts spell pi, energy within 1e-12",
				"impacts: 314, energy off by 0",
				"holds",
				"A ball shot into a wedge of 60°",
				"3 bounces, speed within 1e-12",
				"bounces: 3, speed off by 2.2e−16",
				"holds",
				"Flat",
				"never more, within 1e-9 px",
				"2.2e−9 px",
				"does not hold",
				"Narrow",
				"1 bounce",
				"bounces: 2",
				"not tried yet",
				"Deep",
				"no hop",
				"not tried here",
				"Long",
				"the same",
				"takes too long here"
			],
			[
				"holds",
				"Digits of pi, mass ratio 100^2",
				"the impacts spell pi, energy within 1e-12",
				"impacts: 314, energy off by 0",
				"holds",
				"A ball shot into a wedge of 60°",
				"3 bounces, speed within 1e-12",
				"bounces: 3, speed off by 2.2e−16",
				"not tried yet",
				"Flat",
				"never more, within 1e-9 px",
				"0 px",
				"does not hold",
				"Narrow",
				"1 bounce",
				"bounces: 2",
				"not tried yet",
				"Deep",
				"no hop",
				"not tried here",
				"Long",
				"the same",
				"takes too long here"
			],
			[
				"holds",
				"Digits of pi, mass ratio 100^2",
				"the impacts spell pi, energy within 1e-12",
				"impacts: 314, energy off by 0",
				"holds",
				"A ball shot into a wedge of 60°",
				"3 bounces, speed within 1e-12",
				"bounces: 3, speed off by 2.2e−16",
				"holds",
				"Flat",
				"never more, within 1e-9 px",
				"0 px",
				"does not hold",
				"Narrow",
				"1 bounce",
				"bounces: 2",
				"not tried yet",
				"Deep",
				"no hop",
				"not tried yet",
				"Long",
				"the same",
				"takes too long here"
			],
			[
				"holds",
				"Digits of pi, mass ratio 100^2",
				"the impacts spell pi, energy within 1e-12",
				"impacts: 314, energy off by 0",
				"holds",
				"A ball shot into a wedge of 60°",
				"3 bounces, speed within 1e-12",
				"bounces: 3, speed off by 2.2e−16",
				"holds",
				"Flat",
				"never more, within 1e-9 px",
				"0 px",
				"does not hold",
				"Narrow",
				"1 bounce",
				"bounces: 2",
				"holds",
				"Deep",
				"no hop",
				"not tried here",
				"Long",
				"the same",
				"takes too long here"
			],
			[
				"holds",
				"Digits of pi, mass ratio 100^2",
				"the impacts spell pi, energy within 1e-12",
				"impacts: 314, energy off by 0",
				"holds",
				"A ball shot into a wedge of 60°",
				"3 bounces, speed within 1e-12",
				"bounces: 3, speed off by 2.2e−16",
				"holds",
				"Flat",
				"never more, within 1e-9 px",
				"0 px",
				"holds",
				"Narrow",
				"1 bounce",
				"bounces: 2",
				"not tried yet",
				"Deep",
				"no hop",
				"not tried here",
				"Long",
				"the same",
				"takes too long here"
			],
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
		found[name_of_value] = _as_in_a_link(value)
	return found


# Numbers in a list; lists of numbers in a list.
func _as_in_a_link(value: Variant) -> Variant:
	if not value is Array:
		return value
	var parts: Array = value
	if not parts[0] is Array:
		return type_convert(parts, TYPE_PACKED_FLOAT64_ARRAY)
	var lists: Array[PackedFloat64Array] = []
	for part: Array in parts:
		lists.append(PackedFloat64Array(part))
	return lists


func _put(seen: SeenLesson, member: String, texts: Variant) -> void:
	if member == "rows":
		var rows: Array = texts
		for row: Array in rows:
			seen.rows.append(PackedStringArray(row))
	else:
		seen.set(member, type_convert(texts, typeof(seen.get(member))))
