extends RefCounted
## What the judge of the lesson bank_shot has to tell apart, for test_judges.gd.

const CASES: Array[Dictionary] = [
	{
		id = &"bank_shot",
		state =
		{
			start = [100, 100],
			target = [300, 160],
			walls = [[20, 300, 440, 300], [200, 200, 200, 40]],
			radius = 20.0,
			bounciness = 0.5,
			bounces = 1,
			order = "",
			mistake = 103,
		},
		step = [5, 2, 1],
		verdict_sign = ["✗"],
		verdict =
		[
			[
				"miss 3e−14 px; ε × condition 4.8e−13 px",
				"so far rounding alone may move it",
				"with the mistake it misses by 48 px"
			],
			[
				"miss 3e−12 px; ε × condition 4.8e−13 px",
				"so far rounding alone may move it",
				"with the mistake it misses by 48 px"
			],
			["miss 3e−14 px; ε × condition 4.8e−13 px", "with the mistake it misses by 29.1 px"],
			["miss 3e−14 px; ε × condition 4.8e−13 px", "the mistake changes nothing here"],
			["it would bounce beside an end of wall 1"],
			["no order of walls leads to T"],
			["at S or T the ball overlaps wall 2: make room"],
			["something new"],
		],
		sentence =
		[
			"Play: the right ball flies, and that of the mistake beside it.",
			"There is nothing to fire: a wall is in the way.",
			"Orders of walls that lead to T: 1 of 2. The list says why the others do not.",
		],
		rows =
		[
			[["direction", "(0.4299, 0.9029)", "1e−17"]],
			[["direction", "(0.5547, 0.8321)", "1e−17"]],
			[["direction", "(0.4299, 0.9029)", "0.1"]],
			[["direction", "none", ""]],
		],
		labels = [["S", "T", "1", "2", "B"], ["S", "T", "1", "2", "3", "B"], ["S", "T", "T′"]],
	},
	{
		id = &"bank_shot",
		state =
		{
			start = [100, 100],
			target = [300, 160],
			walls = [[240, 300, 440, 300], [200, 200, 200, 40], [20, 20, 400, 0]],
			radius = 20.0,
			bounciness = 1.0,
			bounces = 1,
			order = "1",
			mistake = 0,
		},
		step = [3],
		verdict_sign = ["✗", "✓"],
		verdict =
		[
			["it would bounce beside an end of wall 1"],
			["a wall is in the way"],
			["the ball would not come to wall 1"],
			["it would bounce beside an end of wall 2"],
			["the way is 360.6 px long, as the line to T′"],
		],
		sentence =
		[
			"Straight at T′? Not here: it would bounce beside an end of wall 1.",
			"Straight at T′? Not here: a wall is in the way.",
			"Shoot straight at T′. Where this line crosses the moved wall, the ball bounces to T.",
		],
		rows = [[["direction", "none", ""]], [["direction", "(0.5547, 0.8321)", "1e−17"]]],
		labels =
		[
			["S", "T", "1", "2", "3", "n̂", "T′", "B"],
			["S", "T", "1", "2", "3", "4", "n̂", "T′", "B"]
		],
	},
	{
		id = &"bank_shot",
		state =
		{
			start = [100, 100],
			target = [300, 160],
			walls = [[20, 300, 440, 300], [200, 200, 200, 40]],
			radius = 20.0,
			bounciness = 0.5,
			bounces = 1,
			order = "",
			mistake = 0,
		},
		step = [2],
		sentence =
		[
			"The bounce keeps only C of the speed along n̂: T′ is 1/C times as far behind as T is before.",
			"Mirror T in the moved wall: T′ is as far behind it as T is before it.",
		],
		labels =
		[
			["S", "T", "1", "2", "n̂", "T′", "d = 120", "d / C = 240"],
			["S", "T", "1", "2", "n̂", "T′", "d = 140", "d / C = 240"],
			["S", "T", "1", "2", "n̂", "T′", "d = 120", "d / C = 120"],
		],
	},
]
