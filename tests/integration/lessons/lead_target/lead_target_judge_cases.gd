extends RefCounted
## What the lesson lead_target may say of a state, and what is false.
## `test_judges.gd` says how to read it.

## The start of the lesson: it hits after 2 s.
const _CROSSING := {
	shooter = [-120, -90],
	target = [120, -90],
	velocity = [0, 90],
	own = [0, 0],
	speed = 150.0,
	radius = 0.0,
	mistake = 102
}
## The target is faster, comes by, and is hit after 0.8 s or 4 s.
const _PASSES := {
	shooter = [-120, -90],
	target = [120, -90],
	velocity = [-180, 90],
	own = [0, 0],
	speed = 150.0,
	radius = 0.0,
	mistake = 0
}
## It is faster and gets away.
const _GETS_AWAY := {
	shooter = [-120, -90],
	target = [120, -90],
	velocity = [180, 90],
	own = [0, 0],
	speed = 150.0,
	radius = 0.0,
	mistake = 101
}
## It is as fast and flees; the shooter moves.
const _KEEPS_AWAY := {
	shooter = [-120, -90],
	target = [120, -90],
	velocity = [120, 100],
	own = [0, 10],
	speed = 150.0,
	radius = 0.0,
	mistake = 0
}
const CASES: Array[Dictionary] = [
	{
		id = &"lead_target",
		state = _CROSSING,
		step = [5],
		verdict_sign = ["✗", "×"],
		verdict =
		[
			["miss 3e−14 px; ε × condition 3.5e−13 px", "the mistake misses by 23.8 px"],
			["it hits after t = 1.6 s"],
			["it hits after t = 2 s", "or later, after 4 s"],
			["miss 24 px; ε × condition 3.5e−13 px"],
			["miss 0 px; ε × condition 3.5e−12 px"],
			["the mistake misses by 123 px"],
			["the mistake changes nothing here"],
			["the mistake hits all the same"],
			["the mistake finds no direction"],
			["no hit: the target is faster"],
			["they touch already: t = 0"],
			["something new"],
		],
		sentence =
		[
			"Press Play: the shot flies. ε × condition is how far rounding alone may move it.",
			"Nothing is fired, because nothing would hit.",
			"The hit is too late to be flown here.",
			"They touch already: no shot has to fly.",
			"Aim along P + V t, at where the target will be.",
			"something new",
		],
		rows =
		[
			[["t, careful", "2 s", "0 s"], ["t, as on the slide", "2 s", "0 s"]],
			[["t, careful", "2.1 s", "0 s"]],
			[["t, careful", "2 s", "0.1 s"]],
			[["t, careful", "none", ""]],
			[["t, as on the slide", "1.6 s", "1.4 s"]],
		],
		labels =
		[["v", "u", "R", "23.8 px"], ["P"], ["V"], ["V t"], ["s d"], ["123 px"], ["something new"]],
	},
	{
		id = &"lead_target",
		state = _CROSSING,
		step = [0],
		sentence =
		[
			"A shot at where the target is now misses it. Press Play and see.",
			"Here a shot at where the target is now hits. Drag v: when does it not?",
			"The target touches the shooter already: every shot hits.",
		],
		labels = [["v", "u", "R", "123 px"], ["23.8 px"], ["P"]],
		verdict = [[], ["it hits after t = 2 s"]],
		rows = [[], [["t, careful", "2 s", "0 s"]]],
		lines = [[], ["mistake: (0.8575, 0.5145)"]],
	},
	{
		id = &"lead_target",
		state = _PASSES,
		step = [3],
		verdict_sign = ["!", "✗"],
		verdict =
		[
			["it hits after t = 0.8 s", "or later, after 4 s"],
			["it hits after t = 4 s"],
			["or later, after 0.8 s"],
			["no hit: the target is as fast"],
		],
		sentence =
		[
			"The target comes by: |P + V t| = R + s t holds at two moments. The earlier one counts.",
			"Squared, |P + V t| = R + s t has two roots. The one below 0 is no hit: it is past.",
			"The target is as fast as the bullet: a is 0, and there is one root. Do not divide by a.",
			"Distance and reach touch at one moment only: a grazing shot.",
			"They touch already: t is 0.",
		],
		labels = [["P", "V t", "P + V t"], ["s d"], ["s · 1 s"]],
	},
	{
		id = &"lead_target",
		state = _GETS_AWAY,
		step = [4],
		verdict_sign = ["×", "!"],
		verdict =
		[
			[
				"no hit: the target is faster",
				"than the bullet and gets away",
				"the mistake misses by 240 px"
			],
			["it hits after t = 0.8 s"],
			["no hit: the target is as fast"],
		],
		sentence =
		[
			"No direction hits, so there is nothing to aim at.",
			"They touch already: aim straight at it."
		],
		rows = [[["t, careful", "none", ""]], [["t, careful", "2 s", "0 s"]]],
	},
	{
		id = &"lead_target",
		state = _KEEPS_AWAY,
		step = [1],
		sentence =
		[
			"The bullet takes u along: seen from the shooter, the target moves with V = v − u.",
			"P leads from the shooter to the target. The shooter stands still, so V is v.",
		],
		labels = [["P", "V", "−u"], ["V t"]],
	},
	{
		id = &"lead_target",
		state = _KEEPS_AWAY,
		step = [3],
		verdict =
		[
			["no hit: the target is as fast", "as the bullet and comes no nearer"],
			["it hits after t = 0.8 s"],
			["or later, after 4 s"],
		],
		sentence =
		[
			"Distance and reach never meet: the target is as fast as the bullet and comes no nearer.",
			"The target comes by: |P + V t| = R + s t holds at two moments. The earlier one counts.",
		],
	},
]
