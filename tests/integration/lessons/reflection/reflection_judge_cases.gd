extends RefCounted
## What the judge of the lesson reflection has to tell apart, for test_judges.gd.

const CASES: Array[Dictionary] = [
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
			["in 36.87°, out 56.31° from n̂", "keeps 52 % of its energy"],
			["in 36.87°, out 36.87° from n̂", "keeps 52 % of its energy"],
			["in 53.13°, out 56.31° from n̂", "keeps 52 % of its energy"],
			["in 36.87°, out 56.31° from n̂", "keeps 50 % of its energy"],
			["in 36.87° from n̂, and it stops", "keeps 52 % of its energy"],
			["it moves along the line", "keeps 52 % of its energy"],
			["in 36.87°, out 56.31° from n̂", "the mistake says: (3, −28)"],
			["in 36.87°, out 56.31° from n̂", "something new"],
		],
		sentence =
		[
			"Subtract it (1 + C) times. C is the coefficient of restitution (or reflection).",
			"Subtract it twice: the law of reflection. Both angles are equal.",
			"v · n̂ = 0: no part of v goes into the line. v stays as it is.",
			"n does not have length 1. reflect refuses it, and v stays as it is.",
			"v = 0: the ball does not move.",
		],
		rows =
		[
			[["reflect(n̂, C)", "(3, −2)", "0"]],
			[["reflect(n̂, C)", "(3, −4)", "0"]],
			[["reflect(n̂, C)", "(3, −2)", "0.1"]],
			[["reflect(n̂, C)", "refused", ""]],
		],
		labels =
		[
			[
				"v in",
				"v",
				"slide",
				"−C (v·n̂) n̂",
				"v out",
				"Vector2",
				"is our",
				"value",
				"error",
				"bounce(n̂)",
				"reflect(n̂, 1)",
				"(3, −4)",
				"0",
				"slide(n̂)",
				"reflect(n̂, 0)",
				"(3, 0)",
				"0",
				"reflect(n̂)",
				"−reflect(n̂, 1)",
				"(−3, 4)",
				"0"
			],
			[
				"v in",
				"Vector2",
				"is our",
				"value",
				"error",
				"bounce(n̂)",
				"reflect(n̂, 1)",
				"(3, −4)",
				"0",
				"slide(n̂)",
				"reflect(n̂, 0)",
				"(3, 0)",
				"0",
				"reflect(n̂)",
				"−reflect(n̂, 1)",
				"(3, −4)",
				"0"
			],
			[
				"v in",
				"Vector2",
				"is our",
				"value",
				"error",
				"bounce(n̂)",
				"reflect(n̂, 1)",
				"(3, −4)",
				"0",
				"slide(n̂)",
				"reflect(n̂, 1)",
				"(3, 0)",
				"0",
				"reflect(n̂)",
				"−reflect(n̂, 1)",
				"(−3, 4)",
				"0"
			],
			[
				"v in",
				"Vector2",
				"is our",
				"value",
				"error",
				"bounce(n̂)",
				"reflect(n̂, 1)",
				"(3, −4)",
				"0",
				"slide(n̂)",
				"reflect(n̂, 0)",
				"(3, 0)",
				"0.1",
				"reflect(n̂)",
				"−reflect(n̂, 1)",
				"(−3, 4)",
				"0"
			],
			[
				"v in",
				"(v·n̂) n̂",
				"Vector2",
				"is our",
				"value",
				"error",
				"bounce(n̂)",
				"reflect(n̂, 1)",
				"(3, −4)",
				"0",
				"slide(n̂)",
				"reflect(n̂, 0)",
				"(3, 0)",
				"0",
				"reflect(n̂)",
				"−reflect(n̂, 1)",
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
				"bounce(n̂)",
				"reflect(n̂, 1)",
				"(3, −4)",
				"0",
				"slide(n̂)",
				"reflect(n̂, 0)",
				"(3, 0)",
				"0",
				"reflect(n̂)",
				"−reflect(n̂, 1)",
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
				"bounce(n̂)",
				"reflect(n̂, 1)",
				"(3, −4)",
				"0",
				"slide(n̂)",
				"reflect(n̂, 0)",
				"(3, 0)",
				"0",
				"reflect(n̂)",
				"−reflect(n̂, 1)",
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
			["in 90°, out 45° from n̂", "the mistake changes nothing here"],
		],
		sentence =
		[
			"v · n̂ = 0: no part of v goes into the line. v stays as it is.",
			"Subtract that part once: nothing goes into the line. The ball slides.",
			"Subtract that part once: nothing is left of v. The ball stops.",
		],
		labels = [["v in", "slide"], ["−(v·n̂) n̂"], ["wrong"]],
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
		rows = [[["reflect(n̂, C)", "refused", ""]], [["reflect(n̂, C)", "(3, −4)", "0"]]],
		labels = [["v in", "n"], ["v in", "v"]],
		notice =
		[
			"Vec2.reflect: the normal must have length 1, but has length 2.0.",
			"Vec2.reflect: the normal must have length 1, but has length 3.0.",
			"",
		],
	},
	{
		id = &"reflection",
		state =
		{
			velocity = [3, 4],
			along = [-7, 0],
			bounciness = 1.0,
			has_unit_normal = true,
			normal_length = 2.0,
			mistake = 0,
		},
		step = [5],
		verdict_sign = ["=", "≠"],
		verdict =
		[
			[
				"in 36.87°, out 36.87° from n̂",
				"elastic: it keeps all its energy",
			],
			["in 36.87°, out 36.87° from n̂", "keeps 90 % of its energy"],
		],
		sentence =
		[
			"It may overlap in the next frame, too. Reflect only if v · n̂ < 0: now it is above 0, v stays.",
			"It may overlap in the next frame, too. Reflect only if v · n̂ < 0: now it is 0, v stays.",
			"It may still overlap. Reflect only if v · (−n̂) < 0, −n̂ being on its side: v stays.",
		],
		labels = [["v in", "n̂", "(v·n̂) n̂", "v out"], ["n"], ["v"], ["slide"], ["−(v·n̂) n̂"]],
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
		step = [5],
		verdict_sign = ["≠", "="],
		sentence =
		[
			"It may overlap in the next frame, too. Reflect only if v · n̂ < 0: now it is above 0, v stays.",
			"It may overlap in the next frame, too. Reflect only if v · n̂ < 0: now it is 0, v stays.",
		],
		verdict =
		[
			["in 36.87°, out 56.31° from n̂", "keeps 52 % of its energy"],
			[
				"in 36.87°, out 56.31° from n̂",
				"elastic: it keeps all its energy",
			],
		],
	},
]
