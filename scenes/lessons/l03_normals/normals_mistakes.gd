class_name NormalsMistakes
extends RefCounted
## The wrong normals found in student code, by their numbers in the course's list. They are only
## shown beside the right ones.

## Components swapped, or the sign on the wrong one.
const WRONG_NORMAL := 9
## Divided by the length without a test for 0.
const ZERO_VECTOR := 6
## The length cut to a whole number before the test for 0.
const CUT_LENGTH := 7


## Mistake 9: components swapped, without a sign. Not perpendicular to v.
static func swapped(v: Vec2) -> Vec2:
	return Vec2.new(v.y, v.x)


## Mistake 9: the sign on the wrong component. Perpendicular, but on the other side.
static func wrong_sign(v: Vec2) -> Vec2:
	return Vec2.new(v.y, -v.x)


## Mistake 6: divided by the length without a test for 0. NaN for a zero v.
static func unit_without_test(v: Vec2) -> Vec2:
	var size := v.length()
	return Vec2.new(-v.y / size, v.x / size)


## Mistake 7: the length cut to a whole number before the test for 0. Zero for a v shorter than 1.
static func unit_with_cut_length(v: Vec2) -> Vec2:
	if int(v.length()) == 0:
		return Vec2.new()
	return v.normal()


## What [param mistake], 6 or 7, makes of the unit normal of [param v]; mistake 6 for any other.
static func wrong_unit(mistake: int, v: Vec2) -> Vec2:
	return unit_with_cut_length(v) if mistake == CUT_LENGTH else unit_without_test(v)


## What the gallery shows.
static func infos() -> Array[MistakeInfo]:
	var script := "test_vec2_student_mistakes."
	return [
		MistakeInfo.new(
			WRONG_NORMAL,
			LabText.translate("signs and order"),
			LabText.translate("(y, x) is no normal, (y, −x) the opposite."),
			script + "test_mistake_9_the_normal_with_the_wrong_sign_or_swapped",
			LabText.translate("The test wants the normal of (3, 1) to point along (−1, 3).")
		),
		MistakeInfo.new(
			ZERO_VECTOR,
			LabText.translate("zero vector"),
			LabText.translate("0 / 0 is NaN. Zero must stay zero."),
			script + "test_mistake_6_a_zero_vector_normalized_to_nan",
			LabText.translate("The test normalizes (0, 0) and wants (0, 0) back.")
		),
		MistakeInfo.new(
			CUT_LENGTH,
			LabText.translate("length cut to an integer"),
			LabText.translate("int(0.5) is 0: a short v counts as zero."),
			script + "test_mistake_7_the_length_cut_to_a_whole_number",
			LabText.translate("The test normalizes (0.3, 0.4) and wants (0.6, 0.8).")
		),
	]
