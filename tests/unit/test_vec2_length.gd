extends LabTest
## Length, distance, and what normalizes, sets or limits the length.


func test_the_length_of_3_4_is_5() -> void:
	assert_eq(Vec2.new(3, 4).length(), 5.0)
	assert_eq(Vec2.new(-5, 12).length(), 13.0)
	assert_eq(Vec2.zero().length(), 0.0)


func test_the_length_is_right_to_the_last_place() -> void:
	var errors := PackedFloat64Array()
	for vector: Vec2 in random_vectors(21, 500):
		var error := _exact_length(vector).error_of(vector.length())
		errors.append(absf(error) / last_place(vector.length()))
	assert_all_at_most(errors, 1.0)


func test_length_squared_is_the_sum_of_the_squares() -> void:
	assert_eq(Vec2.new(3, -4).length_squared(), 25.0)


func test_the_distance_is_that_of_the_difference() -> void:
	assert_eq(Vec2.new(1, 2).distance_to(Vec2.new(4, -2)), 5.0)
	assert_eq(Vec2.new(4, -2).distance_to(Vec2.new(1, 2)), 5.0)
	assert_eq(Vec2.new(4, -2).distance_to(Vec2.new(4, -2)), 0.0)


func test_normalize_makes_3_4_to_6_8_tenths() -> void:
	var vector := Vec2.new(3, 4)
	vector.normalize()
	assert_vec2(vector, Vec2.new(0.6, 0.8), 0.0)


func test_normalized_has_length_1_within_two_units_in_the_last_place() -> void:
	var errors := PackedFloat64Array()
	for vector: Vec2 in random_vectors(22, 1000):
		errors.append(absf(_exact_length(vector.normalized()).error_of(1.0)))
	assert_all_at_most(errors, 2.0 * EPSILON)


func test_normalized_keeps_the_direction() -> void:
	var errors := PackedFloat64Array()
	for vector: Vec2 in random_vectors(23, 500):
		var unit := vector.normalized()
		errors.append(absf(unit.cross(vector)) / vector.length())
		assert_true(unit.dot(vector) > 0.0)
	assert_all_at_most(errors, 2.0 * EPSILON)


func test_normalize_and_normalized_agree() -> void:
	for vector: Vec2 in random_vectors(24, 20):
		var changed := vector.copy()
		changed.normalize()
		assert_vec2(changed, vector.normalized(), 0.0)


func test_a_zero_vector_stays_zero_when_normalized() -> void:
	var vector := Vec2.zero()
	vector.normalize()
	assert_vec2(vector, Vec2.zero(), 0.0)
	assert_vec2(Vec2.zero().normalized(), Vec2.zero(), 0.0)


func test_set_length_keeps_the_direction() -> void:
	var vector := Vec2.new(-3, 4)
	vector.set_length(10)
	assert_vec2(vector, Vec2.new(-6, 8), 1e-15)


func test_set_length_to_zero_gives_the_zero_vector() -> void:
	var vector := Vec2.new(-3, 4)
	vector.set_length(0)
	assert_vec2(vector, Vec2.zero(), 0.0)


func test_a_zero_vector_stays_zero_when_its_length_is_set() -> void:
	var vector := Vec2.zero()
	vector.set_length(10)
	assert_vec2(vector, Vec2.zero(), 0.0)


func test_a_length_that_cannot_be_is_refused() -> void:
	var vector := Vec2.new(3, 4)
	for wrong: float in [-2.5, INF, NAN]:
		vector.set_length(wrong)
		assert_vec2(vector, Vec2.new(3, 4), 0.0)
		assert_push_error("must be finite and 0 or more, but is %s." % wrong)


func test_limit_length_shortens_a_longer_vector() -> void:
	var vector := Vec2.new(-30, 40)
	vector.limit_length(5)
	assert_vec2(vector, Vec2.new(-3, 4), 1e-15)


func test_limit_length_to_zero_gives_the_zero_vector() -> void:
	var vector := Vec2.new(-30, 40)
	vector.limit_length(0)
	assert_vec2(vector, Vec2.zero(), 0.0)


func test_limit_length_leaves_a_shorter_vector_alone() -> void:
	for maximum: float in [5.0, 6.0, INF]:
		var vector := Vec2.new(3, 4)
		vector.limit_length(maximum)
		assert_vec2(vector, Vec2.new(3, 4), 0.0)


func test_limit_length_to_its_own_length_changes_no_bit() -> void:
	for vector: Vec2 in random_vectors(25, 100):
		var before := vector.copy()
		vector.limit_length(vector.length())
		assert_vec2(vector, before, 0.0)


func test_a_maximum_that_cannot_be_is_refused() -> void:
	var vector := Vec2.new(3, 4)
	for wrong: float in [-1.0, NAN]:
		vector.limit_length(wrong)
		assert_vec2(vector, Vec2.new(3, 4), 0.0)
		assert_push_error("maximum must be 0 or more, but is %s." % wrong)


func _exact_length(vector: Vec2) -> DoubleDouble:
	return ExactProjection.dot(vector, vector).square_root()
