extends RefCounted
## What the lesson more_dimensions may say of a state, and what is false.
## `test_judges.gd` says how to read it.

const CASES: Array[Dictionary] = [
	{
		id = &"more_dimensions",
		state =
		{a = [4, -3, 2, 1], b = [-3, 2, 1, -4], fifth = [0, 0], has_four = false, has_five = false},
		step = [4],
		sentence =
		[
			"For the angle itself, divide by both lengths: that is its cosine.",
			"A zero vector has no direction: there is no angle.",
			"Its sign tells: below, at or above 90°. Above 90°, the shadow p of a points against b.",
			"What the dot product is for, and in which lesson each use is shown.",
			"something new",
		],
		labels =
		[
			["x", "p", "a · b < 0\nthe angle is above 90°"],
			["a · b > 0\nthe angle is above 90°"],
			["a · b < 0\nthe angle is below 90°"],
			["a · b < 0\na zero vector makes no angle"],
			["So many axes do not fit into a picture. The formula is the same."],
			["shadow, projection (4, 5)"],
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
	{
		id = &"more_dimensions",
		state =
		{a = [1, 1, 1, 1], b = [1, 0, 0, 0], fifth = [2, 3], has_four = false, has_five = true},
		step = [5],
		sentence =
		[
			"What the dot product is for, and in which lesson each use is shown.",
			"Add the products: one number comes out, whatever the dimension.",
		],
		labels =
		[
			["use (lesson)", "length (3)", "|a| = √(a · a)"],
			["a · b > 0\na right angle"],
			["Drag beside the arrows to turn the axes."],
		],
		lines = [["a · b > 0: the angle is below 90°"], ["a · b < 0: the angle is above 90°"]],
	},
]
