extends LabTest
## A ball between two surfaces.


func test_a_right_angle_holds_with_two_equal_pushes() -> void:
	var half := sqrt(0.5)
	var surfaces := TwoSurfaces.new(Vec2.new(-half, -half), 0.0, 600.0)
	var both := surfaces.pressure_at(7.0 * half, -7.0 * half, 7.0, 0.0)
	assert_almost_eq(both, 2.0 * 600.0 * half, 1e-10)


func test_a_floor_and_a_wall_hold_only_a_ball_that_friction_drives_to_the_wall() -> void:
	var surfaces := TwoSurfaces.new(Vec2.new(0, -1), 0, 600)
	assert_eq(surfaces.pressure_at(-20, 0, 20, 0.0), -1.0)
	assert_eq(surfaces.pressure_at(-20, 0, 20, -0.2), -1.0)
	var both := surfaces.pressure_at(-20, 0, 20, 0.2)
	assert_almost_eq(both, 600.0 * 1.2 / 1.04, 1e-10)


func test_the_order_does_not_matter() -> void:
	var first := TwoSurfaces.new(Vec2.new(0.6, -0.8), 30, 500)
	var one := first.pressure_at(-2.0, -1.0, sqrt(5.0), 0.3)
	var root := 1.0 / sqrt(5.0)
	var second := TwoSurfaces.new(Vec2.new(-2.0 * root, -root), 30, 500)
	var other := second.pressure_at(6.0, -8.0, 10.0, 0.3)
	assert_gt(one, 0.0)
	assert_almost_eq(one, other, 1e-10)
