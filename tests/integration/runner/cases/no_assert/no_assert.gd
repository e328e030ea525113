extends "res://addons/gut/test.gd"


func test_that_asserts() -> void:
	assert_true(true)


func test_that_does_not() -> void:
	pass
