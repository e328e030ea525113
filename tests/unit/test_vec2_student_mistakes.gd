extends LabTest
## Wrong answers found in students' own vector classes, each with the right one that Vec2 gives.


func test_mistake_1_rotating_with_the_already_changed_x() -> void:
	var vector := Vec2.new(2, 5)
	vector.rotate_degrees(90)
	assert_vec2(vector, Vec2.new(-5, 2), 0.0, "wrong: (-5, -5)")


func test_mistake_2_and_3_rotating_around_a_point_without_moving_back() -> void:
	var position := Vec2.new(2, 5)
	position.rotate_around_degrees(Vec2.new(2, 1), 90)
	assert_vec2(position, Vec2.new(-2, 1), 0.0, "wrong: (-7, 1) and (-4, 0)")


func test_mistake_4_degrees_where_radians_belong() -> void:
	var by_radians := Vec2.new(2, 5)
	by_radians.rotate_radians(PI / 2.0)
	assert_vec2(by_radians, Vec2.new(-5, 2), 1e-15)
	var by_degrees := Vec2.new(2, 5)
	by_degrees.rotate_degrees(PI / 2.0)
	assert_gt(by_degrees.distance_to(by_radians), 7.0)


func test_mistake_6_a_zero_vector_normalized_to_nan() -> void:
	assert_vec2(Vec2.new(0, 0).normalized(), Vec2.new(0, 0), 0.0)


func test_mistake_7_the_length_cut_to_a_whole_number() -> void:
	assert_vec2(Vec2.new(0.3, 0.4).normalized(), Vec2.new(0.6, 0.8), EPSILON, "wrong: (0, 0)")


func test_mistake_8_a_copy_that_changes_the_vector() -> void:
	var vector := Vec2.new(3, 4)
	vector.normalized().scale(7)
	assert_vec2(vector, Vec2.new(3, 4), 0.0)


func test_mistake_9_the_normal_with_the_wrong_sign_or_swapped() -> void:
	var normal := Vec2.new(3, 1).normal()
	assert_vec2(normal.scaled(sqrt(10.0)), Vec2.new(-1, 3), 1e-15, "wrong: (1, -3) and (1, 3)")


func test_mistake_10_a_projection_on_a_vector_that_was_not_normalized() -> void:
	var a := Vec2.new(7, 1)
	var b := Vec2.new(8, -6)
	assert_eq(a.scalar_projection(b), 5.0, "wrong: 50")
	assert_vec2(a.vector_projection(b), Vec2.new(4, -3), 0.0, "wrong: (400, -300)")


func test_mistake_11_reflecting_with_a_normal_that_is_not_unit() -> void:
	var velocity := Vec2.new(3, 4)
	velocity.reflect(Vec2.new(0, 2))
	assert_vec2(velocity, Vec2.new(3, 4), 0.0, "wrong: (3, -28)")
	assert_push_error("the normal must have length 1, but has length 2.0.")
	velocity.reflect(Vec2.new(0, 2).normalized())
	assert_vec2(velocity, Vec2.new(3, -4), 0.0)


func test_mistake_12_taking_the_normal_of_the_normal() -> void:
	assert_vec2(Vec2.new(3, 4).reflected(Vec2.new(0, 1)), Vec2.new(3, -4), 0.0, "wrong: (-3, 4)")


func test_mistake_13_bounciness_on_the_tangent() -> void:
	var velocity := Vec2.new(3, 4).reflected(Vec2.new(0, 1), 0.5)
	assert_vec2(velocity, Vec2.new(3, -2), 0.0, "wrong: (1.5, -4)")


func test_mistake_29_a_stored_angle_goes_stale() -> void:
	var vector := Vec2.new(5, 0)
	vector.set_angle_degrees(90)
	vector.x = 3
	vector.y = 4
	assert_almost_eq(vector.angle_radians(), atan2(4, 3), 1e-15)
	vector.set_angle_degrees(180)
	assert_vec2(vector, Vec2.new(-5, 0), 0.0)


func test_mistake_30_the_arguments_of_atan2_swapped() -> void:
	assert_eq(Vec2.new(1, 0).angle_degrees(), 0.0, "wrong: 90")
	assert_eq(Vec2.new(0, 1).angle_degrees(), 90.0, "wrong: 0")


func test_mistake_32_the_old_position_shares_the_object() -> void:
	var position := Vec2.new(1, 2)
	var old := position.copy()
	position.add(Vec2.new(10, 10))
	assert_vec2(old, Vec2.new(1, 2), 0.0)
