extends LabTest
## The judges of what lessons say find what is false, and let pass what is true.

## Where a case names no step.
const _LAST_STEP := 4
## By lesson: a state, and what is seen of it that is true at a step. Then what is false, by the
## member of [SeenLesson] in which it stands.
const _CASES: Array[Dictionary] = [
	{
		id = &"dot_product",
		state = {a = [-5, 2], b = [8, -6], is_swapped = false, normalizes = true},
		step = [4],
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
			"Nothing is left of a here: the rest a − p is zero.",
		],
		labels = [["a", "b\u0302", "p", "a − p"], ["b − p"], ["â"], ["α = "], ["q"]],
		rows = [[], [["by atan2 and cos", "−5.2", "8e−16"]]],
		notice = ["", "something"],
	},
	{
		id = &"dot_product",
		state = {a = [-5, 2], b = [8, -6], is_swapped = false, normalizes = true},
		step = [6, 1],
		verdict_sign = ["−"],
		verdict = [["Scalar projection −5.2", "negative: the angle is above 90°"], []],
		sentence =
		[
			"The primitive way: find both angles by atan2, then take the cosine of their difference.",
			"The dot product holds the angle φ: it is |a| |b| cos φ. For unit vectors that is cos φ.",
		],
		rows = [[["by atan2 and cos", "−5.2", "8e−16"]], [["by atan2 and cos", "−5", "8e−16"]]],
		labels = [["α = ", "β = ", "φ = "], ["a − p"]],
	},
	{
		id = &"dot_product",
		state = {a = [7, 1], b = [0, 0], is_swapped = false, normalizes = true},
		step = [6],
		verdict_sign = ["0", "+"],
		verdict =
		[
			["No projection", "b is zero: it has no direction"],
			["Scalar projection 0", "zero: the angle is 90°"],
		],
		sentence = ["b is zero: it has no direction, and no shadow falls on it."],
		rows = [[], [["by atan2 and cos", "0", "0"]]],
		labels = [["a", "b"], ["p"], ["α = "]],
	},
	{
		id = &"dot_product",
		state = {a = [7, 1], b = [1.00001, 0], is_swapped = false, normalizes = false},
		step = [3],
		verdict_sign = ["✗"],
		verdict =
		[
			["Scalar projection 7", "wrong: |b| = 1.00001 times the right one"],
			["Scalar projection 7", "wrong: |b| = 1 times the right one"],
		],
		sentence = ["That times b is |b|² times the shadow: the length comes in twice."],
	},
	{
		id = &"dot_product",
		state = {a = [7, 1], b = [0, 0.5], is_swapped = false, normalizes = false},
		step = [4],
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
	},
	{
		id = &"normals",
		state = {line = [0, 0, 3, -4], times = 2.0, is_y_up = false, mistake = 0},
		step = [4, 3, 0],
		verdict_sign = ["+", "0", "✗", "="],
		verdict =
		[
			["+90° turns clockwise", "y points down"],
			["+90° turns counter-clockwise", "y points down"],
			["+90° turns clockwise", "y points up"],
			["The zero vector", "has no normal: it is 0."],
			["+90° turns clockwise", "(y, −x): −90°, the other side"],
			["+90° turns clockwise", "something new"],
			[],
		],
		sentence =
		[
			"One pixel is too short to see, so draw a multiple of n̂.",
			"A line has a direction: v = end − start. Drag its ends, or all of it.",
			"v is zero: there is no n̂ to draw.",
			"Mistake 9 is on: n, and what two wrong formulas make of v.",
		],
		labels = [["v", "n", "−n", "n̂", "2 n̂"], ["3 n̂"], ["✗ (0, 0)"], ["✗ (y, x)"], ["q"]],
		rows =
		[
			[["by the angle", "(0.8, 0.6)", "1e−16"]],
			[["by the angle", "(0.6, 0.8)", "1e−16"]],
			[["by the angle", "(0.8, 0.6)", "1"]],
			[],
		],
		notice = ["", "something"],
	},
	{
		id = &"normals",
		state = {line = [0, 0, 0.3, 0.4], times = 2.0, is_y_up = false, mistake = 7},
		step = [0],
		verdict_sign = ["✗", "="],
		verdict =
		[
			["wrong: (0, 0)", "right: (−0.8, 0.6)"],
			["wrong: (0, 0)", "right: (0.8, −0.6)"],
			["Here the mistake", "does not show"],
		],
		sentence =
		[
			"Mistake 7 is on: int() cuts the length to 0.",
			"Mistake 7 is on. It shows only if v is shorter than 1, but not zero.",
			"A line has a direction: v = end − start. Drag its ends, or all of it.",
		],
		labels = [["v", "n", "n̂", "✗ (0, 0)"], ["−n"], ["✗ (y, x)"]],
	},
	{
		id = &"projection_proof",
		state = {a = [7, 1], b = [8, -6]},
		step = [6],
		verdict_sign = ["=", "≈", "0"],
		verdict =
		[
			[
				"a′.x = 5.000000000000001",
				"a · b̂ = 5.000000000000001",
				"equal to the last bit",
			],
			["a′.x = 5.000000000000001", "a · b̂ = 5", "equal to the last bit"],
			["a′.x = 5.1", "a · b̂ = 5.1", "equal to the last bit"],
			["a′.x = 5", "a · b̂ = 5", "Both mean 0: only rounding is left"],
			["a′.x = 5", "a · b̂ = 5", "something new"],
			["b is zero: no direction, no shadow"],
		],
		sentence =
		[
			"Both sides, computed in two ways: do they agree to the last bit?",
			"b is zero: it has no direction, so there is no β. Drag b away.",
			"Both turn by −β until b lies on the x axis.",
			"The triangle of b holds cos β and sin β: its sides divided by |b|.",
		],
		rows =
		[
			[["x of a′", "5", "8.9e−16"], ["a · b̂", "5", "8.9e−16"]],
			[["x of a′", "5", "8.9e−16"], ["a · b̂", "5", "0"]],
			[["x of a′", "5", "0.1"], ["a · b̂", "5", "0.1"]],
			[["x of a′", "7", "0"], ["a · b̂", "5", "0"]],
			[["y of a′", "5", "0"], ["a · b̂", "5", "0"]],
		],
		lines =
		[
			["a′ = (5, 5)     b′ = (10, 0)"],
			["a′ = (5, −5)     b′ = (10, 0)"],
			["on the way: (7, 1)     (10, 0)"],
			["on the way: (8, 1)     (8, −6)"],
		],
		labels = [["a", "b", "a′", "b′", "p"], ["ax"], ["bx"], ["β = "], ["q"]],
		notice = ["", "something"],
	},
	{
		id = &"projection_proof",
		state = {a = [7, 1], b = [0, 0]},
		step = [3],
		verdict_sign = ["0", "="],
		verdict = [["b is zero: no direction, no shadow"], ["a′.x = 0"], []],
		sentence =
		[
			"b is zero: it has no direction, so there is no β. Drag b away.",
			"Turning by −β gives a′.x. Use cos(−β) = cos β and sin(−β) = −sin β.",
		],
		labels = [["a", "b"], ["p"], ["a′"], ["ax"]],
	},
	{
		id = &"projection_proof",
		state = {a = [5, 1], b = [3, 4]},
		step = [6],
		verdict_sign = ["≈", "="],
		verdict =
		[
			[
				"a′.x = 3.8",
				"a · b̂ = 3.8000000000000003",
				"1 unit in the last place apart",
			],
			["a′.x = 3.8", "a · b̂ = 3.8000000000000003", "equal to the last bit"],
			[
				"a′.x = 3.8",
				"a · b̂ = 3.8000000000000003",
				"5 units in the last place apart",
			],
		],
		sentence = ["Both sides, computed in two ways: do they agree to the last bit?"],
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
			"Past an end, the segment is farther away than the line without ends.",
			"Compare the distance of the mistake with the right one.",
			"Something new.",
		],
		rows = [[["from p", "−60", "0"]], [["from p", "60", "0"]]],
		labels =
		[
			["behind", "gap −90"],
			["too close"],
			["touching"],
			["gap −60"],
			["segment 90"],
			["wrong 60"],
			["something new"],
		],
	},
	{
		id = &"line_distance",
		state = {line = [200, 150, -200, -150], ball = [78, 21, 30], mistake = 9},
		step = 3,
		verdict_sign = ["+", "−"],
		verdict =
		[
			["It just touches the line: gap 0 px", "the mistake says: gap −60 px"],
			["Behind the line: gap 0 px", "the mistake says: gap −60 px"],
			["It just touches the line: gap 0 px", "the mistake says: gap 0 px"],
		],
		sentence =
		[
			"Compare the distance of the mistake with the right one.",
			"Subtract the radius, and you have the gap between ball and line.",
		],
		lines = [["wrong: d · (−n̂) = −30"]],
		labels = [["right 30", "wrong −30", "as if here"], ["gap 0"], ["wrong 30"]],
	},
	{
		id = &"line_distance",
		state = {line = [200, 150, -200, -150], ball = [78, 21, 30], mistake = 9},
		step = 1,
		sentence =
		[
			"The unit normal n̂ is perpendicular to the line and points to its good side.",
			"Compare the distance of the mistake with the right one.",
		],
		verdict = [[], ["Free: gap 70 px"]],
		rows = [[], [["from p", "30", "0"]]],
		lines = [["d = c − p"], ["wrong: d · (−n̂) = −30"]],
		labels = [["line", "d"], ["touching"], ["r"], ["right 30"]],
	},
	{
		id = &"point_of_impact",
		state = _FRAME,
		step = 4,
		verdict_sign = ["!", "×"],
		verdict =
		[
			["t = 0.5, within 0..1", "it touches in this frame"],
			["t = 0.6, within 0..1", "it touches in this frame"],
			["t = 0.5, above 1", "it touches in this frame"],
			["t = 0.5, within 0..1", "no contact in this frame yet"],
			["t = 0.5, within 0..1", "too close already: contact at once"],
			["b is below 0", "it moves away: no impact"],
			["b = 0: no t", "it moves along the line"],
			["t = 0.5, within 0..1", "the mistake changes nothing here"],
			["something new"],
		],
		sentence =
		[
			"POI = old + t v is on the path. The reset is not.",
			"POI = old + t v is on the path.",
			"POI = old + t v. Here the reset leads to the same place.",
			"The contact is at the start of the frame: t counts as 0.",
			"No impact in this frame: the ball may go to new.",
			"Compare the t of the mistake with the right one.",
			"t = a / b is the share of the frame until the contact. It counts only within 0..1.",
		],
		rows =
		[
			[["POI", "(6, −8)", "1e−14 px"], ["reset", "(30, 10)", "30 px"]],
			[["POI", "(6, −9)", "1e−14 px"]],
			[["POI", "(6, −8)", "1 px"]],
			[["reset", "(30, 10)", "24 px"]],
			[["reset", "(6, −8)", "30 px"]],
			[["POI", "none", ""]],
			[["reset", "none", ""]],
		],
		labels =
		[
			["old", "new", "v", "t = 0.25", "a 40", "b 80", "reset", "POI", "30 px off"],
			["old = POI"],
			["t = 0.5"],
			["a 50"],
			["b −80"],
			["24 px off"],
			["wrong"],
			["something new"],
		],
	},
	{
		id = &"point_of_impact",
		state =
		{old = [3, -4], new = [3, -29], line = _LINE, radius = 10, moment = 0, mistake = 17},
		step = 3,
		verdict_sign = ["×", "!"],
		verdict =
		[
			[
				"b is below 0",
				"it is on its way out: no impact",
				"the mistake takes t = 0.25 all the same"
			],
			["b is below 0", "it moves away: no impact"],
			["t = 0.25, within 0..1"],
			["the mistake takes t = 0.5 all the same"],
			["the mistake changes nothing here"],
			["the mistake divides by 0: the ball is lost"],
			["the mistake says t = 0.25"],
		],
		sentence =
		[
			"Compare the t of the mistake with the right one.",
			"b is below 0: the ball moves away, and t does not count.",
		],
		rows = [[], [["POI", "none", ""]]],
		labels = [["a −5", "b −20", "wrong"], ["reset"], ["POI"]],
	},
	{
		id = &"point_of_impact",
		state = {old = [0, 0], new = [40, 30], line = _LINE, radius = 10, moment = 0, mistake = 0},
		step = 4,
		verdict_sign = ["×", "!"],
		verdict =
		[
			["b = 0: no t", "it moves along the line"],
			["v = 0: no t", "it does not move"],
			["b is below 0"],
		],
		sentence =
		[
			"No impact in this frame, but new is too close: only the reset moves it out.",
			"No impact in this frame, but new is behind the line: only the reset moves it out.",
			"No impact in this frame: the ball may go to new.",
		],
		rows = [[["POI", "none", ""], ["reset", "(46, 22)", ""]], [["POI", "(0, 0)", ""]]],
	},
	{
		id = &"point_of_impact",
		state = {old = [6, 60], new = [6, 90], line = _LINE, radius = 10, moment = 0, mistake = 16},
		step = 1,
		sentence =
		[
			"Position reset: back along n̂ to the good side, until the ball touches.",
			"Position reset: new does not overlap the line, so nothing is moved.",
			"Old and new are the same point: the ball does not move.",
			"One frame moves the ball by v, from old to new.",
			"Compare the t of the mistake with the right one.",
			"Now old and new are distances from the line: a = old − r.",
		],
		verdict = [[], ["t = −2.267, below 0"]],
		lines = [["v = new − old"], ["wrong: 40 / 80 = 0.5"]],
		labels = [["old", "new", "reset", "20 n̂"], ["a −54.4"], ["wrong"], ["POI"]],
	},
	{
		id = &"point_of_impact",
		state = {old = [6, 60], new = [6, 90], line = _LINE, radius = 10, moment = 0, mistake = 0},
		step = 3,
		verdict_sign = ["!", "×"],
		verdict =
		[
			["t = −2.267, below 0", "behind the line already: contact at once"],
			["t = −2.267, below 0", "too close already: contact at once"],
			["t = −2.267, above 1"],
		],
		sentence =
		[
			"t is below 0: the contact lies before this frame.",
			"t is above 1: the contact lies after this frame.",
			"t = a / b is the share of the frame until the contact. It counts only within 0..1.",
			"b is 0: there is nothing to divide by, so there is no t.",
			"b is below 0: the ball moves away, and t does not count.",
		],
	},
	{
		id = &"class_or_value",
		state = {position = [4, -4], old = [2, -3], copies = false},
		step = [3],
		sentence =
		[
			"Why Vec2? It keeps 64 bits of each number, Vector2 only 32.",
			"set_xy changes only the first Vec2. old is a copy and stays, just like old_value.",
			"something new",
		],
		rows =
		[
			[["Vector2, 1000 times", "99.999046", "0.00095", "15 ns"]],
			[["Vector2, 1000 times", "100", "0.00095", "15 ns"]],
			[["Vector2, 1000 times", "99.999046", "0.0095", "15 ns"]],
			[["Vec2, 10 times", "1", "0", "15 ns"]],
		],
		labels =
		[
			["position", "old", "two names, one object", "two names, two values"],
			["two names, two objects"],
			["one name, one object"],
			["new"],
		],
		notice = ["", "cannot be taken"],
	},
	{
		id = &"easy_bounce",
		state = {ball = [0, 4, 20, 48, 60], pivot = [0, 40], tilt_degrees = 30.0, is_wall = false},
		step = [4],
		verdict_sign = ["✗", "✓", "=", "?"],
		verdict =
		[
			["Frame 1:", "the easy ball is 61.2 px off"],
			["Frame 0:", "the easy ball is 61.2 px off"],
			["Frame 1:", "the easy ball is 14.4 px off"],
			["Frame 1:", "both balls are in one place"],
			["The easy way is right", "in all three steps"],
			["something new"],
			[],
		],
		sentence =
		[
			"Play it, frame by frame: the easy ball goes astray.",
			"Here both programs do the same. Move the ball, or tilt the line.",
			"Flip: only the part of v along the normal n̂ changes its sign, or y.",
			"something new",
		],
		rows =
		[
			[
				["easy distance", "119.5", "16"],
				["by the normal", "103.5", "0"],
				["easy place", "(20, −68)", "0"],
				["easy velocity", "(20, −48)", "0"],
			],
			[
				["easy distance", "119.5", "16"],
				["by the normal", "103.5", "0"],
				["easy place", "(20, −60)", "0"],
				["easy velocity", "(20, −48)", "0"],
			],
			[
				["easy distance", "119.5", "16"],
				["by the normal", "119.5", "0"],
				["easy place", "(20, −68)", "0"],
				["easy velocity", "(20, −48)", "0"],
			],
			[["easy distance", "119.5", "16"]],
		],
		lines =
		[
			["r = 60     tilt = 30°     frame 1", "easy: 119.5 > r = 60: no hit"],
			["r = 60     tilt = 30°     frame 1", "easy: 36 < r = 60: hit"],
			["r = 60     tilt = 30°     frame 2", "easy: 119.5 > r = 60: no hit"],
		],
		labels = [["right", "easy", "v"], ["before"], ["flipped"], ["new"]],
	},
	{
		id = &"more_dimensions",
		state = {a = [4, -3, 2, 1], b = [-3, 2, 1, -4], has_four = false},
		step = [4],
		sentence =
		[
			"For the angle itself, divide by both lengths: that is its cosine.",
			"A zero vector has no direction: there is no angle.",
			"Its sign alone tells the angle. Above 90°, the shadow p of a points against b.",
			"something new",
		],
		labels =
		[
			["x", "p", "a · b < 0\nthe angle is above 90°"],
			["a · b > 0\nthe angle is above 90°"],
			["a · b < 0\nthe angle is below 90°"],
			["a · b < 0\na zero vector makes no angle"],
			["Four axes do not fit into a picture. The formula is the same."],
			["q"],
		],
		rows =
		[
			[["a · b", "−16", "0"], ["cos α", "−0.794", "2.2e−17"]],
			[["a · b", "−15", "0"]],
			[["cos α", "0.794", "0"]],
			[["cos α", "−0.794", "0.1"]],
			[["sin α", "0.6", "0"]],
		],
		lines =
		[
			["a · b < 0:  the angle is above 90°", "α = 142.6°"],
			["a · b < 0:  a right angle"],
			["α = 142.4°"],
		],
	},
]
const _LINE: Array[int] = [60, 45, -60, -45]
## The frame with which the lesson on the point of impact starts.
const _FRAME := {
	old = [6, -58], new = [6, 42], line = _LINE, radius = 10.0, moment = 0.25, mistake = 0
}


func test_what_is_true_passes_and_what_is_false_is_told() -> void:
	for case: Dictionary in _CASES:
		for member: String in case:
			if member in ["id", "state", "step"]:
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
	seen.step = case.get("step", _LAST_STEP)
	for member: String in case:
		if not member in ["id", "state", "step"]:
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
