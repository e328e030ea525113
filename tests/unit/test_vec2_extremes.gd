extends LabTest
## The ends of the range of a double: subnormals, 1e-300, 1e300 and the largest one.

## Powers of two: multiplying by them changes no digit, so every answer can be foretold exactly.
const TINY := 1.0 / 2.0 ** 1000
const HUGE := 2.0 ** 1000


func test_the_length_neither_overflows_nor_underflows() -> void:
	assert_eq(Vec2.new(3.0 * HUGE, 4.0 * HUGE).length(), 5.0 * HUGE)
	assert_eq(Vec2.new(-3.0 * HUGE, -4.0 * HUGE).length(), 5.0 * HUGE)
	assert_eq(Vec2.new(3.0 * TINY, 4.0 * TINY).length(), 5.0 * TINY)
	assert_eq(Vec2.new(1e300, 0).length(), 1e300)
	assert_eq(Vec2.new(0, -1e-300).length(), 1e-300)
	assert_eq(Vec2.new(0, -HUGE).length(), HUGE)


func test_the_length_of_subnormal_vectors() -> void:
	assert_eq(Vec2.new(SMALLEST_SUBNORMAL, 0).length(), SMALLEST_SUBNORMAL)
	var vector := Vec2.new(3.0 * SMALLEST_SUBNORMAL, 4.0 * SMALLEST_SUBNORMAL)
	assert_eq(vector.length(), 5.0 * SMALLEST_SUBNORMAL)


func test_the_length_of_a_huge_and_a_tiny_component() -> void:
	assert_eq(Vec2.new(1e300, 1e-300).length(), 1e300)
	assert_eq(Vec2.new(SMALLEST_SUBNORMAL, LARGEST_DOUBLE).length(), LARGEST_DOUBLE)


func test_only_a_length_too_large_for_a_double_is_infinite() -> void:
	assert_eq(Vec2.new(0.7 * LARGEST_DOUBLE, 0.7 * LARGEST_DOUBLE).length() < INF, true)
	assert_eq(Vec2.new(LARGEST_DOUBLE, LARGEST_DOUBLE).length(), INF)


func test_the_length_is_right_at_every_scale() -> void:
	var vector := Vec2.new(1.0 / 3.0, 0.7)
	var lengths := PackedFloat64Array()
	var distances := PackedFloat64Array()
	for exponent: int in range(-1000, 1001, 5):
		var power := pow(2.0, exponent)
		var scaled := vector.scaled(power)
		lengths.append(absf(scaled.length() / power - vector.length()))
		distances.append(absf(Vec2.zero().distance_to(scaled) / power - vector.length()))
	assert_all_at_most(lengths, EPSILON)
	assert_all_at_most(distances, EPSILON)


func test_the_distance_of_extreme_positions() -> void:
	var left := Vec2.new(-1.5 * HUGE, 2.0 * HUGE)
	assert_eq(left.distance_to(Vec2.new(1.5 * HUGE, -2.0 * HUGE)), 5.0 * HUGE)
	var near := Vec2.new(-1.5 * TINY, 2.0 * TINY)
	assert_eq(near.distance_to(Vec2.new(1.5 * TINY, -2.0 * TINY)), 5.0 * TINY)


func test_normalized_has_length_1_for_every_finite_vector() -> void:
	var errors := PackedFloat64Array()
	for vector: Vec2 in _extreme_vectors():
		var unit := vector.normalized()
		errors.append(absf(ExactProjection.dot(unit, unit).square_root().error_of(1.0)))
	assert_all_at_most(errors, 2.0 * EPSILON)


func test_normalized_keeps_the_direction_of_extreme_vectors() -> void:
	assert_vec2(Vec2.new(-3.0 * HUGE, 4.0 * HUGE).normalized(), Vec2.new(-0.6, 0.8), 0.0)
	assert_vec2(Vec2.new(-3.0 * TINY, 4.0 * TINY).normalized(), Vec2.new(-0.6, 0.8), 0.0)
	var subnormal := Vec2.new(-3.0 * SMALLEST_SUBNORMAL, 4.0 * SMALLEST_SUBNORMAL)
	assert_vec2(subnormal.normalized(), Vec2.new(-0.6, 0.8), 0.0)
	var largest := Vec2.new(-LARGEST_DOUBLE, LARGEST_DOUBLE)
	assert_vec2(largest.normalized(), Vec2.new(-sqrt(0.5), sqrt(0.5)), EPSILON)


