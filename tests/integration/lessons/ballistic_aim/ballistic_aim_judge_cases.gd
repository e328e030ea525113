extends RefCounted
## What the judge of the lesson ballistic_aim has to tell apart, for test_judges.gd.

const CASES: Array[Dictionary] = [
	{
		id = &"ballistic_aim",
		state =
		{
			target = [200, 0],
			velocity = [-60, 0],
			speed = 250.0,
			gravity = 300.0,
			moves = false,
			falls = false,
			arc = 0,
			mistake = 101,
		},
		step = [5, 3, 2, 1],
		verdict_sign = ["✗", "2", "0", "1"],
		verdict =
		[
			["miss 3e−14 px; ε × condition 2.7e−13 px", "the mistake misses by 146 px"],
			["miss 3e−10 px; ε × condition 2.7e−13 px", "the mistake misses by 146 px"],
			["miss 3e−14 px; ε × condition 1.4e−13 px", "the mistake misses by 146 px"],
			["miss 3e−14 px; ε × condition 2.7e−13 px", "the mistake misses by 123 px"],
			["miss 3e−14 px; ε × condition 2.7e−13 px", "the mistake finds no aim"],
			["out of reach: s must be at least 244.9", "the mistake misses by 146 px"],
			["something new", "the mistake misses by 146 px"],
		],
		sentence =
		[
			"Fire: press Play. What the mistake does is dashed.",
			"Fire: press Play. It hits; what is left is rounding.",
			"No aim hits, and nothing is fired.",
			"Shooter and target are in one place: there is nothing to aim at.",
			"One direction hits: d = D / |D|.",
		],
		rows =
		[
			[["t of hit", "1", "0", "9 ns"], ["by tangents", "1", "1e−16", "9 ns"]],
			[["t of hit", "0.5", "0", "9 ns"], ["by tangents", "1", "1e−16", "9 ns"]],
			[["t of hit", "1", "0.1", "9 ns"], ["by tangents", "1", "1e−16", "9 ns"]],
			[["t of hit", "none", "", "9 ns"]],
		],
		labels =
		[
			["s", "g", "D₁", "g t² / 2", "146 px off"],
			["s", "g", "D₂", "g t² / 2", "146 px off"],
			["s", "g", "V", "D₁"],
			["s", "g", "s₀"],
			["something new"],
		],
	},
	{
		id = &"ballistic_aim",
		state =
		{
			target = [200, 0],
			velocity = [-60, 0],
			speed = 240.0,
			gravity = 300.0,
			moves = false,
			falls = false,
			arc = 0,
			mistake = 103,
		},
		step = [3, 1],
		verdict_sign = ["✗", "2", "0"],
		verdict =
		[
			[
				"out of reach: s must be at least 244.9",
				"the mistake takes the root of w < 0: NaN, the bullet is lost"
			],
			["out of reach: s must be at least 250"],
			["out of reach: no aim hits within 60 s"],
			["2 aims hit"],
			["the target is faster than the bullet and gets away"],
			["the mistake changes nothing here"],
		],
		sentence =
		[
			"No direction hits. The card says why.",
			"Two directions hit, d = D / |D|: the flat arc, and the high arc, which takes longer.",
		],
	},
	{
		id = &"ballistic_aim",
		state =
		{
			target = [200, 0],
			velocity = [-60, 0],
			speed = 250.0,
			gravity = 300.0,
			moves = false,
			falls = false,
			arc = 0,
			mistake = 102,
		},
		step = [3, 1],
		verdict_sign = ["✗", "2"],
		verdict =
		[
			["2 aims hit", "the mistake says t = 0.5, not 1, and finds no aim"],
			["2 aims hit", "the mistake says t = 1, not 1, and finds no aim"],
			["2 aims hit", "the mistake misses by 146 px"],
		],
		sentence =
		["Two directions hit, d = D / |D|: the flat arc, and the high arc, which takes longer."],
	},
	{
		id = &"ballistic_aim",
		state =
		{
			target = [0, -120],
			velocity = [-240, 300],
			speed = 250.0,
			gravity = 200.0,
			moves = true,
			falls = false,
			arc = 1,
			mistake = 0,
		},
		step = [3, 0],
		verdict_sign = ["4", "3", "2", "✗"],
		verdict = [["4 aims hit"], ["3 aims hit"], ["one aim hits"], ["2 aims hit"]],
		sentence =
		[
			"4 directions hit, d = D / |D|. Pick one of them in the list.",
			"2 directions hit, d = D / |D|. Pick one of them in the list.",
			"s₀ is the least speed. Its aim halves the angle between P and straight up.",
		],
		labels = [["s", "g", "V", "D₂", "g t² / 2"], ["s", "g", "V", "s₀"]],
	},
]
