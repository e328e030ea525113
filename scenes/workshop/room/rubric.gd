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
		RubricLine.new(_SUFFICIENT, LabText.translate("Vectors: the unit normal"), "normals", [2]),
		RubricLine.new(
			_SUFFICIENT, LabText.translate("Vectors: the dot product"), "dot_product", [3]
		),
		RubricLine.new(
			_SUFFICIENT,
			LabText.translate("Collisions: reflection with bounciness"),
			"reflection",
			[9]
		),
	]


static func _good() -> Array[RubricLine]:
	return [
		RubricLine.new(
			_GOOD, LabText.translate("Vectors: scalar and vector projection"), "dot_product", [4]
		),
		RubricLine.new(
			_GOOD,
			LabText.translate("Collisions: how far a ball is from a line, and whether it touches"),
			"line_distance",
			[5, 6]
		),
		RubricLine.new(
			_GOOD,
			LabText.translate("Collisions: position reset and point of impact"),
			"point_of_impact",
			[7, 8]
		),
		RubricLine.new(
			_GOOD,
			LabText.translate("Collisions: a ball among many angled lines, with gravity"),
			"angled_lines",
			[10]
		),
		RubricLine.new(
			_GOOD,
			LabText.translate("Vectors: your own tests find four of five mistakes"),
			"",
			_NO_EXERCISES,
			RubricLine.Proof.TESTS
		),
	]


static func _excellent() -> Array[RubricLine]:
	return [
		RubricLine.new(
			_EXCELLENT,
			LabText.translate("Collisions: lines that end, with round caps"),
			"line_ends",
			[11]
		),
		RubricLine.new(
			_EXCELLENT,
			LabText.translate("Vectors: reflect knows a normal that is not unit"),
			"reflection",
			[9],
			RubricLine.Proof.EXCELLENT
		),
		RubricLine.new(
			_EXCELLENT,
			LabText.translate("Vectors: every method tested, so that no mistake is missed"),
			"",
			_NO_EXERCISES,
			RubricLine.Proof.ALL_TESTS
		),
		RubricLine.new(
			_EXCELLENT,
			LabText.translate("Vectors: efficient; the run time never lowers a mark"),
			"error_and_time",
			_NO_EXERCISES,
			RubricLine.Proof.RUN_TIME
		),
	]


# What the rubric asks for beyond the exercises.
static func _in_own_project() -> Array[RubricLine]:
	return [
		_of_own_project(LabText.translate("Vectors: useful extras"), "more_dimensions"),
		_of_own_project(
			LabText.translate("Aiming: at a target, ahead of a moving one, with gravity"),
			"dot_product"
		),
		_of_own_project(
			LabText.translate("Collisions: several moving objects, sliding, rolling, friction"),
			"angled_lines"
		),
	]


static func _of_own_project(text: String, lesson: String) -> RubricLine:
	return RubricLine.new(_EXCELLENT, text, lesson, _NO_EXERCISES, RubricLine.Proof.OWN_PROJECT)
