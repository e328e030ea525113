extends RefCounted
## What the lesson on balls among angled lines may say of a state, and what is false, for
## `test_judges.gd`, which says how to read it.

const CASES: Array[Dictionary] = [
	{
		# It falls by 140 px in 57.966 frames: v₁ = (40, √(2 · 300 · 140)).
		id = &"angled_lines",
		state =
		{
			balls = [[0, -50, 40, 0, 10]],
			lines = [[-200, 100, 200, 100]],
			gravity = [0, 300],
			bounciness = 1.0,
			method = "whole_frame",
			mistake = 0,
			selected = 0,
		},
		step = [1, 0, 2],
		sentence =
		[
			"The dots show its path. At the ring the ball touches a line: v₁ turns into v₂.",
			"The dots show its path in the next 1.5 s: no bounce.",
			"The ball is lost: it has left the board.",
			"At the ring something new.",
		],
		lines =
		[
			[
				"g = ( 0 , 300 )    C = 1",
				"P = ( 0 , -50 )   v = ( 40 , 0 )",
				"v₂ = v₁ − (1 + C) (v₁ · n̂) n̂",
				"v₂ = (40, 289.8) − 2 · (−289.8) (0, −1) = (40, −289.8)"
			],
			[
				"g = ( 0 , 200 )    C = 1",
				"P = ( 0 , -50 )   v = ( 40 , 0 )",
				"v₂ = v₁ − (1 + C) (v₁ · n̂) n̂",
				"v₂ = (40, 289.8) − 2 · (−289.8) (0, −1) = (40, −289.8)"
			],
			[
				"g = ( 0 , 300 )    C = 0.5",
				"P = ( 0 , -50 )   v = ( 40 , 0 )",
				"v₂ = v₁ − (1 + C) (v₁ · n̂) n̂",
				"v₂ = (40, 289.8) − 2 · (−289.8) (0, −1) = (40, −289.8)"
			],
			[
				"g = ( 0 , 300 )    C = 1",
				"P = ( 0 , 50 )   v = ( 40 , 0 )",
				"v₂ = v₁ − (1 + C) (v₁ · n̂) n̂",
				"v₂ = (40, 289.8) − 2 · (−289.8) (0, −1) = (40, −289.8)"
			],
			[
				"g = ( 0 , 300 )    C = 1",
				"P = ( 0 , -50 )   v = ( 0 , 40 )",
				"v₂ = v₁ − (1 + C) (v₁ · n̂) n̂",
				"v₂ = (40, 289.8) − 2 · (−289.8) (0, −1) = (40, −289.8)"
			],
			["g = ( 0 , 300 )    C = 1", "P = ( 0 , -50 )   v = ( 40 , 0 )"],
			[
				"g = ( 0 , 300 )    C = 1",
				"P = ( 0 , -50 )   v = ( 40 , 0 )",
				"v₂ = v₁ − (1 + C) (v₁ · n̂) n̂",
				"v₂ = (40, 270) − 2 · (−270) (0, −1) = (40, −270)"
			],
			[
				"g = ( 0 , 300 )    C = 1",
				"P = ( 0 , -50 )   v = ( 40 , 0 )",
				"v₂ = v₁ − (1 + C) (v₁ · n̂) n̂",
				"v₂ = (40, 289.8) − 1 · (−289.8) (0, −1) = (40, 0)"
			],
			[
				"g = ( 0 , 300 )    C = 1",
				"P = ( 0 , -50 )   v = ( 40 , 0 )",
				"v₂ = v₁ − (1 + C) (v₁ · n̂) n̂",
				"v₂ = (40, 289.8) − 2 · 289.8 (0, 1) = (40, −289.8)"
			],
		],
		labels =
		[
			[
				"A",
				"v",
				"g",
				"n̂",
				"t = 0.965",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n̂",
				"t = 0.95",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n̂",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
			[
				"B",
				"v",
				"g",
				"n̂",
				"t = 0.965",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n̂",
				"t = 0.965",
				"something new",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n̂",
				"t = 0.965",
				"Frame 0, 0.00 s    bounces 0    lost 1\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n̂",
				"t = 0.965",
				"Frame 0, 0.00 s    bounces 1    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n̂",
				"t = 0.965",
				"Frame 0, 1.00 s    bounces 0    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n̂",
				"t = 0.965",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 0.9    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n̂",
				"t = 0.965",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1 > 1    script 0.02 of 16.67 ms"
			],
			[
				"A",
				"v",
				"g",
				"n̂",
				"t = 0.965",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1, mistake: 1    script 0.02 of 16.67 ms"
			],
		],
		notice = ["", "Something new."],
	},
	{
		id = &"angled_lines",
		state =
		{
			balls = [[0, -50, 40, 0, 10]],
			lines = [[-200, 140, 200, 140]],
			gravity = [0, 300],
			bounciness = 1.0,
			method = "event_world",
			mistake = 0,
			selected = 0,
		},
		step = [2, 1],
		sentence = ["The same minute, stepped in four ways.", "Drag on the board to draw a line."],
		lines = [["g = ( 0 , 300 )    C = 1", "P = ( 0 , -50 )   v = ( 40 , 0 )"]],
		labels =
		[
			[
				"A",
				"v",
				"g",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			]
		],
		rows =
		[
			[
				["position reset", "1.039 > 1", "0.039", "115 µs"],
				["rest dropped", "0.9124", "0.088", "68 µs"],
				["rest used", "1", "2.2e−15", "35 µs"],
				["event world", "1 lost", "–", "404 µs"]
			],
			[["position reset", "1.039", "0.039", "115 µs"]],
			[["position reset", "1.039 > 1", "0.088", "115 µs"]],
			[["position reset", "0.9124 > 1", "0.088", "115 µs"]],
			[["position reset", "1 lost", "1", "115 µs"]],
			[["rest used", "1", "0", "35 µs"]],
			[],
			[
				["position reset", "1", "0", "115 µs"],
				["rest dropped", "1", "0", "68 µs"],
				["rest used", "0.99", "0.01", "35 µs"]
			],
		],
	},
	{
		id = &"angled_lines",
		state =
		{
			balls = [[0, -50, 40, 0, 10]],
			lines = [[200, 140, -200, 140]],
			gravity = [0, 300],
			bounciness = 1.0,
			method = "position_reset",
			endless = true,
			mistake = 0,
			selected = 0,
		},
		step = [0],
		sentence =
		[
			"Week 4: lines are endless and work on the side to which n̂ points.",
			"Drag on the board to draw a line.",
			"A ball behind a line is put before it. Next time: lines end, and have two sides.",
		],
		lines = [["g = ( 0 , 300 )    C = 1", "P = ( 0 , -50 )   v = ( 40 , 0 )"]],
		labels =
		[
			[
				"A",
				"v",
				"g",
				"Frame 0, 0.00 s    bounces 0    lost 0\nE / E₀ = 1    script 0.02 of 16.67 ms"
			],
		],
	},
]
