class_name NormalsMistakes
## The wrong normals found in student code, by their numbers in the course's list. Only for showing
## beside the right ones.

## Numbers of the mistakes that can be switched on.
const WRONG_NORMAL := 9
const ZERO_VECTOR := 6
const CUT_LENGTH := 7


## Mistake 9: components swapped, without a sign. Not perpendicular to v.
static func swapped(v: Vec2) -> Vec2:
	return Vec2.new(v.y, v.x)


## Mistake 9: the sign on the wrong component. Perpendicular, but on the other side.
static func wrong_sign(v: Vec2) -> Vec2:
	return Vec2.new(v.y, -v.x)


## Mistake 6: divided by the length without asking whether it is 0. NaN for a zero v.
static func unit_without_test(v: Vec2) -> Vec2:
	var size := v.length()
	return Vec2.new(-v.y / size, v.x / size)


## Mistake 7: the length cut to a whole number before the test for 0. Zero for a v shorter than 1.
static func unit_with_cut_length(v: Vec2) -> Vec2:
	if int(v.length()) == 0:
		return Vec2.new()
	return v.normal()


## What mistake 6 or 7 makes of the unit normal of [param v].
static func wrong_unit(mistake: int, v: Vec2) -> Vec2:
	return unit_with_cut_length(v) if mistake == CUT_LENGTH else unit_without_test(v)
