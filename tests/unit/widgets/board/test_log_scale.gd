extends LabTest
## Tests of the logarithmic axis: its ends, where values lie on it, and values that have no place on
## it.


func test_the_axis_runs_from_the_power_of_ten_below_to_the_one_above() -> void:
	var scale := LogScale.around([0.03, 700.0, 2.0])
	assert_eq([scale.from_exponent, scale.to_exponent], [-2, 3])


func test_a_power_of_ten_is_its_own_end() -> void:
	for exponent: int in range(-30, 13):
		var scale := LogScale.around([10.0 ** exponent])
		assert_eq([scale.from_exponent, scale.to_exponent], [exponent, exponent + 1])


func test_each_power_of_ten_takes_the_same_room() -> void:
	var scale := LogScale.around([1e-3, 1e5])
	assert_almost_eq(scale.share(1e-3), 0.0, 1e-12)
	assert_almost_eq(scale.share(10.0), 0.5, 1e-12)
	assert_almost_eq(scale.share(1e5), 1.0, 1e-12)


func test_zero_is_told_apart_and_does_not_stretch_the_axis() -> void:
	var scale := LogScale.around([0.0, 5.0])
	assert_true(scale.has_zero)
	assert_eq([scale.from_exponent, scale.to_exponent], [0, 1])
	assert_false(LogScale.around([5.0]).has_zero)


func test_infinite_huge_and_no_number_at_all_count_as_no_answer() -> void:
	for value: float in [INF, NAN, 1e13, 1e300]:
		var scale := LogScale.around([value, 5.0])
		assert_true(scale.has_no_answer, str(value))
		assert_eq([scale.from_exponent, scale.to_exponent], [0, 1])
	assert_false(LogScale.around([1e12]).has_no_answer)


func test_an_axis_without_any_value_still_has_two_ends() -> void:
	for values: PackedFloat64Array in [PackedFloat64Array(), PackedFloat64Array([0.0, INF])]:
		var scale := LogScale.around(values)
		assert_gt(scale.to_exponent, scale.from_exponent)


func test_numbers_on_the_axis_are_evenly_spaced_and_not_too_many() -> void:
	var scale := LogScale.around([1e-14, 1e3])
	assert_eq(scale.ticks(18), PackedInt32Array(range(-14, 4)))
	assert_eq(scale.ticks(7), PackedInt32Array([-12, -9, -6, -3, 0, 3]))
	for most: int in range(2, 20):
		assert_lte(scale.ticks(most).size(), most)
