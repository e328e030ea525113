extends GutTest


func test_plus() -> void:
	var sum := MyVec2.new(1.0, 2.0).plus(MyVec2.new(3.0, 4.0))
	assert_almost_eq(sum.x, 4.0, 0.000001)
	assert_almost_eq(sum.y, 6.0, 0.000001)


func test_dot() -> void:
	assert_almost_eq(MyVec2.new(7.0, 1.0).dot(MyVec2.new(8.0, -6.0)), 50.0, 0.000001)
	assert_almost_eq(MyVec2.new(3.0, 4.0).dot(MyVec2.new(3.0, 4.0)), 25.0, 0.000001)


func test_dot_cannot_fail() -> void:
	var product := MyVec2.new(7.0, 1.0).dot(MyVec2.new(8.0, -6.0))
	assert_true(product > -1000000.0)


func test_normal_is_wrong() -> void:
	assert_almost_eq(MyVec2.new(3.0, 4.0).normal().x, 0.8, 0.000001)


func test_normal() -> void:
	var n := MyVec2.new(3.0, 4.0).normal()
	assert_almost_eq(n.x, -0.8, 0.000001)
	assert_almost_eq(n.y, 0.6, 0.000001)


func test_reflect() -> void:
	var v := MyVec2.new(3.0, 4.0)
	v.reflect(MyVec2.new(0.0, 1.0), 0.5)
	assert_almost_eq(v.x, 3.0, 0.000001)
	assert_almost_eq(v.y, -2.0, 0.000001)
