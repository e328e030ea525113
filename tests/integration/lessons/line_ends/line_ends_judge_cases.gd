extends RefCounted
## What the judge of the lesson line_ends has to tell apart, for test_judges.gd.

const CASES: Array[Dictionary] = [
	{
		id = &"line_ends",
		state = {shot = [-6, -8, 6, 16, 5], line = [1, 3, 13, 8], time = 1.0, mistake = 20},
		step = [6, 4, 3, 2],
		sentence =
		[
			"n̂ points from the end to the ball's centre. Reflect v on it as before.",
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
			["−v · n̂ = 1: it moves away, no impact"],
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
				"n̂",
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
				"n̂",
				"t₁",
				"wrong",
				"touches the end, t = 0.5\n✗ the wrong ball: t = −0.5"
			],
			[
				"Segment, two sides, round caps",
				"v",
				"A",
				"n̂",
				"t₁",
				"wrong",
				"bounces on the end, t = 0.5"
			],
			[
				"Segment, two sides, round caps",
				"v",
				"A",
				"n̂",
				"t₁",
				"wrong",
				"bounces on the end, t = 0.5\n✗ the wrong ball: t = 0.5"
			],
			[
				"Segment, two sides, round caps",
				"v",
				"A",
				"n̂",
				"t₁",
				"wrong",
				"bounces on the end, t = 0.5\n✗ the wrong ball passes"
			],
			[
				"Segment, two sides, round caps",
				"v",
				"A",
				"n̂",
				"t₁",
				"wrong",
				"bounces on the end, t = 0.5\nthe wrong ball does the same here"
			],
			["d"],
			["t₂"],
		],
	},
]
