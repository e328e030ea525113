extends "res://addons/gut/test.gd"


func test_that_passes() -> void:
	assert_true(true)