func test_extreme_vectors_have_normals() -> void:
	assert_vec2(Vec2.new(3.0 * TINY, -4.0 * TINY).normal(), Vec2.new(0.8, 0.6), 0.0)
	assert_vec2(Vec2.new(3.0 * HUGE, -4.0 * HUGE).normal(), Vec2.new(0.8, 0.6), 0.0)


func test_set_length_reaches_from_end_to_end() -> void:
	var vector := Vec2.new(3.0 * TINY, -4.0 * TINY)
	vector.set_length(HUGE)
	assert_vec2(vector, Vec2.new(0.6 * HUGE, -0.8 * HUGE), 0.0)


func test_limit_length_shortens_even_a_vector_of_infinite_length() -> void:
	var vector := Vec2.new(LARGEST_DOUBLE, LARGEST_DOUBLE)
	vector.limit_length(1)
	assert_vec2(vector, Vec2.new(sqrt(0.5), sqrt(0.5)), EPSILON)


func test_projections_of_extreme_vectors() -> void:
	# The lecture's example, each vector at its own scale.
	for a_scale: float in [TINY, 1.0 / 2.0 ** 190, 1.0, HUGE]:
		for b_scale: float in [TINY, 1.0 / 2.0 ** 190, 1.0, 2.0 ** 190, HUGE]:
			var a := Vec2.new(7.0 * a_scale, a_scale)
			var b := Vec2.new(8.0 * b_scale, -6.0 * b_scale)
			var allowed := 8.0 * EPSILON * a_scale
			assert_almost_eq(a.scalar_projection(b), 5.0 * a_scale, allowed)
			assert_vec2(a.vector_projection(b), Vec2.new(4, -3).scaled(a_scale), allowed)
			assert_vec2(a.rejection(b), Vec2.new(3, 4).scaled(a_scale), allowed)


func test_projections_where_only_the_product_of_three_components_is_extreme() -> void:
	for power: float in [1.0 / 2.0 ** 390, 2.0 ** 390]:
		var a := Vec2.new(7, 1).scaled(power)
		var b := Vec2.new(8, -6).scaled(power)
		assert_vec2(a.vector_projection(b).divided(power), Vec2.new(4, -3), 8.0 * EPSILON)
		assert_vec2(a.rejection(b).divided(power), Vec2.new(3, 4), 8.0 * EPSILON)


func test_projections_are_right_at_every_scale() -> void:
	var a := Vec2.new(1.0 / 3.0, 0.7)
	var b := Vec2.new(0.9, -0.2)
	var scalars := PackedFloat64Array()
	var vectors := PackedFloat64Array()
	for exponent: int in range(-1000, 1001, 5):
		var scaled := b.scaled(pow(2.0, exponent))
		scalars.append(absf(a.scalar_projection(scaled) - a.scalar_projection(b)))
		vectors.append(a.vector_projection(scaled).distance_to(a.vector_projection(b)))
	assert_all_at_most(scalars, 2.0 * EPSILON)
	assert_all_at_most(vectors, 2.0 * EPSILON)


func test_projections_on_subnormal_vectors() -> void:
	var b := Vec2.new(8.0 * SMALLEST_SUBNORMAL, -6.0 * SMALLEST_SUBNORMAL)
	assert_almost_eq(Vec2.new(7, 1).scalar_projection(b), 5.0, 8.0 * EPSILON)
	assert_vec2(Vec2.new(7, 1).vector_projection(b), Vec2.new(4, -3), 8.0 * EPSILON)
	assert_vec2(Vec2.new(7, 1).rejection(b), Vec2.new(3, 4), 8.0 * EPSILON)


