extends LabTest
## What the list of mistakes calls each.


func test_a_mistake_of_the_course_has_its_number() -> void:
	assert_eq(_heading(30), "Mistake 30: x and y swapped")


func test_one_that_only_the_lecture_names_has_its_part() -> void:
	assert_eq(_heading(-2), "Part 2: x and y swapped")


func test_any_other_one_has_no_number() -> void:
	assert_eq(_heading(MistakeInfo.BEYOND_THE_COURSE), "X and y swapped")


func _heading(number: int) -> String:
	return MistakeInfo.new(number, "x and y swapped", "", "").heading()
