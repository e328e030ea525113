class_name LessonWords
extends RefCounted
## The words in the formula of each lesson, for [FormulaReader].

const _WORDS: Dictionary[StringName, Dictionary] = {
	&"class_or_value": {is_code = true},
	&"easy_bounce":
	{
		words =
		[
			"easy:",
			"right:",
			"tilt",
			"frame",
			"hit",
			"no hit",
			"it just touches",
			"rounding decides",
			"no hit: P stays",
			"no hit: v stays",
			"v · n̂ is not below 0: v stays",
			"vx is not above 0: v stays",
			"vy is not above 0: v stays",
			"floor − y",
			"wall − x",
			"y = floor − r",
			"x = wall − r",
			"r − distance",
		],
	},
	&"normals":
	{
		words = ["from", "divides 0 by 0", "without the test for 0: the same"],
		meanings = {x = "v.x", y = "v.y"}
	},
	&"projection_proof":
	{words = ["on the way:", "signed length of p"], meanings = {"b̂": "b / |b|"}},
	&"line_distance":
	{
		words =
		[
			"line:",
			"to",
			"at",
			"to the segment:",
			"gap",
			"wrong:",
			"y of the line − y of c",
			"a vertical line has no y at the ball's x",
			"speed",
			"px per frame",
			"frame",
			"red",
			"not red",
		],
		not_shown = ["p"],
	},
	&"point_of_impact":
	{
		words =
		[
			"line:",
			"to",
			"wrong:",
			"not needed",
			"none",
			"any t",
			"reset",
			"reset:",
			"POI:",
			"t:",
			"none, b is 0",
			"divides by 0",
			"old distance",
			"new distance",
		],
		not_shown = ["n̂"],
	},
	&"reflection": {words = ["is not 1: refused.", "stays", "mistake:"]},
	&"line_ends":
	{
		words =
		[
			"t = (−b ± √D) / (2 a)",
			"along the line, no time of impact",
			"it moves away, no impact",
			"the ball does not move. Do not divide by a.",
			"no root. This end is not touched.",
			"the line is met first",
			"moving away: none",
			"it only grazes: none",
			"overlap: t = 0",
			"counts",
			"none",
		],
	},
	&"more_dimensions":
	{
		words =
		[
			"the angle is above 90°",
			"the angle is below 90°",
			"the angle is above π/2",
			"the angle is below π/2",
			"a zero vector makes no angle",
			"a right angle",
		],
	},
	&"aim_at": {words = ["no direction"]},
	&"lead_target":
	{
		words =
		[
			"no root from 0 on",
			"they touch already",
			"a is 0 but for rounding: the hit is very far away",
			"mistake:",
		],
	},
	&"ballistic_aim":
	{
		words = ["mistake:", "w has no root: no t", "no t", "no d", "no direction"],
		not_shown = ["D"],
	},
	&"timed_shot":
	{
		words =
		[
			"mistake:",
			"turn",
			"from T to X:",
			"barrel then:",
			"from S to X:",
			"from",
			"to",
			"no f",
			"no moment",
			"W · n is 0: no f",
			"direction: d = (T + V t − S) / (s t)",
		],
		not_shown = ["n", "X", "f"],
	},
	&"newton_balls": {words = ["mistake:"], not_shown = ["c₁", "c₂"]},
	&"slide_and_roll": {words = ["without friction:"]},
	&"moving_platforms": {words = ["mistake:", "no impact"], not_shown = ["U′", "w"]},
	&"error_and_time":
	{
		words =
		[
			"Point at a mark on a line",
			"to see its order p.",
			"One of the two settings has no answer.",
			"One of the two errors is 0.",
			"Both settings take the same time.",
			"So there is no order p.",
		],
	},
	&"bank_shot": {words = ["wall 1:", "wall 2:", "wall 3:", "wall 4:", "to", "mistake:"]},
}


## Those of the lesson with this id.
static func of(id: StringName) -> FormulaWords:
	var members: Dictionary = _WORDS.get(id, {})
	return FormulaWords.of(members)
