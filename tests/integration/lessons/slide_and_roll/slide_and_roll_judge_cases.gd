extends RefCounted
## What the lesson slide_and_roll may say of a state, and what is false.
## `test_judges.gd` says how to read it.

## The start of the lesson, with the threshold tan: it rolls, and is at the end after 1 s.
const _ROLLS := {
	start = [-48, -36],
	end = [48, 36],
	friction = 0.5,
	speed = 0.0,
	gravity = 600.0,
	radius = 10.0,
	mistake = 101,
	has_engine = true
}
## Too little friction.
const _SLIPS := {
	start = [-48, -36],
	end = [48, 36],
	friction = 0.125,
	speed = 0.0,
	gravity = 600.0,
	radius = 10.0,
	mistake = 0,
	has_engine = false
}
## Pushed along the level, with the mistake that it stops.
const _LEVEL := {
	start = [-187.5, 0],
	end = [187.5, 0],
	friction = 0.2,
	speed = 300.0,
	gravity = 600.0,
	radius = 15.0,
	mistake = 103,
	has_engine = false
}
## The same on a short line.
const _SHORT := {
	start = [-60, 0],
	end = [60, 0],
	friction = 0.2,
	speed = 300.0,
	gravity = 600.0,
	radius = 10.0,
	mistake = 0,
	has_engine = false
}
## Nothing moves it.
const _RESTS := {
	start = [-60, 0],
	end = [60, 0],
	friction = 0.2,
	speed = 0.0,
	gravity = 600.0,
	radius = 10.0,
	mistake = 102,
	has_engine = false
}
const CASES: Array[Dictionary] = [
	{
		id = &"slide_and_roll",
		state = _ROLLS,
		step = [6],
		verdict_sign = ["✗", "×"],
		verdict =
		[
			["it rolls at once", "at the end after 1 s", "the mistake: 60 px behind"],
			["it rolls after 0.5 s"],
			["it slips all the way"],
			["the line ends before it rolls"],
			["nothing moves"],
			["at the end after 0.8165 s"],
			["it does not come to the end"],
			["the mistake: 60 px ahead"],
			["the mistake: 61 px behind"],
			["the mistake: it stops after 2.5 s"],
			["the mistake changes nothing here"],
			["something new"],
		],
		sentence =
		[
			"The formula is off by rounding only. In frames the slip never ends: the ball trembles.",
			"The formula is off by rounding only. In frames the end is seen with the next frame.",
			"Nothing moves, so there is nothing to measure.",
			"something new",
		],
		rows =
		[
			[
				["t, by the formula", "1 s", "0 s"],
				["t, in frames of 1/60 s", "1.017 s", "0.017 s"],
				["slip at the end, in frames", "6 px/s", "6 px/s"]
			],
			[["t, by the formula", "1.1 s", "0 s"]],
			[["t, by the formula", "1 s", "1e−9 s"]],
			[["t, by the formula", "none", ""]],
			[["t, in frames of 1/60 s", "1.017 s", "0.5 s"]],
			[["slip at the end, in frames", "50 px/s", "50 px/s"]],
			[["slip at the end, in frames", "6 px/s", "0 px/s"]],
		],
		labels = [["v₀", "µ = 0", "µ = 0.5", "rolls"], ["G"], ["µ = 0.4"], ["something new"]],
	},
	{
		id = &"slide_and_roll",
		state = _SLIPS,
		step = [4],
		verdict_sign = ["!", "✗"],
		verdict =
		[
			["it slips all the way"],
			["it rolls at once"],
			["at the end after 0.8944 s"],
			["the mistake changes nothing here"]
		],
		sentence =
		[
			"Friction is too weak: it slips on, and turns too slowly to roll.",
			"It rolls. A third of G turns the ball, so two thirds of G move it.",
			"It slips until t₁. Then the slip is 0, and it rolls.",
			"It slips, and the line ends before the slip is 0.",
			"Without friction it slips on and does not turn.",
		],
		labels = [["G", "f"], ["g"], ["N"], ["v₀"], ["rolls"]],
		rows = [[], [["t, by the formula", "0.8944 s", "0 s"]]],
	},
	{
		id = &"slide_and_roll",
		state = _SLIPS,
		step = [3],
		verdict = [[], ["it slips all the way"]],
		sentence =
		[
			"It can roll if 3 µ N is at least G: from µ = tan / 3 on. Drag µ across the mark.",
			"On the level tan is 0: with any friction the ball rolls in the end.",
		],
	},
	{
		id = &"slide_and_roll",
		state = _LEVEL,
		step = [5],
		verdict_sign = ["✗", "×"],
		verdict =
		[
			[
				"it rolls after 0.8333 s",
				"at the end after 1.667 s",
				"the mistake: it stops after 2.5 s"
			],
			["it rolls after 1 s"],
			["the mistake: it stops after 2 s"],
			["the mistake: 41.7 px ahead"],
		],
		sentence =
		["Three balls race: without friction, with µ, and one.", "Nobody wins: nothing moves."],
	},
	{
		id = &"slide_and_roll",
		state = _LEVEL,
		step = [1],
		sentence =
		[
			"The line is level: gravity presses with N and does not pull, G = 0.",
			"Gravity pulls along the line with G and presses on it with N.",
		],
		labels = [["g", "N"], ["G"], ["f"]],
	},
	{
		id = &"slide_and_roll",
		state = _SHORT,
		step = [4],
		verdict = [["the line ends before it rolls"], ["it rolls after 0.8333 s"]],
		sentence =
		["It slips, and the line ends before the slip is 0.", "It slips until t₁. Then it rolls."],
	},
	{
		id = &"slide_and_roll",
		state = _RESTS,
		step = [5],
		verdict_sign = ["×", "!"],
		verdict =
		[
			["nothing moves", "it does not come to the end", "the mistake changes nothing here"],
			["it rolls at once"],
			["at the end after 1 s"]
		],
		sentence = ["Nobody wins this race: nothing moves.", "Three balls race: without friction."],
		rows = [[["t, by the formula", "none", ""]], [["t, by the formula", "1 s", "0 s"]]],
	},
]
