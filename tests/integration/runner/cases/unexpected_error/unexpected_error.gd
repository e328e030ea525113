extends "res://addons/gut/test.gd"


func test_with_an_error_that_it_does_not_expect() -> void:
	push_error("nobody expects this")
	assert_true(true)
