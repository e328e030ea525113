extends LabTest
## The check for dropped refusals, as `./lab lint` runs it, in a small project with one script.

const PROJECT := "res://build/refusal_check_test"
const CHECK := "tools/checks/check_refusals.gd"
const SCRIPT_TEXT := """extends Node
func f() -> void:
	%s
func set_size(size: int) -> String:
	return "" if size > 0 else "The size must be above 0."
func count() -> int:
	return 1
"""


func before_all() -> void:
	DirAccess.make_dir_recursive_absolute(PROJECT.path_join(CHECK.get_base_dir()))
	DirAccess.copy_absolute("res://".path_join(CHECK), PROJECT.path_join(CHECK))
	var settings := FileAccess.open(PROJECT.path_join("project.godot"), FileAccess.WRITE)
	settings.store_line("config_version=5")


func test_a_dropped_refusal_is_found_with_its_place() -> void:
	_assert_check("set_size(1)", 1, "script.gd:3: the answer of set_size() is dropped")


func test_a_refusal_dropped_in_a_lambda_is_found() -> void:
	_assert_check("(func() -> void: set_size(1)).call()", 1, "1 dropped")


func test_a_refusal_that_is_passed_on_is_no_finding() -> void:
	_assert_check("print(set_size(1))", 0, "2 scripts, 0 dropped")


func test_an_answer_that_is_no_string_may_be_dropped() -> void:
	_assert_check("count()", 0, "2 scripts, 0 dropped")


func _assert_check(statement: String, exit_code: int, part_of_output: String) -> void:
	var script := FileAccess.open(PROJECT.path_join("script.gd"), FileAccess.WRITE)
	script.store_string(SCRIPT_TEXT % statement)
	script.close()
	var folder := ProjectSettings.globalize_path(PROJECT)
	var arguments: PackedStringArray = ["--headless", "--path", folder, "-s", CHECK]
	var said := []
	assert_eq(OS.execute(OS.get_executable_path(), arguments, said, true), exit_code)
	var output: String = said[0]
	assert_string_contains(output, part_of_output)
