extends LabTest
## Sums, differences and multiples, in place and as new vectors.


func test_add_adds_each_component() -> void:
	var vector := Vec2.new(3, 4)
	vector.add(Vec2.new(-5, 0.5))
	assert_vec2(vector, Vec2.new(-2, 4.5), 0.0)


func test_subtract_subtracts_each_component() -> void:
	var vector := Vec2.new(3, 4)
	vector.subtract(Vec2.new(-5, 0.5))
	assert_vec2(vector, Vec2.new(8, 3.5), 0.0)


func test_scale_multiplies_both_components() -> void:
	var vector := Vec2.new(3, 4)
	vector.scale(-2.5)
	assert_vec2(vector, Vec2.new(-7.5, -10), 0.0)


func test_plus_is_a_new_sum() -> void:
	assert_vec2(Vec2.new(3, 4).plus(Vec2.new(-5, 0.5)), Vec2.new(-2, 4.5), 0.0)


func test_minus_is_a_new_difference() -> void:
	assert_vec2(Vec2.new(3, 4).minus(Vec2.new(-5, 0.5)), Vec2.new(8, 3.5), 0.0)


func test_scaled_is_a_new_multiple() -> void:
	assert_vec2(Vec2.new(3, 4).scaled(-2.5), Vec2.new(-7.5, -10), 0.0)


func test_divided_divides_both_components() -> void:
	assert_vec2(Vec2.new(3, 4).divided(-2), Vec2.new(-1.5, -2), 0.0)


func test_divided_rounds_only_once() -> void:
	# 5 / 3, not 5 times the rounded 1 / 3.
	assert_true(same_bits(Vec2.new(5, 0).divided(3).x, 5.0 / 3.0))


func test_division_by_zero_is_refused_and_gives_a_copy() -> void:
	assert_vec2(Vec2.new(3, 4).divided(0), Vec2.new(3, 4), 0.0)
	assert_push_error("Vec2.divided: the divisor must not be 0; (3, 4) stays undivided.")


func test_division_by_negative_zero_is_refused() -> void:
	assert_vec2(Vec2.new(3, 4).divided(negative_zero()), Vec2.new(3, 4), 0.0)
	assert_push_error("divisor must not be 0")


func test_negated_points_the_other_way() -> void:
	assert_vec2(Vec2.new(3, -4).negated(), Vec2.new(-3, 4), 0.0)


func test_adding_the_negated_vector_leaves_zero() -> void:
	for vector: Vec2 in random_vectors(11, 20):
		assert_vec2(vector.plus(vector.negated()), Vec2.zero(), 0.0)


func test_verbs_and_their_twins_agree() -> void:
	var vectors := random_vectors(12, 40)
	for index: int in range(0, 40, 2):
		var other := vectors[index + 1]
		var changed := vectors[index].copy()
		changed.add(other)
		changed.scale(1.7)
		changed.subtract(other)
		assert_vec2(changed, vectors[index].plus(other).scaled(1.7).minus(other), 0.0)
