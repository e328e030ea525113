extends LabTest
## What the judge says of a student's own tests: what they find, what cannot fail, what is red on
## the right class.

const Judging := preload("res://tools/grading/judging.gd")
# Under another name than that of a test: else it would run as one of ours.
const _TESTS := "res://tests/data/hand_in_tests/my_vec2_test.gd"
const _FOLDER := "user://hand_in_tests"


func before_each() -> void:
	DirAccess.make_dir_recursive_absolute(_FOLDER)
	DirAccess.copy_absolute(_TESTS, _FOLDER.path_join("test_my_vec2.gd"))


func test_a_student_s_tests_are_told_what_they_are_worth() -> void:
	var judging := Judging.new(_FOLDER)
	judging.judge()
	var told := judging.report.tests
	assert_not_null(told)
	assert_true(told.is_complete)
	assert_eq(told.is_by_gut, WorkshopTestRun.is_by_gut())
	assert_eq(told.unreadable, PackedStringArray())
	assert_eq(told.never_red, PackedStringArray(["test_dot_cannot_fail"]))
	assert_eq(told.red_on_right.size(), 1)
	assert_true(told.red_on_right[0].begins_with("test_normal_is_wrong: "))
	assert_eq(told.test_names.size(), 6)
	_assert_tells(told.found, "normal: It is the opposite normal")
	_assert_tells(told.found, "dot: The two products are subtracted")
	_assert_tells(told.missed, "dot: dot changes what it was given")
	_assert_tells(told.missed, "rotate: y is computed with the x")


func _assert_tells(list: PackedStringArray, begin: String) -> void:
	for told in list:
		if told.begins_with(begin):
			pass_test(begin)
			return
	fail_test("%s is not told" % begin)
