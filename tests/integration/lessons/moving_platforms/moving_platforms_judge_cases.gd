extends RefCounted
## What the judge of the lesson moving_platforms has to tell apart, for test_judges.gd.

## The values of the kinds that a state does not name.
const _WALL := {
	kind = 0,
	ball = [200, 0],
	velocity = [-200, 0],
	surface = [-120, -120, -120, 120],
	surface_velocity = [100, 0],
	turning = 2.0,
	bounciness = 0.5,
	speed = 0.0,
	surface_speed = 90.0,
	friction = 0.05,
	way = 180.0,
	from_surface = false,
	mistake = 102
}
const _AWAY := {
	kind = 0,
	ball = [200, 0],
	velocity = [200, 0],
	surface = [-120, -120, -120, 120],
	surface_velocity = [100, 0],
	turning = 2.0,
	bounciness = 0.5,
	speed = 0.0,
	surface_speed = 90.0,
	friction = 0.05,
	way = 180.0,
	from_surface = false,
	mistake = 0
}
const _BELT := {
	kind = 1,
	ball = [-120, 20],
	velocity = [-200, 0],
	surface = [-200, 40, 200, 40],
	surface_velocity = [100, 0],
	turning = 2.0,
	bounciness = 1.0,
	speed = 0.0,
	surface_speed = 90.0,
	friction = 0.05,
	way = 180.0,
	from_surface = false,
	mistake = 105
}
const _PLATFORM := {
	kind = 2,
	ball = [-120, 20],
	velocity = [-200, 0],
	surface = [-200, 40, 200, 40],
	surface_velocity = [100, 0],
	turning = 2.0,
	bounciness = 1.0,
	speed = 0.0,
	surface_speed = 90.0,
	friction = 0.2,
	way = 180.0,
	from_surface = false,
	mistake = 106
}
const _PADDLE := {
	kind = 3,
	ball = [241.42974355881807, -110.71487177940904],
	velocity = [-200, 100],
	surface = [0, 100, -120, 190],
	surface_velocity = [100, 0],
	turning = 2.0,
	bounciness = 1.0,
	speed = 0.0,
	surface_speed = 90.0,
	friction = 0.2,
	way = 180.0,
	from_surface = false,
	mistake = 104
}
const _PRESS := {
	kind = 4,
	ball = [200, 0],
	velocity = [-200, 0],
	surface = [-120, -120, -120, 120],
	surface_velocity = [100, 0],
	turning = 2.0,
	bounciness = 1.0,
	speed = 300.0,
	surface_speed = 100.0,
	friction = 0.2,
	way = 200.0,
	from_surface = false,
	mistake = 0
}
const CASES: Array[Dictionary] = [
	{
		id = &"moving_platforms",
		state = _WALL,
		step = [3, 2, 1],
		verdict_sign = ["✗", "0"],
		verdict =
		[
			["they meet after 1 s", "v′ = (250, 0)", "the mistake: v′ = (200, 0)"],
			["they meet after 2 s", "v′ = (250, 0)", "the mistake: v′ = (200, 0)"],
			["they meet after 1 s", "v′ = (200, 0)", "the mistake: v′ = (200, 0)"],
			["they meet after 1 s", "v′ = (250, 0)", "the mistake: v′ = (300, 0)"],
			["the mistake changes nothing here"],
			["no impact within 20 s"],
			["crushed after 2 s"],
			["something new"],
		],
		sentence =
		[
			"Seen from the lab again, w is added: v′ = U′ + w.",
			"There the law is that of a wall at rest: what U has along n turns round, times C.",
			"Within 20 s they do not meet. Drag the ball or a velocity so that they do.",
			"something new",
		],
		labels = [["w", "U′", "v′"], ["u"], ["r"], ["something new"]],
	},
	{
		id = &"moving_platforms",
		state = _WALL,
		step = [4, 3],
		verdict_sign = ["✗"],
		verdict =
		[
			["miss 0 px; ε × condition 5e−13 px", "the mistake: v′ = (200, 0)"],
			["miss 1e−10 px; ε × condition 5e−13 px", "the mistake: v′ = (200, 0)"],
		],
		sentence =
		[
			"Flown in the event world. What the mistake does is red.",
			"Flown in the event world, it comes to where the formulas have it.",
		],
		rows =
		[
			[["v′", "(250, 0)", "0", "9 ns"]],
			[["v′", "(400, 0)", "0", "9 ns"]],
			[["v′", "(250, 0)", "0.1", "9 ns"]],
			[["v′", "none", "", "9 ns"]],
		],
	},
	{
		id = &"moving_platforms",
		state = _AWAY,
		step = [3],
		verdict_sign = ["0", "!"],
		verdict = [["no impact within 20 s"], ["they meet after 1 s"]],
		sentence =
		["Within 20 s they do not meet. Drag the ball or a velocity so that they do.", "v′ = U′"],
	},
	{
		id = &"moving_platforms",
		state = _BELT,
		step = [3, 4],
		verdict_sign = ["✗", "0"],
		verdict =
		[
			["it slips for 1 s", "then it rolls with 30 px/s", "the mistake: 90 px/s"],
			["it slips for 2 s", "then it rolls with 30 px/s", "the mistake: 90 px/s"],
			["it slips for 1 s", "then it rolls with 60 px/s", "the mistake: 90 px/s"],
			["it slips for 1 s", "then it rolls with 30 px/s", "the mistake: 80 px/s"],
			["it slips all the way"],
			["it rolls at once"],
		],
		sentence =
		[
			"A third of u goes into the flight, two thirds into the spin. Then it rolls.",
			"Nothing slips, and it rolls at once.",
			"The belt ends before u is 0: it still slips there.",
		],
		labels = [["v", "s", "v′"], ["V"], ["f"]],
	},
	{
		id = &"moving_platforms",
		state = _PLATFORM,
		step = [3],
		verdict_sign = ["✗"],
		verdict =
		[
			[
				"carried for 2 s",
				"it slips for 0.5 s",
				"then it rolls with 30 px/s",
				"the mistake: 1.5 px behind"
			],
			["carried for 1 s"],
			["then it rolls with −30 px/s"],
			["the mistake: 3 px behind"],
		],
		sentence =
		[
			"It keeps a third of V and rolls on, while the platform goes back.",
			"Without friction it keeps V.",
		],
	},
	{
		id = &"moving_platforms",
		state = _PADDLE,
		step = [3],
		verdict_sign = ["✗"],
		verdict =
		[
			["they meet after 1.107 s", "v′ = (600, 100)", "the mistake: v′ = (800, 100)"],
			["they meet after 1.107 s", "v′ = (400, 100)", "the mistake: v′ = (800, 100)"],
			["they meet after 1.107 s", "v′ = (600, 100)", "the mistake: v′ = (700, 100)"],
			["they meet after 1.3 s", "v′ = (600, 100)", "the mistake: v′ = (800, 100)"],
		],
		sentence =
		["Seen from the lab again, w is added: v′ = U′ + w.", "Each such bounce adds 2 V."],
		labels = [["w", "U′", "v′"], ["n"]],
	},
	{
		id = &"moving_platforms",
		state = _PRESS,
		step = [3, 4],
		verdict_sign = ["!", "✗"],
		verdict =
		[
			["after 3 bounces off it: 900 px/s", "way left then: 50 px"],
			["after 3 bounces off it: 600 px/s", "way left then: 50 px"],
			["after 3 bounces off it: 900 px/s", "way left then: 66.67 px"],
		],
		sentence =
		[
			"Each such bounce adds 2 V. The way h that is free shrinks, and h (u − V) stays the same.",
			"It keeps a third of V and rolls on, while the platform goes back.",
		],
		labels = [["V"], ["u₀"], ["U′"]],
	},
	{
		id = &"moving_platforms",
		state = _PRESS,
		step = [4, 3],
		verdict_sign = ["!"],
		verdict =
		[
			["crushed after 2 s", "miss 5.7e−14 px; ε × condition 6.4e−13 px"],
			["crushed after 3 s", "miss 5.7e−14 px; ε × condition 6.4e−13 px"],
		],
		sentence =
		[
			"Without end the bounces come faster, until h₀ / V. The crushed ball keeps its last state.",
			"Flown in the event world. What the mistake does is red.",
		],
		rows = [[["crushed after", "2", "0", "9 ns"]], [["crushed after", "3", "0", "9 ns"]]],
	},
]
