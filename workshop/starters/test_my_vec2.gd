extends "res://addons/gut/test.gd"
## Exercise 12: your tests of MyVec2. The lab runs them on a right MyVec2, where they must be green,
## and on wrong ones, where they must be red.


func test_plus() -> void:
	var sum := MyVec2.new(1.0, 2.0).plus(MyVec2.new(3.0, 4.0))
	assert_almost_eq(sum.x, 4.0, 0.000001)
	assert_almost_eq(sum.y, 6.0, 0.000001)


func test_dot() -> void:
	pass
