class_name Rubric
extends RefCounted
## The lines of the course's rubric, and what in the lab shows each. The run time never lowers a
## mark.

const _SUFFICIENT := WorkshopReport.Mark.SUFFICIENT
const _GOOD := WorkshopReport.Mark.GOOD
const _EXCELLENT := WorkshopReport.Mark.EXCELLENT
const _NO_EXERCISES: PackedInt32Array = []


## All lines, those of a mark together, in the order of the marks.
static func lines() -> Array[RubricLine]:
	var all := _sufficient()
	all.append_array(_good())
	all.append_array(_excellent())
	all.append_array(_in_own_project())
	return all


static func _sufficient() -> Array[RubricLine]:
	return [
		(
			RubricLine
			. new(_SUFFICIENT, LabText.translate("Vectors: the unit normal"), "normals", [2])
			. tested_by(["tests/unit/test_vec2_projection.gd"])
		),
		(
			RubricLine
			. new(_SUFFICIENT, LabText.translate("Vectors: the dot product"), "dot_product", [3])
			. tested_by(["tests/unit/test_vec2_projection.gd"])
		),
		(
			RubricLine
			. new(
				_SUFFICIENT,
				LabText.translate("Collisions: reflection with bounciness"),
				"reflection",
				[9]
			)
			. tested_by(["tests/unit/test_vec2_reflection.gd"])
		),
	]


static func _good() -> Array[RubricLine]:
	var distance := LabText.translate(
		"Collisions: how far a ball is from a line, and whether it touches"
	)
	var impact := LabText.translate("Collisions: position reset and point of impact")
	var many := LabText.translate("Collisions: a ball among many angled lines, with gravity")
	var tests := LabText.translate("Vectors: your own tests find four of five mistakes")
	return [
		(
			RubricLine
			. new(
				_GOOD,
				LabText.translate("Vectors: scalar and vector projection"),
				"dot_product",
				[4]
			)
			. tested_by(["tests/unit/test_vec2_projection.gd"])
		),
		RubricLine.new(_GOOD, distance, "line_distance", [5, 6]).tested_by(
			["tests/unit/collision/test_line_distance.gd"]
		),
		(
			RubricLine
			. new(_GOOD, impact, "point_of_impact", [7, 8])
			. tested_by(
				[
					"tests/unit/collision/test_position_reset.gd",
					"tests/unit/collision/test_point_of_impact.gd",
				]
			)
		),
		RubricLine.new(_GOOD, many, "angled_lines", [10]).tested_by(
			["tests/unit/world/event/test_event_world.gd"]
		),
		RubricLine.new(_GOOD, tests, "", _NO_EXERCISES, RubricLine.Proof.TESTS).tested_by(
			["tests/integration/workshop/test_tests_of_students.gd"]
		),
	]


static func _excellent() -> Array[RubricLine]:
	var ends := LabText.translate("Collisions: lines that end, with round caps")
	var normal := LabText.translate("Vectors: reflect knows a normal that is not unit")
	var all := LabText.translate("Vectors: every method tested, so that no mistake is missed")
	var run_time := LabText.translate("Vectors: efficient; the run time never lowers a mark")
	return [
		(
			RubricLine
			. new(_EXCELLENT, ends, "line_ends", [11])
			. tested_by(
				[
					"tests/unit/collision/test_segment_impact.gd",
					"tests/unit/collision/test_cap_impact.gd",
				]
			)
		),
		_aiming(LabText.translate("Aiming: ahead of a target that moves"), 13, "lead"),
		_aiming(
			LabText.translate("Aiming: under gravity, by the flat and the high arc"),
			14,
			"ballistic"
		),
		_aiming(LabText.translate("Aiming: over one line, and over two"), 15, "bank"),
		RubricLine.new(_EXCELLENT, normal, "reflection", [9], RubricLine.Proof.EXCELLENT).tested_by(
			["tests/unit/test_vec2_reflection.gd"]
		),
		RubricLine.new(_EXCELLENT, all, "", _NO_EXERCISES, RubricLine.Proof.ALL_TESTS).tested_by(
			[
				"tests/unit/test_vec2_student_mistakes.gd",
				"tests/unit/workshop/kit/test_wrong_ways.gd"
			]
		),
		(
			RubricLine
			. new(_EXCELLENT, run_time, "error_and_time", _NO_EXERCISES, RubricLine.Proof.RUN_TIME)
			. tested_by(["tests/integration/test_report.gd"])
		),
	]


# The lesson is that of the exercise; [param kind] is in the name of the test.
static func _aiming(text: String, exercise: int, kind: String) -> RubricLine:
	var lesson := WorkshopIndex.exercise(exercise).lesson
	return RubricLine.new(_EXCELLENT, text, lesson, [exercise]).tested_by(
		["tests/unit/aiming/test_%s_aim.gd" % kind]
	)


# What the rubric asks for beyond the exercises.
static func _in_own_project() -> Array[RubricLine]:
	return [
		_of_own_project(LabText.translate("Vectors: useful extras"), "more_dimensions").tested_by(
			["tests/unit/test_vec2_movement.gd", "tests/unit/test_vec2_angles.gd"]
		),
		(
			_of_own_project(
				LabText.translate("Aiming: in a direction, at a target, at the right moment"),
				"dot_product"
			)
			. tested_by(
				[
					"tests/unit/aiming/test_turn.gd",
					"tests/unit/aiming/test_timed_aim.gd",
				]
			)
		),
		(
			_of_own_project(
				LabText.translate("Collisions: several moving objects, sliding, rolling, friction"),
				"angled_lines"
			)
			. tested_by(
				[
					"tests/unit/collision/test_ball_bounce.gd",
					"tests/unit/world/event/test_ball_piles.gd",
				]
			)
		),
	]


static func _of_own_project(text: String, lesson: String) -> RubricLine:
	return RubricLine.new(_EXCELLENT, text, lesson, _NO_EXERCISES, RubricLine.Proof.OWN_PROJECT)
