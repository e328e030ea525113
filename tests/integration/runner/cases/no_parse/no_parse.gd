extends "res://addons/gut/test.gd"


func test_of_something_unknown() -> void:
	assert_eq(this_name_is_unknown, 1)
