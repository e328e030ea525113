extends LabTest
## `./lab test` itself: whatever is wrong turns it red, under GUT as well as under its stand-in.
## Each test runs one folder of cases/ in a small project, with the runner that runs this test.

const PROJECT := "res://build/runner_test"

var _last_line := ""
var _output := ""


func before_all() -> void:
	var script := ProjectSettings.globalize_path("res://tests/integration/runner/make_project.sh")
	OS.execute("bash", [script, ProjectSettings.globalize_path(PROJECT)])


func test_asserts_that_hold_are_green() -> void:
	assert_eq(_run("good"), 0)
	assert_eq(_last_line, "17 passed, 0 failed")


func test_each_assert_can_fail_and_names_its_line() -> void:
	assert_eq(_run("failing"), 1)
	assert_string_starts_with(_last_line, "0 passed, ")
	assert_eq(_output.count("cases/failing/test_asserts_fail.gd:"), _count_failing_cases())
	assert_string_contains(_output, "test_asserts_fail.gd:8 test_eq: [1] expected")


func test_a_test_without_an_assert_is_red() -> void:
	assert_eq(_run("no_assert"), 1)
	assert_string_contains(_output, "test_that_does_not asserts nothing")
	assert_string_starts_with(_last_line, "1 passed, ")


func test_a_script_that_does_not_parse_is_red() -> void:
	assert_eq(_run("no_parse"), 1)
	assert_string_contains(_output, "test_no_parse.gd was not run")
	assert_string_starts_with(_last_line, "1 passed, ")


func test_an_error_that_no_test_expects_is_red() -> void:
	assert_eq(_run("unexpected_error"), 1)
	assert_string_contains(_output, "test_unexpected_error.gd:5")


func test_a_warning_outside_of_a_test_is_red() -> void:
	assert_eq(_run("unexpected_warning"), 1)
	assert_string_contains(_output, "test_unexpected_warning.gd:5 unexpected message")


func test_a_forgotten_node_is_red() -> void:
	assert_eq(_run("orphan"), 1)
	assert_string_contains(_output, "an orphan node was left")


func test_a_pending_test_is_red() -> void:
	assert_eq(_run("pending"), 1)
	assert_string_contains(_output, "test_to_come is pending: not yet")


func test_no_test_at_all_is_red() -> void:
	assert_eq(_run("nothing"), 1)
	assert_string_starts_with(_last_line, "0 passed, ")


func test_selecting_what_is_not_there_is_red() -> void:
	assert_eq(_run("good", ["-gselect=not_there"]), 1)
	assert_string_starts_with(_last_line, "0 passed, ")


func test_selecting_one_test_runs_only_that() -> void:
	assert_eq(_run("good", ["-gunit_test_name=test_signal"]), 0)
	assert_eq(_last_line, "1 passed, 0 failed")


## Runs the tests of one folder and returns the exit code.
func _run(folder: String, options: PackedStringArray = []) -> int:
	var lab := ProjectSettings.globalize_path(PROJECT.path_join("lab"))
	var arguments: PackedStringArray = [
		"GODOT=" + OS.get_executable_path(), "GUT_REPO=" + _repository(), lab, "test"
	]
	arguments.append("-gdir=res://cases/" + folder)
	var said := []
	var code := OS.execute("env", arguments + options, said, true)
	_output = said[0]
	var lines := _output.strip_edges().split("\n")
	_last_line = lines[lines.size() - 1]
	return code


## Keeps the small project on the runner that runs this test.
func _repository() -> String:
	var plugin := FileAccess.get_file_as_string("res://addons/gut/plugin.cfg")
	return "none" if plugin.contains("stand-in") else ""


func _count_failing_cases() -> int:
	var path := "res://tests/integration/runner/cases/failing/asserts_fail.gd"
	return FileAccess.get_file_as_string(path).count("func test_")
