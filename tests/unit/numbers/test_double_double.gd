extends LabTest
## DoubleDouble against whole numbers and against fractions worked out in Python.

## The promised relative error, 2^-100.
const PROMISED := 1.0 / 2.0 ** 100


func test_a_sum_that_a_double_rounds_keeps_the_rest() -> void:
	var sum := DoubleDouble.sum_of(2.0 ** 60, 1.0)
	assert_eq(sum.high, 2.0 ** 60)
	assert_eq(sum.low, 1.0)


func test_a_small_first_summand_loses_nothing_either() -> void:
	var sum := DoubleDouble.sum_of(-1.0, 2.0 ** 60)
	assert_eq(sum.high, 2.0 ** 60)
	assert_eq(sum.low, -1.0)


func test_a_product_keeps_what_a_double_rounds_away() -> void:
	# (2^30 + 1)^2 = 2^60 + 2^31 + 1
	var product := DoubleDouble.product_of(2.0 ** 30 + 1.0, 2.0 ** 30 + 1.0)
	assert_eq(product.high, 2.0 ** 60 + 2.0 ** 31)
	assert_eq(product.low, 1.0)


func test_the_whole_of_a_cancelling_difference_is_left() -> void:
	var large := DoubleDouble.sum_of(2.0 ** 80, 3.0)
	var difference := large.minus(DoubleDouble.from_float(2.0 ** 80))
	assert_eq(difference.to_float(), 3.0)


func test_a_third_times_three_is_one() -> void:
	var third := DoubleDouble.from_float(1.0).divided(DoubleDouble.from_float(3.0))
	var one := third.times(DoubleDouble.from_float(3.0))
	assert_almost_eq(one.error_of(1.0), 0.0, PROMISED)


func test_the_root_of_two_squared_is_two() -> void:
	var root := DoubleDouble.from_float(2.0).square_root()
	assert_almost_eq(root.times(root).error_of(2.0), 0.0, 2.0 * PROMISED)
	assert_ne(root.low, 0.0)


func test_the_root_of_a_square_number_is_exact() -> void:
	var root := DoubleDouble.from_float(625.0).square_root()
	assert_eq([root.high, root.low], [25.0, 0.0])


func test_the_root_of_zero_is_zero() -> void:
	assert_eq(DoubleDouble.from_float(0.0).square_root().to_float(), 0.0)


func test_the_error_of_a_double_has_its_sign_and_its_size() -> void:
	var exact := DoubleDouble.sum_of(1.0, EPSILON / 4.0)
	assert_eq(exact.error_of(1.0), -EPSILON / 4.0)
	assert_eq(exact.error_of(1.0 + EPSILON), 0.75 * EPSILON)


func test_division_by_zero_is_refused() -> void:
	var number := DoubleDouble.from_float(7.0)
	assert_eq(number.divided(DoubleDouble.from_float(0.0)).to_float(), 7.0)
	assert_push_error("divisor must not be 0")


func test_the_root_of_a_negative_number_is_refused() -> void:
	assert_eq(DoubleDouble.from_float(-4.0).square_root().to_float(), -4.0)
	assert_push_error("must be 0 or more, but is -4")


func test_the_sign_is_turned_in_both_parts() -> void:
	var number := DoubleDouble.sum_of(-(2.0 ** 60), 1.0)
	assert_eq([number.negated().high, number.negated().low], [2.0 ** 60, -1.0])


func test_less_is_told_by_the_low_part_where_the_high_ones_are_equal() -> void:
	var one := DoubleDouble.from_float(1.0)
	var more := DoubleDouble.sum_of(1.0, EPSILON / 16.0)
	assert_true(one.is_less_than(more))
	assert_false(more.is_less_than(one) or one.is_less_than(one))
	assert_true(more.negated().is_less_than(one))


func test_the_text_has_both_parts() -> void:
	assert_eq(str(DoubleDouble.sum_of(2.0 ** 53, 1.0)), "9.007199254740992e+15 + 1")


func test_operations_agree_with_exact_fractions() -> void:
	for family: String in ["ordinary", "cancelling"]:
		var errors := PackedFloat64Array()
		for row: PackedFloat64Array in reference_rows("double_double.json", family):
			errors.append_array(_relative_errors(row))
		assert_all_at_most(errors, PROMISED, family)


func _relative_errors(row: PackedFloat64Array) -> PackedFloat64Array:
	var first := DoubleDouble.new(row[0], row[1])
	var second := DoubleDouble.new(row[2], row[3])
	var magnitude := first if first.high > 0.0 else DoubleDouble.from_float(0.0).minus(first)
	var results: Array[DoubleDouble] = [
		first.plus(second),
		first.minus(second),
		first.times(second),
		first.divided(second),
		magnitude.square_root(),
	]
	var errors := PackedFloat64Array()
	for index: int in results.size():
		var high := row[4 + 2 * index]
		var low := row[5 + 2 * index]
		errors.append(absf((results[index].high - high + (results[index].low - low)) / high))
	return errors