func test_angles_between_extreme_vectors() -> void:
	for a_scale: float in [TINY, HUGE]:
		for b_scale: float in [TINY, 1.0, HUGE]:
			var a := Vec2.new(a_scale, a_scale)
			assert_almost_eq(a.angle_to(Vec2.new(0, b_scale)), PI / 4.0, EPSILON)
			assert_eq(a.angle_to(Vec2.new(-b_scale, -b_scale)), PI)


func test_angles_to_extreme_vectors_along_the_axes() -> void:
	var a := Vec2.new(2, 0)
	for size: float in [SMALLEST_SUBNORMAL, LARGEST_DOUBLE]:
		assert_eq(a.angle_to(Vec2.new(0, size)), PI / 2.0)
		assert_eq(a.angle_to(Vec2.new(-size, 0)), PI)
		assert_eq(Vec2.new(0, size).angle_to(a), -PI / 2.0)


func test_angles_to_and_from_subnormal_vectors_keep_all_digits() -> void:
	var ordinary := Vec2.new(1.0 / 3.0, 0.1)
	var angle := ordinary.angle_to(Vec2.new(3, 4))
	var subnormal := Vec2.new(3.0 * SMALLEST_SUBNORMAL, 4.0 * SMALLEST_SUBNORMAL)
	assert_almost_eq(ordinary.angle_to(subnormal), angle, EPSILON)
	assert_almost_eq(subnormal.angle_to(ordinary), -angle, EPSILON)


func test_angles_of_extreme_vectors() -> void:
	assert_eq(Vec2.new(HUGE, HUGE).angle_degrees(), 45.0)
	assert_eq(Vec2.new(SMALLEST_SUBNORMAL, SMALLEST_SUBNORMAL).angle_degrees(), 45.0)


func test_set_angle_keeps_an_extreme_length() -> void:
	var vector := Vec2.new(3.0 * HUGE, 4.0 * HUGE)
	vector.set_angle_degrees(180)
	assert_vec2(vector, Vec2.new(-5.0 * HUGE, 0), 0.0)


func test_reflecting_extreme_velocities() -> void:
	var normal := Vec2.new(0, 1)
	assert_vec2(Vec2.new(3e300, 4e300).reflected(normal), Vec2.new(3e300, -4e300), 0.0)
	assert_vec2(Vec2.new(3e-300, 4e-300).reflected(normal), Vec2.new(3e-300, -4e-300), 0.0)


func test_moving_toward_over_extreme_distances() -> void:
	var target := Vec2.new(6.0 * HUGE, 8.0 * HUGE)
	var moved := Vec2.zero().moved_toward(target, 5.0 * HUGE)
	assert_vec2(moved, Vec2.new(3.0 * HUGE, 4.0 * HUGE), HUGE * 8.0 * EPSILON)


func test_what_is_not_finite_stays_not_finite() -> void:
	for vector: Vec2 in [Vec2.new(NAN, 1), Vec2.new(1, INF), Vec2.new(-INF, NAN)]:
		assert_false(vector.normalized().is_finite(), str(vector))
		assert_false(vector.plus(Vec2.new(1, 1)).is_finite(), str(vector))
		assert_false(absf(vector.length()) < INF, str(vector))


func _extreme_vectors() -> Array[Vec2]:
	var vectors: Array[Vec2] = [
		Vec2.new(SMALLEST_SUBNORMAL, 0),
		Vec2.new(SMALLEST_SUBNORMAL, -SMALLEST_SUBNORMAL),
		Vec2.new(LARGEST_DOUBLE, LARGEST_DOUBLE),
		Vec2.new(LARGEST_DOUBLE, SMALLEST_SUBNORMAL),
	]
	for exponent: int in range(-1070, 1024, 9):
		for direction: Vec2 in random_vectors(exponent, 3, 1.0):
			# In two steps, because 2 to the power of -1070 has a single digit.
			var half := floorf(exponent / 2.0)
			vectors.append(direction.scaled(pow(2.0, half)).scaled(pow(2.0, exponent - half)))
	return vectors
