extends RefCounted
## What the lesson aim_at may say of a state, and what is false.
## `test_judges.gd` says how to read it.

## The start of the lesson, with the mistake that leaves the barrel at 120°.
const _START := {
	hull = [-80, -70],
	hull_degrees = 30.0,
	barrel_degrees = 0.0,
	target = [-80, 110],
	length = 50.0,
	speed = 200.0,
	half_life = 0.2,
	fire = 0.6,
	radius = 10.0,
	mistake = 101
}
## From 135° to −135°: the long way is 270°.
const _OVER := {
	hull = [80, 60],
	hull_degrees = 45.0,
	barrel_degrees = 90.0,
	target = [-50, -70],
	length = 50.0,
	speed = 200.0,
	half_life = 0.2,
	fire = 0.6,
	radius = 10.0,
	mistake = 102
}
## The target is in the hull's place.
const _NO_DIRECTION := {
	hull = [80, 60],
	hull_degrees = 45.0,
	barrel_degrees = 90.0,
	target = [80, 60],
	length = 50.0,
	speed = 200.0,
	half_life = 0.2,
	fire = 0.6,
	radius = 10.0,
	mistake = 0
}
## The target is nearer than the nozzle.
const _NEAR := {
	hull = [0, 0],
	hull_degrees = 0.0,
	barrel_degrees = 0.0,
	target = [20, 20],
	length = 50.0,
	speed = 200.0,
	half_life = 0.2,
	fire = 0.6,
	radius = 10.0,
	mistake = 0
}
const CASES: Array[Dictionary] = [
	{
		id = &"aim_at",
		state = _START,
		step = [6],
		verdict_sign = ["✗", "×"],
		verdict =
		[
			[
				"it hits 0.65 s after the shot",
				"miss 0 px; ε × condition 1.8e−13 px",
				"the mistake misses by 90 px"
			],
			["it hits 0.9 s after the shot"],
			["miss 1 px; ε × condition 1.8e−13 px"],
			["miss 0 px; ε × condition 1.8e−12 px"],
			["the mistake misses by 23.5 px"],
			["the mistake changes nothing here"],
			["the mistake hits all the same"],
			["the target is nearer than the nozzle"],
			["something new"],
		],
		sentence =
		[
			"Aligned, it fires from the nozzle. ε × condition is how far rounding alone may move it.",
			"The target is nearer than the nozzle: the bullet starts behind it.",
			"Without a direction there is nothing to fire at.",
			"something new",
		],
		rows =
		[
			[["d by its angle", "(0, 1)", "6.1e−17"], ["d as a vector", "(0, 1)", "0"]],
			[["d by its angle", "(1, 0)", "6.1e−17"]],
			[["d as a vector", "(0, 1)", "0.1"]],
		],
		labels = [["90 px"], ["23.5 px"], ["α = "], ["v"], ["something new"]],
	},
	{
		id = &"aim_at",
		state = _START,
		step = [5],
		verdict_sign = ["×", "!"],
		verdict =
		[
			["still 7.5° off", "it misses by 23.5 px", "from t = 0.847 s on it hits"],
			["still 15° off"],
			["it misses by 90 px"],
			["from t = 0.5 s on it hits"],
			["from t = 1.2 s on it hits"],
			["it passes within R: it hits"],
		],
		sentence =
		[
			"It fires after t seconds, before the barrel is aligned, and misses.",
			"After t seconds of turning the barrel is near enough: it hits the disc.",
		],
		labels = [["23.5 px"], ["90 px"], ["δ = "]],
	},
	{
		id = &"aim_at",
		state = _START,
		step = [3],
		verdict = [["on the hull: 60°"], ["on the hull: 90°"], ["on the hull: −60°"]],
		sentence =
		[
			"The hull has turned the barrel along by α. What is left for the barrel itself is θ − α.",
			"Without a direction there is no angle for the barrel.",
		],
		labels = [["α = ", "θ = ", "β′ = "], ["β = "], ["δ = "]],
	},
	{
		id = &"aim_at",
		state = _OVER,
		step = [4],
		verdict_sign = ["✗", "×"],
		verdict =
		[
			["the short way: 90° clockwise", "the mistake: 270° counter-clockwise"],
			["the short way: 90° counter-clockwise"],
			["the short way: 270° clockwise"],
			["the mistake: 270° clockwise"],
			["the mistake changes nothing here"],
		],
		sentence =
		[
			"It turns the short way, by δ, and does half of what is left in each h seconds. Press Play.",
			"Nothing has to be turned.",
		],
		labels = [["δ = "], ["α = "], ["90 px"]],
	},
	{
		id = &"aim_at",
		state = _OVER,
		step = [1],
		sentence =
		[
			"A shot that gravity pulls turns its sprite with v: its angle is atan2(vy, vx).",
			"The barrel turns on the hull: it points along γ = α + β. Drag both.",
		],
		rows = [[], [["d as a vector", "(0, 1)", "0"]]],
		verdict = [[], ["on the hull: 60°"]],
		labels = [["v"], ["β = "]],
	},
	{
		id = &"aim_at",
		state = _NO_DIRECTION,
		step = [2],
		sentence =
		[
			"Hull and target are in one place: there is no direction.",
			"The hull sees the target at θ = atan2(y, x) of T − P. Drag the target.",
		],
	},
	{
		id = &"aim_at",
		state = _NEAR,
		step = [6],
		verdict_sign = ["×", "!"],
		verdict =
		[
			["the target is nearer than the nozzle", "the bullet starts behind it"],
			["it hits 0.65 s after the shot"],
			["no direction: hull and target are in one place"],
		],
		sentence =
		[
			"The target is nearer than the nozzle: the bullet starts behind it.",
			"Aligned, it fires from the nozzle. ε × condition is how far rounding alone may move it.",
		],
	},
]
