extends LabTest
## The asserts that the other tests lean on must be able to fail.


func test_equal_vectors_show_no_difference() -> void:
	assert_eq(vec2_difference(Vec2.new(3, 4), Vec2.new(3, 4), 0.0), "")


func test_a_vector_just_within_the_tolerance_is_accepted() -> void:
	assert_eq(vec2_difference(Vec2.new(3.5, 4), Vec2.new(3, 4.5), 0.5), "")


func test_a_vector_off_in_one_component_is_told_with_all_digits() -> void:
	var text := vec2_difference(Vec2.new(3, 0.1 + 0.2), Vec2.new(3, 0.3), 0.0)
	assert_eq(text, "Got (3, 0.30000000000000004), wanted (3, 0.3) within 0.")
	assert_ne(vec2_difference(Vec2.new(3.1, 4), Vec2.new(3, 4), 0.05), "")


func test_null_and_nan_are_never_as_wanted() -> void:
	assert_eq(vec2_difference(null, Vec2.zero(), 1.0), "Got null, wanted (0, 0).")
	assert_ne(vec2_difference(Vec2.new(NAN, 0), Vec2.new(NAN, 0), INF), "")
	assert_ne(vec2_difference(Vec2.new(0, NAN), Vec2.zero(), INF), "")


func test_same_bits_tells_the_two_zeros_apart() -> void:
	assert_true(same_bits(0.1, 0.1))
	assert_false(same_bits(0.0, negative_zero()))
	assert_false(same_bits(1.0, 1.0 + EPSILON))


func test_the_last_place_is_the_step_to_the_next_double() -> void:
	assert_eq(last_place(1.0), EPSILON)
	assert_eq(last_place(-3.0), 2.0 * EPSILON)
	assert_eq(last_place(0.0), SMALLEST_SUBNORMAL)


func test_random_vectors_are_the_same_for_the_same_seed() -> void:
	var first := random_vectors(1, 50)
	var again := random_vectors(1, 50)
	var other := random_vectors(2, 50)
	assert_vec2(again[49], first[49], 0.0)
	assert_ne(first[0].x, other[0].x)


func test_random_vectors_fill_the_square_asked_for() -> void:
	var smallest := 0.0
	var largest := 0.0
	for vector: Vec2 in random_vectors(3, 1000, 10.0):
		smallest = minf(smallest, minf(vector.x, vector.y))
		largest = maxf(largest, maxf(vector.x, vector.y))
	assert_between(smallest, -10.0, -9.9)
	assert_between(largest, 9.9, 10.0)
