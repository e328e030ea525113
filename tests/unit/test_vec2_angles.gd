extends LabTest
## Reading angles: of one vector, and between two.


func test_the_angles_of_the_axes_are_exact() -> void:
	assert_eq(Vec2.new(7, 0).angle_degrees(), 0.0)
	assert_eq(Vec2.new(0, 7).angle_degrees(), 90.0)
	assert_eq(Vec2.new(-7, 0).angle_degrees(), 180.0)
	assert_eq(Vec2.new(0, -7).angle_degrees(), -90.0)


func test_the_angles_of_the_diagonals() -> void:
	assert_almost_eq(Vec2.new(1, 1).angle_degrees(), 45.0, 1e-14)
	assert_almost_eq(Vec2.new(-1, -1).angle_degrees(), -135.0, 1e-13)
	assert_almost_eq(Vec2.new(-1, 1).angle_radians(), 0.75 * PI, 1e-15)


func test_the_angle_is_in_radians_where_the_name_says_so() -> void:
	assert_eq(Vec2.new(0, 3).angle_radians(), PI / 2.0)
	assert_eq(Vec2.new(-3, 0).angle_radians(), PI)


func test_the_angle_is_never_minus_180() -> void:
	for down: float in [0.0, negative_zero(), -1e-20, -1e-300, -SMALLEST_SUBNORMAL]:
		assert_eq(Vec2.new(-1, down).angle_degrees(), 180.0)
		assert_eq(Vec2.new(-1, down).angle_radians(), PI)


func test_the_angle_just_above_minus_180_is_kept() -> void:
	var angle := Vec2.new(-1, -1e-15).angle_degrees()
	assert_gt(angle, -180.0)
	assert_lt(angle, -179.9999999999)


func test_the_angle_of_a_zero_vector_is_zero() -> void:
	var zero_components: Array[float] = [0.0, negative_zero()]
	for across: float in zero_components:
		for down: float in zero_components:
			assert_eq(Vec2.new(across, down).angle_radians(), 0.0)


func test_the_angle_of_the_x_axis_is_never_negative_zero() -> void:
	assert_true(same_bits(Vec2.new(1, negative_zero()).angle_radians(), 0.0))
	assert_true(same_bits(Vec2.new(1, 0).angle_to(Vec2.new(1, negative_zero())), 0.0))


func test_turning_by_quarters_never_leaves_the_range() -> void:
	var vector := Vec2.new(3, 0)
	for wanted: float in [90.0, 180.0, -90.0, 0.0, 90.0, 180.0]:
		vector.rotate_degrees(90)
		assert_eq(vector.angle_degrees(), wanted)


func test_turning_by_radians_never_leaves_the_range() -> void:
	for steps: int in range(-40, 41):
		var vector := Vec2.new(1, 0)
		vector.rotate_radians(steps * PI / 4.0)
		assert_true(vector.angle_radians() > -PI and vector.angle_radians() <= PI)


func test_the_angle_to_another_vector_is_signed() -> void:
	assert_eq(Vec2.new(2, 0).angle_to(Vec2.new(0, 3)), PI / 2.0)
	assert_eq(Vec2.new(0, 3).angle_to(Vec2.new(2, 0)), -PI / 2.0)


func test_the_angle_between_opposite_vectors_is_plus_180() -> void:
	assert_eq(Vec2.new(3, 4).angle_to(Vec2.new(-3, -4)), PI)
	assert_eq(Vec2.new(-3, -4).angle_to(Vec2.new(3, 4)), PI)
	assert_eq(Vec2.new(1, 0).angle_to(Vec2.new(-1, -1e-20)), PI)


func test_the_angle_to_is_the_shortest_way() -> void:
	# From 170 to -170 degrees it is 20 degrees on, not 340 back.
	var angle := Vec2.unit_degrees(170).angle_to(Vec2.unit_degrees(-170))
	assert_almost_eq(angle, 20.0 * PI / 180.0, 1e-15)


func test_rotating_by_the_angle_to_points_along_the_other() -> void:
	var errors := PackedFloat64Array()
	var vectors := random_vectors(61, 200)
	for index: int in range(0, 200, 2):
		var vector := vectors[index]
		vector.rotate_radians(vector.angle_to(vectors[index + 1]))
		var unit := vectors[index + 1].normalized()
		errors.append(vector.normalized().distance_to(unit))
	assert_all_at_most(errors, 1e-15)


func test_the_angle_to_or_from_a_zero_vector_is_zero() -> void:
	assert_eq(Vec2.zero().angle_to(Vec2.new(-1, -2)), 0.0)
	assert_eq(Vec2.new(-1, -2).angle_to(Vec2.zero()), 0.0)
	assert_eq(Vec2.new(-1, -2).angle_to(Vec2.zero().negated()), 0.0)


func test_degrees_become_radians_and_back() -> void:
	assert_eq(Vec2.deg_to_rad(180), PI)
	assert_eq(Vec2.rad_to_deg(PI / 2.0), 90.0)
	assert_almost_eq(Vec2.rad_to_deg(Vec2.deg_to_rad(-1234.5)), -1234.5, 1e-12)
