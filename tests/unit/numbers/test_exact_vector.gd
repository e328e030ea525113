extends LabTest
## Vectors with twice the digits of a double. Each rule is tried with numbers that a double would
## round.

## 1 plus a part that is too small for a double near 1.
const TINY := 1.0 / 2.0 ** 90


func test_between_two_points_nothing_is_rounded() -> void:
	var vector := ExactVector.between(Vec2.new(TINY, -3.0), Vec2.new(1.0, TINY))
	assert_eq([vector.x.high, vector.x.low], [1.0, -TINY])
	assert_eq([vector.y.high, vector.y.low], [3.0, TINY])


func test_sum_and_difference_keep_the_small_part() -> void:
	var large := ExactVector.from_vec2(Vec2.new(1.0, -2.0))
	var small := ExactVector.from_vec2(Vec2.new(TINY, TINY))
	assert_vec2(large.plus(small).minus(large).to_vec2(), Vec2.new(TINY, TINY), 0.0)


func test_the_dot_product_keeps_what_cancels() -> void:
	var along := ExactVector.from_vec2(Vec2.new(1.0 + EPSILON, 1.0))
	var across := ExactVector.from_vec2(Vec2.new(1.0 + EPSILON, -1.0))
	assert_eq(along.dot(across).to_float(), 2.0 * EPSILON + EPSILON * EPSILON)


func test_turned_is_plus_90_degrees() -> void:
	assert_vec2(ExactVector.from_vec2(Vec2.new(3, 4)).turned().to_vec2(), Vec2.new(-4, 3), 0.0)


func test_scaled_by_a_third_and_by_three_is_the_same() -> void:
	var third := DoubleDouble.from_float(1.0).divided(DoubleDouble.from_float(3.0))
	var vector := ExactVector.from_vec2(Vec2.new(1, -7)).scaled(third)
	var back := vector.scaled(DoubleDouble.from_float(3.0))
	assert_almost_eq(back.x.error_of(1.0), 0.0, 1e-30)
	assert_almost_eq(back.y.error_of(-7.0), 0.0, 1e-30)


func test_reflected_needs_no_normal_of_length_1() -> void:
	var falling := ExactVector.from_vec2(Vec2.new(3, 4))
	var normal := ExactVector.from_vec2(Vec2.new(0, -10))
	assert_vec2(falling.reflected(normal).to_vec2(), Vec2.new(3, -4), 0.0)


func test_the_text_has_all_digits() -> void:
	assert_eq(str(ExactVector.between(Vec2.new(), Vec2.new(1, -2))), "(1 + 0, -2 + 0)")
