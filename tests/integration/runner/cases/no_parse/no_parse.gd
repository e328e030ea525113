extends GutTest


func test_of_something_unknown() -> void:
	assert_eq(this_name_is_unknown, 1)
