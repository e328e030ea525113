extends RefCounted
## What the lesson normals may say of a state, and what is false.
## `test_judges.gd` says how to read it.

const CASES: Array[Dictionary] = [
	{
		id = &"normals",
		state = {line = [0, 0, 3, -4], times = 2.0, mistake = 0},
		step = [4, 3, 0],
		verdict_sign = ["+", "0", "✗", "="],
		verdict =
		[
			["+90° turns clockwise", "y points down"],
			["+90° turns counter-clockwise", "y points down"],
			["+90° turns clockwise", "y points up"],
			["The zero vector", "has no direction and no normal"],
			["+90° turns clockwise", "(y, −x): −90°, the other side"],
			["+90° turns clockwise", "something new"],
			[],
		],
		sentence =
		[
			"In pixels, length 1 is too short to see. So draw a multiple of n̂.",
			"A line has a direction: v = end − start. Drag its ends, or all of it.",
			"v is zero: there is no n̂ to draw.",
			"Mistake 9 is on: n, and what two wrong formulas make of v.",
		],
		labels =
		[["v", "n", "−n", "n̂", "2 n̂"], ["3 n̂"], ["v̂"], ["✗ (0, 0)"], ["✗ (y, x)"], ["q"]],
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
		state = {line = [0, 0, 0.3, 0.4], times = 2.0, mistake = 7},
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
]
