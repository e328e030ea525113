extends LabTest
## Normals, the dot and cross product, and projections.


func test_the_normals_of_the_lecture() -> void:
	assert_vec2(Vec2.new(3, 1).normal(), Vec2.new(-1, 3).scaled(1.0 / sqrt(10.0)), 1e-15)
	assert_vec2(Vec2.new(3, -2).normal(), Vec2.new(2, 3).scaled(1.0 / sqrt(13.0)), 1e-15)
	assert_vec2(Vec2.new(3, -4).normal(), Vec2.new(0.8, 0.6), 0.0)


func test_the_normal_is_90_degrees_clockwise_on_screen() -> void:
	assert_vec2(Vec2.new(5, 0).normal(), Vec2.new(0, 1), 0.0)
	assert_vec2(Vec2.new(0, 5).normal(), Vec2.new(-1, 0), 0.0)


func test_the_normal_has_length_1_and_is_perpendicular() -> void:
	var lengths := PackedFloat64Array()
	var dots := PackedFloat64Array()
	for vector: Vec2 in random_vectors(31, 500):
		var normal := vector.normal()
		lengths.append(absf(normal.length() - 1.0))
		dots.append(absf(normal.dot(vector)) / vector.length())
	assert_all_at_most(lengths, 2.0 * EPSILON)
	assert_all_at_most(dots, 2.0 * EPSILON)


func test_the_normal_does_not_depend_on_the_length() -> void:
	for vector: Vec2 in random_vectors(32, 20):
		assert_vec2(vector.scaled(0.001).normal(), vector.normal(), 4.0 * EPSILON)


func test_the_normal_of_a_zero_vector_is_zero() -> void:
	assert_vec2(Vec2.zero().normal(), Vec2.zero(), 0.0)


func test_the_dot_product_of_the_lecture_is_50() -> void:
	assert_eq(Vec2.new(7, 1).dot(Vec2.new(8, -6)), 50.0)


func test_the_sign_of_the_dot_product_tells_below_from_beyond_90_degrees() -> void:
	assert_gt(Vec2.new(1, 0).dot(Vec2.new(1, 5)), 0.0)
	assert_eq(Vec2.new(1, 0).dot(Vec2.new(0, 5)), 0.0)
	assert_lt(Vec2.new(1, 0).dot(Vec2.new(-1, 5)), 0.0)


func test_the_dot_product_is_lengths_times_cosine() -> void:
	var vectors := random_vectors(33, 100)
	for index: int in range(0, 100, 2):
		var a := vectors[index]
		var b := vectors[index + 1]
		var by_angles := a.length() * b.length() * cos(a.angle_radians() - b.angle_radians())
		assert_almost_eq(a.dot(b), by_angles, 1e-10)


func test_the_cross_product_is_the_determinant() -> void:
	assert_eq(Vec2.new(3, 4).cross(Vec2.new(5, -2)), -26.0)
	assert_eq(Vec2.new(5, -2).cross(Vec2.new(3, 4)), 26.0)


func test_the_cross_product_is_positive_for_clockwise_on_screen() -> void:
	assert_gt(Vec2.new(1, 0).cross(Vec2.new(0, 1)), 0.0)


func test_the_projections_of_the_lecture() -> void:
	var a := Vec2.new(7, 1)
	var b := Vec2.new(8, -6)
	assert_eq(a.scalar_projection(b), 5.0)
	assert_vec2(a.vector_projection(b), Vec2.new(4, -3), 0.0)
	assert_vec2(a.rejection(b), Vec2.new(3, 4), 0.0)


func test_the_projection_of_a_on_b_is_not_that_of_b_on_a() -> void:
	assert_almost_eq(Vec2.new(8, -6).scalar_projection(Vec2.new(7, 1)), 50.0 / sqrt(50.0), 1e-14)


func test_the_scalar_projection_is_negative_beyond_90_degrees() -> void:
	assert_eq(Vec2.new(-3, 4).scalar_projection(Vec2.new(2, 0)), -3.0)
	assert_vec2(Vec2.new(-3, 4).vector_projection(Vec2.new(2, 0)), Vec2.new(-3, 0), 0.0)


func test_the_scalar_projection_is_right_to_three_units_in_the_last_place() -> void:
	var errors := PackedFloat64Array()
	var vectors := random_vectors(34, 1000)
	for index: int in range(0, 1000, 2):
		var a := vectors[index]
		var b := vectors[index + 1]
		var error := ExactProjection.error_of_scalar_projection(a.scalar_projection(b), a, b)
		errors.append(absf(error) / a.length())
	assert_all_at_most(errors, 3.0 * EPSILON)


func test_projection_and_rejection_make_up_the_vector() -> void:
	var vectors := random_vectors(35, 200)
	for index: int in range(0, 200, 2):
		var sum := vectors[index].vector_projection(vectors[index + 1])
		sum.add(vectors[index].rejection(vectors[index + 1]))
		assert_vec2(sum, vectors[index], 1e-13)


func test_the_projection_is_parallel_and_the_rejection_perpendicular() -> void:
	var parallel := PackedFloat64Array()
	var perpendicular := PackedFloat64Array()
	var vectors := random_vectors(36, 200)
	for index: int in range(0, 200, 2):
		var a := vectors[index]
		var unit := vectors[index + 1].normalized()
		parallel.append(absf(a.vector_projection(vectors[index + 1]).cross(unit)))
		perpendicular.append(absf(a.rejection(vectors[index + 1]).dot(unit)))
	assert_all_at_most(parallel, 1e-13)
	assert_all_at_most(perpendicular, 1e-13)


func test_the_projection_does_not_depend_on_the_length_of_the_other() -> void:
	var b := Vec2.new(8, -6)
	for a: Vec2 in random_vectors(37, 20):
		assert_vec2(a.vector_projection(b.scaled(1000)), a.vector_projection(b), 1e-13)


func test_projections_on_the_axes_are_the_components() -> void:
	var a := Vec2.new(7, 1)
	assert_vec2(a.vector_projection(Vec2.new(-3, 0)), Vec2.new(7, 0), 0.0)
	assert_vec2(a.rejection(Vec2.new(-3, 0)), Vec2.new(0, 1), 0.0)
	assert_vec2(a.vector_projection(Vec2.new(0, 5)), Vec2.new(0, 1), 0.0)
	assert_vec2(a.rejection(Vec2.new(0, 5)), Vec2.new(7, 0), 0.0)


func test_projections_on_zero_are_zero_and_the_rejection_is_a_copy() -> void:
	var a := Vec2.new(7, 1)
	assert_eq(a.scalar_projection(Vec2.zero()), 0.0)
	assert_vec2(a.vector_projection(Vec2.zero()), Vec2.zero(), 0.0)
	assert_vec2(a.rejection(Vec2.zero()), a, 0.0)


func test_projections_of_zero_are_zero() -> void:
	var b := Vec2.new(8, -6)
	assert_eq(Vec2.zero().scalar_projection(b), 0.0)
	assert_vec2(Vec2.zero().vector_projection(b), Vec2.zero(), 0.0)
	assert_vec2(Vec2.zero().rejection(b), Vec2.zero(), 0.0)
