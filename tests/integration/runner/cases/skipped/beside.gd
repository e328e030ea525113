extends GutTest


func test_that_passes() -> void:
	assert_true(true)
