extends LabTest
## Godot's own check of scripts, as `./lab lint` runs it, in a small project with one script.

const PROJECT := "res://build/script_check_test"
const CHECK := "tools/checks/check_scripts.gd"


func before_all() -> void:
	DirAccess.make_dir_recursive_absolute(PROJECT.path_join(CHECK.get_base_dir()))
	DirAccess.copy_absolute("res://".path_join(CHECK), PROJECT.path_join(CHECK))
	var settings := FileAccess.open(PROJECT.path_join("project.godot"), FileAccess.WRITE)
	settings.store_line("config_version=5")
	settings.store_line("[debug]")
	settings.store_line("gdscript/warnings/untyped_declaration=1")


func test_a_script_without_a_warning_passes() -> void:
	_assert_check("extends Node", 0, "2 scripts, 0 failed")


func test_an_unused_variable_is_found() -> void:
	_assert_check("func f() -> void:\n\tvar x := 1", 1, 'variable "x" is declared but never used')


## At 1000 frames a second the first frame has no physics step, and deferred calls come late.
func test_a_warning_is_found_although_no_physics_step_comes_first() -> void:
	var text := "func f() -> void:\n\tvar x := 1"
	_assert_check(text, 1, "is declared but never used", ["--fixed-fps", "1000"])


func test_a_shadowed_name_is_found() -> void:
	var text := "extends Node\nfunc f(name: String) -> void:\n\tprint(name)"
	_assert_check(text, 1, 'parameter "name" is shadowing')


func test_an_untyped_declaration_is_found() -> void:
	_assert_check("func f():\n\tpass", 1, 'Function "f()" has no static return type')


func test_a_script_that_does_not_parse_is_found() -> void:
	_assert_check("func f() -> void\n\tpass", 1, "Parse Error")


func _assert_check(
	script: String, exit_code: int, part_of_output: String, options: PackedStringArray = []
) -> void:
	FileAccess.open(PROJECT.path_join("script.gd"), FileAccess.WRITE).store_line(script)
	var arguments: PackedStringArray = ["--headless", "--quit-after", "1000", "-s", CHECK]
	arguments.append_array(
		options + PackedStringArray(["--path", ProjectSettings.globalize_path(PROJECT)])
	)
	var said := []
	assert_eq(OS.execute(OS.get_executable_path(), arguments, said, true), exit_code)
	var output: String = said[0]
	assert_string_contains(output, part_of_output)
