extends RefCounted
## What the lesson easy_bounce may say of a state, and what is false.
## `test_judges.gd` says how to read it.

const CASES: Array[Dictionary] = [
	{
		id = &"easy_bounce",
		state = {ball = [0, 4, 20, 48, 60], pivot = [0, 40], tilt_degrees = 30.0, is_wall = false},
		step = [4],
		verdict_sign = ["✗", "✓", "=", "?"],
		verdict =
		[
			["Frame 1:", "the easy ball is 61.2 px off"],
			["Frame 0:", "the easy ball is 61.2 px off"],
			["Frame 1:", "the easy ball is 14.4 px off"],
			["Frame 1:", "both balls are in one place"],
			["The easy way is right", "in all three steps"],
			["something new"],
			[],
		],
		sentence =
		[
			"Play it, frame by frame: the easy ball goes astray.",
			"Here both programs do the same. Move the ball, or tilt the line.",
			"Flip: only the part of v along the normal n̂ changes its sign, or y.",
			"something new",
		],
		rows =
		[
			[
				["easy distance", "119.5", "16"],
				["by the normal", "103.5", "0"],
				["easy place", "(20, −68)", "0"],
				["easy velocity", "(20, −48)", "0"],
			],
			[
				["easy distance", "119.5", "16"],
				["by the normal", "103.5", "0"],
				["easy place", "(20, −60)", "0"],
				["easy velocity", "(20, −48)", "0"],
			],
			[
				["easy distance", "119.5", "16"],
				["by the normal", "119.5", "0"],
				["easy place", "(20, −68)", "0"],
				["easy velocity", "(20, −48)", "0"],
			],
			[["easy distance", "119.5", "16"]],
		],
		lines =
		[
			["r = 60     tilt = 30°     frame 1", "easy: 119.5 > r = 60: no hit"],
			["r = 60     tilt = 30°     frame 1", "easy: 36 < r = 60: hit"],
			["r = 60     tilt = 30°     frame 2", "easy: 119.5 > r = 60: no hit"],
		],
		labels = [["right", "easy", "v"], ["before"], ["flipped"], ["new"]],
	},
]
