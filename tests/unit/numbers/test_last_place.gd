extends LabTest
## Units in the last place.


func test_the_unit_of_1_is_the_distance_to_the_next_double() -> void:
	assert_eq(LastPlace.unit_of(1.0), EPSILON)
	assert_eq(LastPlace.unit_of(-1.0), EPSILON)


func test_the_unit_grows_with_each_power_of_2() -> void:
	assert_eq(LastPlace.unit_of(5.0), 4.0 * EPSILON)
	assert_eq(LastPlace.unit_of(7.999), 4.0 * EPSILON)
	assert_eq(LastPlace.unit_of(8.0), 8.0 * EPSILON)


func test_the_unit_of_0_is_the_smallest_double() -> void:
	assert_eq(LastPlace.unit_of(0.0), SMALLEST_SUBNORMAL)


func test_neighbours_are_one_unit_apart() -> void:
	assert_eq(LastPlace.units_between(5.0, 5.0 + 4.0 * EPSILON), 1.0)
	assert_eq(LastPlace.units_between(-5.0 - 12.0 * EPSILON, -5.0), 3.0)


func test_the_unit_is_that_of_the_larger_number() -> void:
	assert_eq(LastPlace.units_between(8.0 - 4.0 * EPSILON, 8.0), 0.5)


func test_equal_numbers_are_no_unit_apart() -> void:
	assert_eq(LastPlace.units_between(0.1, 0.1), 0.0)
	assert_eq(LastPlace.units_between(0.0, negative_zero()), 0.0)


func test_0_1_plus_0_2_is_one_unit_above_0_3() -> void:
	assert_eq(LastPlace.units_between(0.1 + 0.2, 0.3), 1.0)
