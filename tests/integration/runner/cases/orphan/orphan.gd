extends "res://addons/gut/test.gd"


func test_that_forgets_a_node() -> void:
	var node := Node.new()
	assert_not_null(node)
