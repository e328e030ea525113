extends RefCounted
## What the lesson class_or_value may say of a state, and what is false.
## `test_judges.gd` says how to read it.

const CASES: Array[Dictionary] = [
	{
		id = &"class_or_value",
		state = {position = [4, -4], old = [2, -3], copies = false},
		step = [3],
		sentence =
		[
			"Why Vec2? It keeps 64 bits of each number, Vector2 only 32.",
			"set_xy changes only the first Vec2. old is a copy and stays, just like old_value.",
			"something new",
		],
		rows =
		[
			[["Vector2, 1000 times", "99.999046", "0.00095", "15 ns"]],
			[["Vector2, 1000 times", "100", "0.00095", "15 ns"]],
			[["Vector2, 1000 times", "99.999046", "0.0095", "15 ns"]],
			[["Vec2, 10 times", "1", "0", "15 ns"]],
		],
		labels =
		[
			["position", "old", "two names, one object", "two names, two values"],
			["two names, two objects"],
			["one name, one object"],
			["new"],
		],
		notice = ["", "cannot be taken"],
	},
]
