extends "res://addons/gut/test.gd"


func test_that_passes() -> void:
	assert_true(true)


func test_to_come() -> void:
	pending("not yet")
