extends RefCounted
## What the lesson dot_product may say of a state, and what is false.
## `test_judges.gd` says how to read it.

const CASES: Array[Dictionary] = [
	{
		id = &"dot_product",
		state = {a = [-5, 2], b = [8, -6], is_swapped = false, normalizes = true},
		step = [4],
		verdict_sign = ["−", "+", "0", "✗"],
		verdict =
		[
			["Scalar projection −5.2", "negative: the angle is above 90°"],
			["Scalar projection −5.3", "negative: the angle is above 90°"],
			["Scalar projection −5.2", "positive: the angle is below 90°"],
			["Scalar projection −5.2", "zero: the angle is 90°"],
			["No projection", "b is zero: it has no direction"],
			["Scalar projection −5.2", "something new"],
		],
		sentence =
		[
			"What is left of a, the rest a − p, is perpendicular to b.",
			"What is left of b, the rest b − p, is perpendicular to a.",
			"b is zero: it has no direction, and no shadow falls on it.",
			"Nothing is left of a here: the rest a − p is zero.",
		],
		labels = [["a", "b\u0302", "p", "a − p"], ["b − p"], ["â"], ["α = "], ["q"]],
		rows = [[], [["by atan2 and cos", "−5.2", "8e−16"]]],
		notice = ["", "something"],
	},
	{
		id = &"dot_product",
		state = {a = [-5, 2], b = [8, -6], is_swapped = false, normalizes = true},
		step = [8, 1],
		verdict_sign = ["−"],
		verdict = [["Scalar projection −5.2", "negative: the angle is above 90°"], []],
		sentence =
		[
			"The primitive way: both angles by atan2, their difference, its cosine, times |a|.",
			"The scalar projection is |a| cos φ, so a · b is |a| |b| cos φ. Of unit vectors it is cos φ.",
		],
		rows = [[["by atan2 and cos", "−5.2", "8e−16"]], [["by atan2 and cos", "−5", "8e−16"]]],
		labels = [["α = ", "β = ", "φ = "], ["a − p"]],
	},
	{
		id = &"dot_product",
		state = {a = [-5, 2], b = [8, -6], is_swapped = false, normalizes = true},
		step = [5],
		verdict_sign = ["−"],
		sentence =
		[
			"Be sure of it. Try: drag a. Measure p, as here. Prove it: see “Proof of the projection”.",
			"Try, measure or prove: each of the three finds the mistake. Measured, p has a wrong length.",
		],
		verdict = [["Scalar projection −5.2", "negative: the angle is above 90°"]],
		labels = [["a", "b", "|p| = 5.2"], ["|p| = 5.3"], ["q"]],
	},
	{
		id = &"dot_product",
		state = {a = [-5, 2], b = [8, -6], is_swapped = false, normalizes = true},
		step = [6],
		verdict_sign = ["−"],
		sentence =
		[
			"a · b\u0302 is not b · â: the same dot product, divided by another length.",
			"a · b\u0302 is not b · â. Here the shadow q is a itself, by chance: drag a.",
			"Both shadows are equally long here, because a and b are.",
			"At a right angle both shadows are zero: drag a away from it.",
			"Without dividing, both are a · b: one number for two shadows.",
		],
		verdict = [["Scalar projection −5.2", "negative: the angle is above 90°"]],
		labels = [["a", "b", "p", "q"], ["|p| = 5.2"]],
	},
	{
		id = &"dot_product",
		state = {a = [7, 1], b = [0, 0], is_swapped = false, normalizes = true},
		step = [8],
		verdict_sign = ["0", "+"],
		verdict =
		[
			["No projection", "b is zero: it has no direction"],
			["Scalar projection 0", "zero: the angle is 90°"],
		],
		sentence = ["b is zero: it has no direction, and no shadow falls on it."],
		rows = [[], [["by atan2 and cos", "0", "0"]]],
		labels = [["a", "b"], ["p"], ["α = "]],
	},
	{
		id = &"dot_product",
		state = {a = [7, 1], b = [1.00001, 0], is_swapped = false, normalizes = false},
		step = [3],
		verdict_sign = ["✗"],
		verdict =
		[
			["Scalar projection 7", "wrong: |b| = 1.00001 times the right one"],
			["Scalar projection 7", "wrong: |b| = 1 times the right one"],
		],
		sentence = ["That times b is |b|² times the shadow: the length comes in twice."],
	},
	{
		id = &"dot_product",
		state = {a = [7, 1], b = [0, 0.5], is_swapped = false, normalizes = false},
		step = [4],
		verdict_sign = ["✗", "+"],
		verdict =
		[
			["Scalar projection 0.5", "wrong: |b| = 0.5 times the right one"],
			["Scalar projection 0.5", "wrong: |b| = 2 times the right one"],
			["Scalar projection 1", "wrong: |b| = 0.5 times the right one"],
		],
		sentence =
		[
			"The rest a − p is not perpendicular to b: that is how a test finds the mistake.",
			"With these numbers the mistake changes nothing: a test needs others.",
		],
	},
]
