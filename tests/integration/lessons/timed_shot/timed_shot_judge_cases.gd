extends RefCounted
## What the judge of the lesson timed_shot has to tell apart, for test_judges.gd.

const CASES: Array[Dictionary] = [
	{
		id = &"timed_shot",
		state =
		{
			kind = 0,
			muzzle = [0, 100],
			bullet = [0, -200],
			target = [-300, -100],
			velocity = [100, 0],
			centre = [0, -50],
			circling = 90.0,
			turning = 45.0,
			radius = 10.0,
			fire = 1.0,
			mistake = 101,
		},
		step = [2, 3, 0],
		verdict_sign = ["✗", "0"],
		verdict =
		[
			["fire after 2 s", "it hits after 3 s", "fired after 3 s it misses by 89.4 px"],
			["fire after 3 s", "it hits after 3 s", "fired after 3 s it misses by 89.4 px"],
			["fire after 2 s", "it hits after 2 s", "fired after 3 s it misses by 89.4 px"],
			["fire after 2 s", "it hits after 3 s", "fired after 4 s it misses by 89.4 px"],
			["fire after 2 s", "it hits after 3 s", "fired after 3 s it misses by 100 px"],
			["the target rests: the moment does not matter"],
			["too late: the target has passed before a bullet comes"],
			["something new"],
		],
		sentence =
		[
			"Fire f before the target is in X: the bullet has to fly there first.",
			"No moment hits. The card says why.",
			"Fire when the barrel points to where they meet, not when it points to the target.",
			"The bullet does not cross the circle.",
		],
		rows =
		[
			[["fire", "2", "0", "9 ns"], ["flight f", "1", "0", "9 ns"]],
			[["fire", "3", "0", "9 ns"], ["flight f", "1", "0", "9 ns"]],
			[["fire", "2", "0.1", "9 ns"], ["flight f", "1", "0", "9 ns"]],
			[["fire", "none", "", "9 ns"]],
		],
		labels = [["T", "W", "V", "X", "fire", "89.4 px off"], ["T", "W", "s"], ["something new"]],
	},
	{
		id = &"timed_shot",
		state =
		{
			kind = 0,
			muzzle = [0, 100],
			bullet = [0, -200],
			target = [-300, -100],
			velocity = [100, 0],
			centre = [0, -50],
			circling = 90.0,
			turning = 45.0,
			radius = 10.0,
			fire = 1.0,
			mistake = 103,
		},
		step = [3, 4],
		verdict_sign = ["✗", "0"],
		verdict =
		[
			[
				"hits from 1.888 s to 2.112 s",
				"your shot at 1 s misses by 89.4 px",
				"the mistake says ± 0.1 s"
			],
			[
				"hits from 1.9 s to 2.1 s",
				"your shot at 1 s misses by 89.4 px",
				"the mistake says ± 0.1 s"
			],
			["hits from 1.888 s to 2.112 s", "your shot at 1 s hits", "the mistake says ± 0.1 s"],
			[
				"hits from 1.888 s to 2.112 s",
				"your shot at 1 s misses by 89.4 px",
				"the mistake says ± 0.2 s"
			],
		],
		sentence =
		[
			"With R, the radii of both together, each moment in the colored window hits.",
			"No moment hits, so there is no window.",
		],
	},
	{
		id = &"timed_shot",
		state =
		{
			kind = 0,
			muzzle = [0, 100],
			bullet = [0, -200],
			target = [-300, -100],
			velocity = [100, 0],
			centre = [0, -50],
			circling = 90.0,
			turning = 45.0,
			radius = 10.0,
			fire = 1.0,
			mistake = 0,
		},
		step = [4, 3],
		verdict_sign = ["!", "0", "✗"],
		verdict =
		[
			["miss 0 px; ε × condition 3.4e−13 px"],
			["miss 1e−10 px; ε × condition 3.4e−13 px"],
			["miss 0 px; ε × condition 1e−10 px"],
		],
		sentence =
		[
			"Fire: press Play. It hits; what is left is rounding.",
			"Fire: press Play. What the mistake does is dashed.",
			"No moment hits, and nothing is fired.",
		],
	},
	{
		id = &"timed_shot",
		state =
		{
			kind = 1,
			muzzle = [0, 150],
			bullet = [0, -200],
			target = [100, -50],
			velocity = [100, 0],
			centre = [0, -50],
			circling = 90.0,
			turning = 45.0,
			radius = 10.0,
			fire = 1.0,
			mistake = 0,
		},
		step = [2, 1],
		verdict_sign = ["!", "0"],
		verdict =
		[
			["fire after 0.5 s", "it hits after 1 s"],
			["fire after 1 s", "it hits after 1 s"],
			["fire after 0.5 s", "it hits after 1.5 s"],
			["the bullet must be faster than the target"],
		],
		sentence = ["Fire f before the target is in X: the bullet has to fly there first."],
		labels = [["T", "W", "X", "fire"], ["T", "W", "V", "X", "fire"]],
	},
]
