class_name MeasuredTexts
extends RefCounted
## The names of the measured problems, methods and settings, translated. Tables and files have the
## names themselves, in English.
##
## A name is looked up without its numbers: `240 steps a second` as `%s steps a second`.

# Titles of the problems by their id: source text.
const _TITLES: Dictionary[StringName, String] = {
	&"scalar_projection": "Scalar projection",
	&"ball_in_box": "One ball in a box",
	&"angled_lines": "Among angled lines",
	&"many_segments": "Many segments",
	&"dropped_ball": "A dropped ball",
	&"many_balls": "Many balls",
	&"digits_of_pi": "Digits of pi",
}

# The axes of all problems: source text.
const _AXES: PackedStringArray = [
	"run time, µs per call",
	"run time, µs per simulated second",
	"worst error / |a|",
	"error, px",
	"%s / bounces until %s px off",
	"error of the height, px",
	"worst overlap of two balls, px",
	"run time, µs for all impacts",
	"impacts too few or too many",
]

# What the lesson calls a method whose name in tables is too short to be understood: source text.
const _IN_FULL: Dictionary[StringName, String] = {
	&"event world, one call": "event world, one jump to the end",
	&"dot product": "dot product in GDScript, 64 bits",
	&"Vector2": "dot product of Vector2, 32 bits",
}

# Situations, methods and what they are set to: source text.
const _NAMES: PackedStringArray = [
	"up to %s px",
	"nearly perpendicular",
	"%s to %s px",
	"atan2 and cos",
	"dot product in GDScript, %s bits",
	"dot product of Vector2, %s bits",
	"share of |a|",
	"%s px/s, %s s",
	"%s Hz",
	"position reset",
	"impact, rest dropped",
	"impact, rest used",
	"event world",
	"event world, walls as segments",
	"event world, grid",
	"event world, scan",
	"event world, flights followed",
	"event world, one jump to the end",
	"one call",
	"%s segments",
	"%s balls",
	"explicit Euler",
	"semi-implicit Euler",
	"velocity Verlet",
	"penalty spring, %s Hz",
	"from impact to impact",
	"stepped",
	"impacts",
	"move_and_collide, segments",
	"move_and_collide, concave shape",
	"body_test_motion, segments",
	"body_test_motion, concave shape",
	"RigidBody2D",
	"RigidBody2D, CCD ray",
]

# What is said beside a measurement: source text.
const _NOTES: PackedStringArray = [
	"the ball has left the box",
	"%s px off after %s bounces, %s s",
	"after %s bounces",
	"never %s px off in %s bounces, %s s",
	"never %s px off in %s bounce, %s s",
	"%s px off after %s bounce, %s s",
	"energy off by %s of itself",
	"reversed, never %s px off its own way in all of %s s",
	"reversed, %s px off its own way after %s s of %s s",
	"%s collisions a second",
	"no finite answer for %s of %s pairs",
	"not flown to the end yet",
	"height %s px, energy %s of the start's",
	"height -%s px, energy -%s of the start's",
	"blown up: more than %s times the energy of the start",
	"%s impacts, %s are right",
]

# Not a digit within a word, such as that of atan2.
const _NUMBER := "(?<![\\w.])\\d+(?:[.,]\\d+)*(?:e-?\\d+)?"


## The title of the problem with this id; the id itself for one that has none here.
static func title(id: String) -> String:
	var known: String = _TITLES.get(StringName(id), id)
	return TranslationServer.translate(known)


## The titles of [param problems], in their order.
static func titles(problems: Array[ReportProblem]) -> PackedStringArray:
	return problems.map(func(problem: ReportProblem) -> String: return title(problem.id))


## Each of [param names] as [method of] has it.
static func all_of(names: PackedStringArray) -> PackedStringArray:
	return Array(names).map(of)


## A name in the reader's language, with its numbers. What lies between semicolons is looked up
## alone.
static func of(name_in_table: String) -> String:
	return "; ".join(Array(name_in_table.split("; ")).map(_part_of))


static func _part_of(name_in_table: String) -> String:
	var numbers: Array[String] = []
	for hit in RegEx.create_from_string(_NUMBER).search_all(_in_full(name_in_table)):
		numbers.append(hit.get_string())
	var translated: String = TranslationServer.translate(pattern(name_in_table))
	return translated % numbers


## What is looked up for a name: %s for each number, %% for a percent sign.
static func pattern(name_in_table: String) -> String:
	var plain := _in_full(name_in_table).replace("%", "%%")
	return RegEx.create_from_string(_NUMBER).sub(plain, "%s", true)


static func _in_full(name_in_table: String) -> String:
	return _IN_FULL.get(StringName(name_in_table), name_in_table)
