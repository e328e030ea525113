extends "res://addons/gut/test.gd"


func before_all() -> void:
	push_warning("nobody expects this")


func test_that_passes() -> void:
	assert_true(true)
