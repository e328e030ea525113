extends RefCounted
## What the lesson newton_balls may say of a state, and what is false.
## `test_judges.gd` says how to read it.

## The start of the lesson, with the masses ignored.
const _ONE_TO_TWO := {
	balls = [[-6, 0, 6, 0, 1], [2, 0, 0, 0, 2]],
	bounciness = 1.0,
	has_box = false,
	has_newton = true,
	mistake = 25
}
## The same with Newton off and C = 0.5.
const _OFF := {
	balls = [[-6, 0, 6, 0, 1], [2, 0, 0, 0, 2]],
	bounciness = 0.5,
	has_box = false,
	has_newton = false,
	mistake = 0
}
## They part; a third ball stands aside.
const _PARTING := {
	balls = [[-6, 0, -6, 0, 1], [2, 0, 0, 0, 2], [2, 5, 0, 0, 1]],
	bounciness = 0.0,
	has_box = false,
	has_newton = true,
	mistake = 0
}
const CASES: Array[Dictionary] = [
	{
		id = &"newton_balls",
		state = _ONE_TO_TWO,
		step = [5],
		verdict_sign = ["✗", "×"],
		verdict =
		[
			["v₁′ = (−2, 0)", "v₂′ = (4, 0)", "the mistake: v₁′ = (−6, 0), v₂′ = (0, 0)"],
			["v₁′ = (2, 0)"],
			["v₂′ = (−2, 0)"],
			["the mistake: v₁′ = (−2, 0), v₂′ = (4, 0)"],
			["the mistake changes nothing here"],
			["P = (6, 0), before and after"],
			["within 60 s no two balls meet"],
			["something new"],
		],
		sentence =
		[
			"The same J changes a heavy ball little and a light one much. Across n nothing changes.",
			"Within 60 s no two balls meet. Drag a ball or a velocity so that they do.",
			"Tip to tail, the momenta lead to the same sum P before and after the bounce.",
			"something new",
		],
		rows =
		[
			[["v₁′", "(−2, 0)", "0"], ["v₂′", "(4, 0)", "1e−16"]],
			[["v₁′", "(−2.1, 0)", "0"]],
			[["v₂′", "(4, 0)", "1e−9"]],
		],
		labels = [["v₁", "m₂", "n", "v₁′", "C = 1"], ["C = 0.5"], ["V"], ["P"], ["something new"]],
	},
	{
		id = &"newton_balls",
		state = _ONE_TO_TWO,
		step = [6],
		verdict_sign = ["✗", "×"],
		verdict =
		[
			["P = (6, 0), before and after", "the mistake makes P = (−6, 0)"],
			["P = (5, 0), before and after"],
			["the mistake makes P = (6, 0)"],
		],
		sentence =
		[
			"Tip to tail, the momenta lead to the same sum P before and after the bounce.",
			"n points from ball 1 to ball 2. Smooth balls push each other along n only.",
		],
		labels =
		[
			["p₁", "P′", "t = 0.00 s   P = (6, 0)   E = 18"],
			["t = 0.00 s   P = (6, 0)   E = 17"],
			["t = 0.00 s   P = (6, 1)   E = 18"],
		],
	},
	{
		id = &"newton_balls",
		state = _OFF,
		step = [7],
		verdict_sign = ["✗", "×"],
		verdict =
		[
			["E: 9 of 18 is lost", "the mistake makes E = 4.5"],
			["E = 18, before and after"],
			["E: 8 of 18 is lost"],
			["E: 9 of 17 is lost"],
			["the mistake makes E = 18"],
		],
		sentence =
		[
			"Of the energy seen from the centre of mass, along n, only the share C² stays.",
			"With C = 1 the closing speed comes back in full, and no kinetic energy is lost.",
		],
		lines = [["mistake: (−3, 0)"]],
	},
	{
		id = &"newton_balls",
		state = _OFF,
		step = [0],
		sentence =
		[
			"Newton is off: each ball bounces as off a wall. Press Play and watch the momenta.",
			"Press Play: two balls meet. How fast does each of them leave?",
		],
		lines = [["C = 0.5"], ["mistake: (−3, 0)"]],
		rows = [[], [["v₁′", "(0, 0)", "0"]]],
	},
	{
		id = &"newton_balls",
		state = _OFF,
		step = [3],
		verdict_sign = ["=", "✗"],
		verdict =
		[["V = (2, 0), before and after"], ["V = (3, 0), before and after"], ["both feel J = 6"]],
		sentence =
		[
			"Seen from the centre of mass, each ball leaves along n as fast as it came, times C.",
			"For somebody who moves with V, each ball leaves along n as fast as it came, times C.",
		],
		labels = [["u₁", "u₂′", "n"], ["v₁′"], ["J"]],
	},
	{
		id = &"newton_balls",
		state = _OFF,
		step = [4],
		verdict_sign = ["="],
		verdict = [["both feel J = 6"], ["both feel J = 4"]],
		sentence =
		["Each gives the other the same push J, in opposite directions: action and reaction."],
		labels = [["J", "−J"], ["V"]],
	},
	{
		id = &"newton_balls",
		state = _PARTING,
		step = [4],
		verdict_sign = ["×", "="],
		verdict = [["within 60 s no two balls meet"], ["both feel J = 4"]],
		sentence =
		[
			"Within 60 s no two balls meet. Drag a ball or a velocity so that they do.",
			"Each gives the other the same push J, in opposite directions: action and reaction.",
		],
	},
]
