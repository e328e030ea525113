extends RefCounted
## What the lesson line_distance may say of a state, and what is false.
## `test_judges.gd` says how to read it.

const CASES: Array[Dictionary] = [
	{
		id = &"line_distance",
		step = [4],
		state =
		{line = [200, 150, -200, -150], ball = [24, 93, 30], speed = 35, rule = 0, mistake = 0},
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
			"A segment has ends. Here its distance is the same. Drag the ball past an end.",
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
		state =
		{line = [200, 150, -200, -150], ball = [78, 21, 30], speed = 35, rule = 0, mistake = 9},
		step = [3],
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
		state =
		{line = [200, 150, -200, -150], ball = [78, 21, 30], speed = 35, rule = 0, mistake = 9},
		step = [1],
		sentence =
		[
			"The unit normal n̂ is perpendicular to the line. It points to the good side.",
			"Compare the distance of the mistake with the right one.",
		],
		verdict = [[], ["Free: gap 70 px"]],
		rows = [[], [["from p", "30", "0"]]],
		lines = [["d = c − p"], ["wrong: d · (−n̂) = −30"]],
		labels = [["line", "d"], ["touching"], ["r"], ["right 30"]],
	},
	{
		id = &"line_distance",
		state =
		{line = [200, 150, -200, -150], ball = [120, -35, 30], speed = 140, rule = 2, mistake = 9},
		step = [5],
		verdict_sign = ["0", "!", "+"],
		verdict =
		[
			["red in 0 of 2 frames", "it passes between two frames"],
			["red in 1 of 2 frames", "it passes between two frames"],
			["red in 0 of 9 frames"],
		],
		sentence =
		[
			"Discrete detection looks once a frame: a ball this fast jumps over the line and is never seen.",
			"Discrete detection looks once a frame: red where d · n̂ < r, far behind the line, too.",
			"Compare the distance of the mistake with the right one.",
		],
		rows = [[]],
		labels = [["line"], ["d"], ["free"], ["gap 70"], ["wrong −100"]],
	},
	{
		id = &"line_distance",
		state =
		{line = [200, 150, -200, -150], ball = [120, -35, 30], speed = 35, rule = 2, mistake = 0},
		step = [5],
		verdict_sign = ["!", "0"],
		verdict =
		[
			["red in 1 of 5 frames"],
			["red in 3 of 5 frames"],
			["red in 1 of 5 frames", "it passes between two frames"],
		],
		sentence =
		[
			"Discrete detection looks once a frame: red on both sides of the line, closer than r.",
			"Discrete detection looks once a frame: red only in front of the line, closer than r.",
			"Discrete detection looks once a frame: a ball this fast jumps over the line and is never seen.",
		],
	},
]
