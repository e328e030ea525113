extends RefCounted
## What the lesson projection_proof may say of a state, and what is false.
## `test_judges.gd` says how to read it.

const CASES: Array[Dictionary] = [
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
		state = {a = [7, 1], b = [8, -6]},
		step = [4],
		sentence = ["The triangle of b holds cos β and sin β: its sides divided by |b|."],
		labels = [["a", "b", "a′", "b′", "p", "bx = 8", "by = −6"], ["bx = 7"], ["by = 6"], ["ax"]],
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
]
