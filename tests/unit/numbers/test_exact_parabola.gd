extends LabTest
## The path under constant acceleration to about 100 bits.


func test_whole_numbers_give_exact_answers() -> void:
	var path := ExactParabola.new(-8, -2, 8, -2, 0, 2)
	assert_eq(path.squared_gap(0, 0, 3, 1), 0.0)
	assert_eq(path.squared_gap(0, 0, 2, 0), 64.0)
	assert_eq(
		[path.growth(0, 0, 1), path.growth(0, 0, 0), path.growth(1, 1, 2)], [0.0, -60.0, 50.0]
	)


func test_a_distance_from_a_line_of_rational_length_is_exact() -> void:
	var path := ExactParabola.new(-4, 3, 1, 0, 0, 0)
	assert_eq(path.line_gap(0, 0, 3, 4, 5, 1), 0.0)
	assert_eq(path.line_gap(0, 0, 3, 4, -5, 1), 50.0)
	assert_eq(path.line_gap(0, 0, 3, 4, 5, -1), -50.0)


func test_digits_that_no_double_holds_are_kept() -> void:
	var path := ExactParabola.new(1e10, 1e-10, 0, 1e-20, 0, 0)
	assert_almost_eq(path.line_gap(0, 0, 1, 0, 1e-10, 1), 0.0, 1e-40)
	assert_almost_eq(path.squared_gap(1e10, 0, 1e-10, 1), 2e-30, 1e-39)


func test_the_discriminant_is_zero_where_the_apex_touches() -> void:
	# Thrown up from 19 px below the line at 8 px/s, against 2 px/s^2: the apex is 3 px below it.
	var path := ExactParabola.new(5, 19, 0, -8, 0, 2)
	assert_eq(path.line_discriminant(0, 0, 20, 0, 3, 1), 0.0)
	assert_eq(path.line_discriminant(0, 0, 20, 0, 2, 1), -4.0 * 400.0)
	assert_eq(path.line_discriminant(0, 0, 20, 0, -3, 1), 64.0 * 400.0 - 4.0 * 22.0 * 400.0)
