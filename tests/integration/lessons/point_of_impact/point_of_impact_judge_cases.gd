extends RefCounted
## What the lesson point_of_impact may say of a state, and what is false.
## `test_judges.gd` says how to read it.

const _LINE: Array[int] = [60, 45, -60, -45]
## The frame with which the lesson starts.
const _FRAME := {
	old = [6, -58], new = [6, 42], line = _LINE, radius = 10.0, moment = 0.25, mistake = 0
}
const CASES: Array[Dictionary] = [
	{
		id = &"point_of_impact",
		state = _FRAME,
		step = [5],
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
			"t = a / b: 0 is the start of the frame, 1 its end. Only within 0..1 it touches in this frame.",
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
		step = [4],
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
		step = [5],
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
		step = [1],
		sentence =
		[
			"The line has one good side, that of n̂. Position reset: back along n̂ until the ball touches.",
			"Position reset: new does not overlap the line, so nothing is moved.",
			"Old and new are the same point: the ball does not move.",
			"One frame moves the ball by v, from old to new.",
			"Compare the t of the mistake with the right one.",
			"a = old − r is the way along n̂ to the contact, b = old − new that of the whole frame.",
		],
		verdict = [[], ["t = −2.267, below 0"]],
		lines = [["v = new − old"], ["wrong: 40 / 80 = 0.5"]],
		labels = [["old", "new", "reset", "20 n̂"], ["a −54.4"], ["wrong"], ["POI"]],
	},
	{
		id = &"point_of_impact",
		state = {old = [6, 60], new = [6, 90], line = _LINE, radius = 10, moment = 0, mistake = 0},
		step = [4],
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
			"t = a / b: 0 is the start of the frame, 1 its end. Only within 0..1 it touches in this frame.",
			"b is 0: there is nothing to divide by, so there is no t.",
			"b is below 0: the ball moves away, and t does not count.",
		],
	},
	{
		id = &"point_of_impact",
		state = {old = [6, -8], new = [6, 42], line = _LINE, radius = 10, moment = 0, mistake = 0},
		step = [5],
		verdict =
		[
			["t = 0, within 0..1", "it touches at the start of the frame, in old"],
			["t = 0, within 0..1", "it touches at the end of the frame, in new"],
		],
		sentence = ["POI = old + t v is on the path. The reset is not."],
		labels = [["old = POI", "new", "a 0"], ["old 10"]],
	},
	{
		id = &"point_of_impact",
		state = _FRAME,
		step = [2],
		sentence =
		[
			"Measure along n̂: old and new are now distances from the line, below 0 behind it.",
			"a = old − r is the way along n̂ to the contact, b = old − new that of the whole frame.",
		],
		labels = [["old 50", "new −30", "r 10"], ["new 30"], ["r 5"], ["a 40"], ["reset"]],
	},
]
