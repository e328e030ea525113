extends LabTest
## ExactProjection against whole numbers, Pythagorean triples and fractions worked out in Python.

## The promised relative error, 2^-100.
const PROMISED := 1.0 / 2.0 ** 100


func test_the_lecture_example_is_exact() -> void:
	var projection := ExactProjection.scalar_projection(Vec2.new(7, 1), Vec2.new(8, -6))
	assert_eq([projection.high, projection.low], [5.0, 0.0])


func test_pythagorean_directions_give_exact_fractions() -> void:
	# (1, 0) projected on (3, 4) is 3/5. Five times that is 3, without any error in 100 bits.
	var three_fifths := ExactProjection.scalar_projection(Vec2.new(1, 0), Vec2.new(3, 4))
	var three := three_fifths.times(DoubleDouble.from_float(5.0))
	assert_almost_eq(three.error_of(3.0), 0.0, 3.0 * PROMISED)


func test_projections_on_the_axes_are_the_components() -> void:
	assert_eq(ExactProjection.scalar_projection(Vec2.new(7, 1), Vec2.new(-3, 0)).to_float(), -7.0)
	assert_eq(ExactProjection.scalar_projection(Vec2.new(7, 1), Vec2.new(0, 5)).to_float(), 1.0)


func test_a_projection_on_zero_is_zero() -> void:
	assert_eq(ExactProjection.scalar_projection(Vec2.new(7, 1), Vec2.zero()).to_float(), 0.0)


func test_the_projection_of_zero_is_zero() -> void:
	assert_eq(ExactProjection.scalar_projection(Vec2.zero(), Vec2.new(7, 1)).to_float(), 0.0)


func test_a_dot_product_beyond_the_53_bits_of_a_double_is_exact() -> void:
	# (2^27 + 1)(2^27 - 1) - 2^54 = -1: the products differ by less than a double can show.
	var large := 2.0 ** 27
	var dot := ExactProjection.dot(Vec2.new(large + 1.0, large), Vec2.new(large - 1.0, -large))
	assert_eq(dot.to_float(), -1.0)


func test_the_error_of_a_value_is_signed_and_in_pixels() -> void:
	var a := Vec2.new(7, 1)
	var b := Vec2.new(8, -6)
	assert_eq(ExactProjection.error_of_scalar_projection(50.0, a, b), 45.0)
	assert_eq(ExactProjection.error_of_scalar_projection(5.0 - EPSILON * 4.0, a, b), -EPSILON * 4.0)


func test_dot_products_agree_with_exact_fractions() -> void:
	for family: String in ["whole", "ordinary", "perpendicular"]:
		var errors := PackedFloat64Array()
		for row: PackedFloat64Array in reference_rows("scalar_projection.json", family):
			var dot := ExactProjection.dot(Vec2.new(row[0], row[1]), Vec2.new(row[2], row[3]))
			errors.append(_relative_error(dot, row[4], row[5]))
		assert_all_at_most(errors, PROMISED, family)


func test_scalar_projections_agree_with_exact_fractions() -> void:
	for family: String in ["whole", "ordinary", "perpendicular", "extreme"]:
		var errors := PackedFloat64Array()
		for row: PackedFloat64Array in reference_rows("scalar_projection.json", family):
			var a := Vec2.new(row[0], row[1])
			var b := Vec2.new(row[2], row[3])
			errors.append(_relative_error(ExactProjection.scalar_projection(a, b), row[6], row[7]))
		assert_all_at_most(errors, PROMISED, family)


func _relative_error(got: DoubleDouble, high: float, low: float) -> float:
	var difference := absf((got.high - high) + (got.low - low))
	return difference / absf(high) if high != 0.0 else difference
