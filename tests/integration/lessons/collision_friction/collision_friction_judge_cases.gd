extends RefCounted
## What the lesson collision_friction may say of a state, and what is false.
## `test_judges.gd` says how to read it.

## The start of the lesson, with µ as a factor.
const _STICKS := {
	velocity = [300, 400],
	spin = 0.0,
	along = [100, 0],
	friction = 0.25,
	bounciness = 1.0,
	radius = 20.0,
	gravity = 0.0,
	two_balls = false,
	has_friction = true,
	mistake = 101
}
## Too little friction, and nothing switched on.
const _SLIPS := {
	velocity = [300, 400],
	spin = 0.0,
	along = [100, 0],
	friction = 0.1,
	bounciness = 0.8,
	radius = 20.0,
	gravity = 900.0,
	two_balls = false,
	has_friction = true,
	mistake = 0
}
## Two balls, without friction between them.
const _TWO := {
	velocity = [250, 0],
	spin = 0.0,
	along = [60, -80],
	friction = 0.2,
	bounciness = 1.0,
	radius = 20.0,
	gravity = 0.0,
	two_balls = true,
	has_friction = true,
	mistake = 105
}
## Friction is switched off.
const _FREE := {
	velocity = [300, 400],
	spin = 5.0,
	along = [100, 0],
	friction = 0.25,
	bounciness = 1.0,
	radius = 20.0,
	gravity = 0.0,
	two_balls = false,
	has_friction = false,
	mistake = 0
}
const CASES: Array[Dictionary] = [
	{
		id = &"collision_friction",
		state = _STICKS,
		step = [4],
		verdict_sign = ["✗", "≠"],
		verdict =
		[
			[
				"the surfaces stick",
				"v′ = (200, −400), ω′ = 10",
				"the mistake: v′ = (225, −400), ω′ = 0"
			],
			["the surfaces slip on"],
			["no friction"],
			["v′ = (200, −400), ω′ = −10"],
			["v′ = (210, −400), ω′ = 10"],
			["v₁′ = (200, −400), ω₁′ = 10"],
			["the mistake: v′ = (200, −400), ω′ = 10"],
			["the mistake changes nothing here"],
			["something new"],
		],
		sentence =
		[
			"J changes the flight, and its part jt turns the ball, too.",
			"Each ball takes half of J. Friction turns both the same way round.",
			"Nothing acts along t: neither the speed there nor a spin changes.",
			"something new",
		],
		rows =
		[
			[["v′", "(200, −400)", "0"], ["ω′", "10", "0"]],
			[["v′", "(201, −400)", "0"]],
			[["v′", "(200, −400)", "0.1"]],
			[["ω′", "9", "0"]],
			[["P, flown", "(60, −140)", "0"]],
		],
		labels =
		[["v", "u", "jn", "J", "µ = 0.25", "v′", "✗"], ["µ = 0.3"], ["v₁"], ["r ω"], ["something"]],
	},
	{
		id = &"collision_friction",
		state = _STICKS,
		step = [3],
		verdict_sign = ["=", "✗"],
		verdict =
		[["the surfaces stick", "one µ, for sticking and slipping"], ["v′ = (200, −400), ω′ = 10"]],
		sentence =
		[
			"J is in the cone: a third of the slip is enough, and the surfaces stick. Drag its edge.",
			"J is on the edge of the cone: friction is all of µ jn, and they slip on. Drag the edge.",
			"Without friction the cone is a line: the impulse J is along n.",
			"Nothing rubs, so J is along n, in the middle of the cone.",
		],
		labels = [["v", "u", "jn", "J", "µ = 0.25"], ["v′"], ["✗"]],
		rows = [[], [["v′", "(200, −400)", "0"]]],
	},
	{
		id = &"collision_friction",
		state = _STICKS,
		step = [5],
		verdict_sign = ["✗", "≠"],
		verdict =
		[
			[
				"E: 15000 of 125000 is lost",
				"L = 6000, before and after",
				"the mistake makes L = 4500"
			],
			["E: 14000 of 125000 is lost"],
			["E: 15000 of 110000 is lost"],
			["E = 125000, before and after"],
			["L = 4000, before and after"],
			["the mistake makes L = 6000"],
			["the surfaces stick"],
		],
		sentence =
		[
			"About the contact no force has a lever: the angular momentum L of flight and spin is kept.",
			"Nothing is lost here: energy and angular momentum L are kept.",
			"Friction moves angular momentum from the flight into both spins. The sum L is kept.",
		],
	},
	{
		id = &"collision_friction",
		state = _SLIPS,
		step = [6],
		verdict_sign = ["≠", "="],
		verdict =
		[
			["touches: slips, sticks, sticks", "miss 0 px; ε × condition 9e−14 px"],
			["touches: sticks, sticks"],
			["miss 0.1 px; ε × condition 9e−14 px"],
			["miss 0 px; ε × condition 1 px"],
			["miss 0 px; ε × condition 0 px"],
			["the surfaces slip on"],
		],
		sentence =
		[
			"Press Play: it hops, and friction acts at each touch, always with the same µ.",
			"Press Play: the event world flies it. ε × condition is how far rounding may move it.",
		],
		rows =
		[
			[["P, flown", "(68.4, −75.5)", "0"]],
			[["P, flown", "(68.4, −75.5)", "0.1"]],
			[["P, flown", "(68.4, −65.5)", "0"]],
		],
		labels = [["v", "v′", "J", "µ = 0.1"], ["u"], ["jn"], ["µ = 0.2"]],
	},
	{
		id = &"collision_friction",
		state = _TWO,
		step = [4],
		verdict_sign = ["✗", "≠"],
		verdict =
		[
			[
				"the surfaces stick",
				"v₁′ = (75, −100), ω₁′ = 2.5",
				"v₂′ = (175, 100), ω₂′ = 2.5",
				"the mistake: v₂′ = (160, 120), ω₂′ = 0"
			],
			["v₁′ = (90, −120), ω₁′ = 2.5"],
			["v₂′ = (160, 120), ω₂′ = 2.5"],
			["v₂′ = (175, 100), ω₂′ = −2.5"],
			["the mistake: v₂′ = (175, 100), ω₂′ = 0"],
		],
		sentence =
		[
			"Each ball takes half of J. Friction turns both the same way round.",
			"J changes the flight, and its part jt turns the ball, too.",
		],
		rows = [[["v₂′", "(175, 100)", "0"], ["ω₂′", "2.5", "0"]], [["v₂′", "(75, −100)", "0"]]],
		labels = [["v₁", "u", "jn", "J", "µ = 0.2", "v₁′", "v₂′", "✗"], ["v"], ["v′"]],
	},
	{
		id = &"collision_friction",
		state = _TWO,
		step = [5],
		verdict =
		[
			[
				"E: 1875 of 31250 is lost",
				"L = 3000, before and after",
				"the mistake makes L = 3000"
			],
			["L = 2000, before and after"],
		],
		sentence =
		[
			"Friction moves angular momentum from the flight into both spins. The sum L is kept.",
			"About the contact no force has a lever: the angular momentum L of flight and spin is kept.",
		],
	},
	{
		id = &"collision_friction",
		state = _FREE,
		step = [4],
		verdict_sign = ["≠", "="],
		verdict =
		[
			["no friction", "v′ = (300, −400), ω′ = 5"],
			["the surfaces slip on"],
			["the surfaces stick"]
		],
		sentence =
		[
			"Nothing acts along t: neither the speed there nor a spin changes.",
			"J changes the flight, and its part jt turns the ball, too.",
		],
		labels = [["v", "r ω", "u", "jn", "J", "µ = 0", "v′"], ["µ = 0.25"]],
	},
	{
		id = &"collision_friction",
		state = _FREE,
		step = [5],
		verdict =
		[
			["E = 127500, before and after", "L = 7000, before and after"],
			["E: 0 of 127500 is lost"]
		],
		sentence =
		[
			"Nothing is lost here: energy and angular momentum L are kept.",
			"About the contact no force has a lever: the angular momentum L of flight and spin is kept.",
		],
	},
	{
		id = &"collision_friction",
		state = _FREE,
		step = [1],
		verdict = [[], ["no friction"]],
		sentence =
		[
			"The surfaces rub along each other with the slip u: the flight along t less the rim, r ω.",
			"The rim is as fast as the flight: nothing rubs, the slip u is 0.",
			"Along n friction changes nothing: the push jn is that of every bounce.",
		],
		labels = [["v", "r ω", "u"], ["jn"]],
	},
]
