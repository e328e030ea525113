extends LabTest
## `./lab test` itself: anything wrong turns it red, under GUT as well as under its stand-in.
## Each test runs one folder of cases/ in a small project, with the runner that runs this test.

const PROJECT := "res://build/runner_test"


func should_skip_script() -> bool:
	return not LabCommand.is_possible()


func before_all() -> void:
	var script := ProjectSettings.globalize_path("res://tests/integration/runner/make_project.sh")
	OS.execute("bash", [script, ProjectSettings.globalize_path(PROJECT)])


func test_asserts_that_hold_are_green() -> void:
	var lab := _run("good")
	assert_eq(lab.exit_code, 0)
	assert_eq(lab.last_line(), "17 passed, 0 failed")


func test_the_slowest_scripts_are_named() -> void:
	var lab := _run("no_assert")
	var line := RegEx.create_from_string(r"\n +\d+\.\d\d s  cases/no_assert/test_no_assert\.gd\n")
	assert_not_null(line.search(lab.output), lab.output)
	assert_string_ends_with(lab.last_line(), " failed")


func test_errors_that_a_test_expects_are_not_shown() -> void:
	var lab := _run("good", ["-gunit_test_name=test_expected"])
	assert_eq(lab.last_line(), "2 passed, 0 failed")
	assert_does_not_have(lab.output.split("\n"), "ERROR: again")


func test_each_assert_can_fail_and_names_its_line() -> void:
	var lab := _run("failing")
	assert_eq(lab.exit_code, 1)
	assert_string_starts_with(lab.last_line(), "0 passed, ")
	assert_string_contains(lab.output, "test_asserts_fail.gd:8 test_eq: [1] expected")
	assert_eq(lab.output.count("\ncases/failing/test_asserts_fail.gd:"), _count_failing_cases())


func test_a_test_without_an_assert_is_red() -> void:
	var lab := _run("no_assert")
	assert_eq(lab.exit_code, 1)
	assert_string_contains(lab.output, "test_that_does_not asserts nothing")
	assert_string_starts_with(lab.last_line(), "1 passed, ")


func test_a_script_that_does_not_parse_is_red() -> void:
	var lab := _run("no_parse")
	assert_eq(lab.exit_code, 1)
	assert_string_contains(lab.output, "test_no_parse.gd was not run")
	assert_string_starts_with(lab.last_line(), "1 passed, ")


func test_an_error_that_no_test_expects_is_red() -> void:
	var lab := _run("unexpected_error")
	assert_eq(lab.exit_code, 1)
	assert_string_contains(lab.output, "test_unexpected_error.gd:5")


func test_a_warning_outside_of_a_test_is_red() -> void:
	var lab := _run("unexpected_warning")
	assert_eq(lab.exit_code, 1)
	assert_string_contains(lab.output, "test_unexpected_warning.gd:5 unexpected message")


func test_a_forgotten_node_is_red() -> void:
	var lab := _run("orphan")
	assert_eq(lab.exit_code, 1)
	assert_string_contains(lab.output, "an orphan node was left")


func test_a_pending_test_is_red() -> void:
	var lab := _run("pending")
	assert_eq(lab.exit_code, 1)
	assert_string_contains(lab.output, "test_to_come is pending: not yet")


func test_a_skipped_script_is_red() -> void:
	var lab := _run("skipped")
	assert_eq(lab.exit_code, 1)
	assert_string_contains(lab.output, "test_skipped.gd was skipped")


func test_no_test_at_all_is_red() -> void:
	var lab := _run("nothing")
	assert_eq(lab.exit_code, 1)
	assert_string_starts_with(lab.last_line(), "0 passed, ")


func test_selecting_what_is_not_there_is_red() -> void:
	var lab := _run("good", ["-gselect=not_there"])
	assert_eq(lab.exit_code, 1)
	assert_string_starts_with(lab.last_line(), "0 passed, ")


func test_selecting_one_test_runs_only_that() -> void:
	var lab := _run("good", ["-gunit_test_name=test_signal"])
	assert_eq(lab.exit_code, 0)
	assert_eq(lab.last_line(), "1 passed, 0 failed")


## Runs the tests of one folder of cases/.
func _run(folder: String, options: PackedStringArray = []) -> LabCommand:
	var arguments: PackedStringArray = ["test", "-gdir=res://cases/" + folder]
	return LabCommand.run(PROJECT, arguments + options)


func _count_failing_cases() -> int:
	var path := "res://tests/integration/runner/cases/failing/asserts_fail.gd"
	return FileAccess.get_file_as_string(path).count("func test_")
