extends LabTest
## Making a Vec2, reading it, copying it, comparing it, and the bridge to Godot's Vector2.


func test_a_new_vector_has_the_components_given() -> void:
	var vector := Vec2.new(3.0, -4.5)
	assert_eq([vector.x, vector.y], [3.0, -4.5])


func test_a_new_vector_without_components_is_zero() -> void:
	var vector := Vec2.new()
	assert_eq([vector.x, vector.y], [0.0, 0.0])


func test_set_xy_sets_both_components() -> void:
	var vector := Vec2.new(1, 2)
	vector.set_xy(-7.0, 8.25)
	assert_vec2(vector, Vec2.new(-7.0, 8.25), 0.0)


func test_the_components_keep_all_digits_of_a_double() -> void:
	var vector := Vec2.new(0.1, 1.0 / 3.0)
	assert_true(same_bits(vector.x, 0.1))
	assert_true(same_bits(vector.y, 1.0 / 3.0))


func test_the_text_of_whole_numbers_has_no_point() -> void:
	assert_eq(str(Vec2.new(3, 4)), "(3, 4)")
	assert_eq(str(Vec2.new(-100, 0)), "(-100, 0)")


func test_the_text_has_at_most_six_digits_after_the_point() -> void:
	assert_eq(str(Vec2.new(0.5, -1.25)), "(0.5, -1.25)")
	assert_eq(str(Vec2.new(2.0 / 3.0, -5.000000000000001)), "(0.666667, -5)")


func test_the_text_of_negative_zero_is_zero() -> void:
	assert_eq(str(Vec2.new(negative_zero(), 1)), "(0, 1)")


func test_the_text_is_cut_after_six_digits_down_to_a_ten_thousandth() -> void:
	assert_eq(str(Vec2.new(0.000123456, -0.000187654)), "(0.000123, -0.000188)")


func test_the_text_of_tiny_and_huge_components_hides_nothing() -> void:
	assert_eq(str(Vec2.new(1e-9, -1e300)), "(1e-09, -1e+300)")
	assert_eq(str(Vec2.new(0.0001, 1e15)), "(0.0001, 1e+15)")
	assert_eq(str(Vec2.new(NAN, -INF)), "(nan, -inf)")


func test_a_copy_is_equal() -> void:
	assert_vec2(Vec2.new(3, 4).copy(), Vec2.new(3, 4), 0.0)


func test_equals_approx_accepts_a_difference_up_to_the_tolerance() -> void:
	var vector := Vec2.new(3, 4)
	assert_true(vector.equals_approx(Vec2.new(3.5, 3.5), 0.5))
	assert_true(vector.equals_approx(vector, 0.0))


func test_equals_approx_sees_a_difference_in_either_component() -> void:
	var vector := Vec2.new(3, 4)
	assert_false(vector.equals_approx(Vec2.new(3.6, 4), 0.5))
	assert_false(vector.equals_approx(Vec2.new(3, 3.4), 0.5))
	assert_false(vector.equals_approx(Vec2.new(3, 4.0 + 4.0 * EPSILON), 0.0))


func test_equals_approx_is_never_true_for_nan_or_infinity() -> void:
	assert_false(Vec2.new(NAN, 0).equals_approx(Vec2.new(NAN, 0), INF))
	assert_false(Vec2.new(0, INF).equals_approx(Vec2.new(0, INF), 1.0))


func test_finite_vectors_are_finite_up_to_the_ends_of_the_range() -> void:
	assert_true(Vec2.zero().is_finite())
	assert_true(Vec2.new(LARGEST_DOUBLE, -LARGEST_DOUBLE).is_finite())
	assert_true(Vec2.new(SMALLEST_SUBNORMAL, 1e-300).is_finite())


func test_one_component_that_is_not_finite_is_enough() -> void:
	for bad: float in [INF, -INF, NAN]:
		assert_false(Vec2.new(bad, 1).is_finite(), "x = %s" % bad)
		assert_false(Vec2.new(1, bad).is_finite(), "y = %s" % bad)


func test_a_vector_is_within_a_limit_that_both_components_keep() -> void:
	assert_true(Vec2.new(5, -5).is_within(5.0))
	assert_true(Vec2.zero().is_within(0.0))


func test_one_component_beyond_the_limit_is_enough() -> void:
	for bad: float in [5.1, -5.1, INF, NAN]:
		assert_false(Vec2.new(bad, 1).is_within(5.0), "x = %s" % bad)
		assert_false(Vec2.new(1, bad).is_within(5.0), "y = %s" % bad)


func test_to_vector2_rounds_to_32_bits() -> void:
	assert_eq(Vec2.new(3.5, -4.25).to_vector2(), Vector2(3.5, -4.25))
	assert_almost_eq(Vec2.new(1.0 / 3.0, 0).to_vector2().x, 1.0 / 3.0, 2e-8)
	assert_ne(Vec2.new(1.0 / 3.0, 0).to_vector2().x, 1.0 / 3.0)


func test_from_vector2_and_back_loses_nothing() -> void:
	var engine_vector := Vector2(0.1, -12345.678)
	assert_eq(Vec2.from_vector2(engine_vector).to_vector2(), engine_vector)
