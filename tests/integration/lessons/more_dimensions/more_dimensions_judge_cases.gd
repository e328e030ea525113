extends RefCounted
## What the lesson more_dimensions may say of a state, and what is false.
## `test_judges.gd` says how to read it.

const CASES: Array[Dictionary] = [
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
			["a · b < 0: the angle is above 90°", "α = 142.6°"],
			["a · b < 0: a right angle"],
			["α = 142.4°"],
		],
	},
]
