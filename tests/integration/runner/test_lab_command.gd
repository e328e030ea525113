extends LabTest
## `./lab` itself: a wrong request gets one line and exit code 2.

const _PROJECT := "res://build/setup_test"


func should_skip_script() -> bool:
	return not LabCommand.is_possible()


func test_without_a_command_it_lists_the_commands() -> void:
	var lab := LabCommand.run("res://", [])
	assert_eq(lab.exit_code, 0)
	for command: String in [
		"run",
		"new_lesson",
		"test",
		"lint",
		"check",
		"report",
		"stability",
		"bench",
		"needs",
		"pictures",
		"setup",
		"help"
	]:
		assert_string_contains(lab.output, "\n  %s " % command)


func test_help_is_the_same_list() -> void:
	assert_eq(LabCommand.run("res://", ["help"]).output, LabCommand.run("res://", []).output)


func test_an_unknown_command_is_refused_with_the_list() -> void:
	var lab := LabCommand.run("res://", ["tset"])
	assert_eq(lab.exit_code, 2)
	assert_string_starts_with(lab.output, "lab: there is no command 'tset'")
	assert_string_contains(lab.output, "\n  test ")


func test_an_unknown_lesson_is_refused_with_the_ids() -> void:
	for command: String in ["run", "pictures"]:
		var lab := LabCommand.run("res://", [command, "not_there"])
		assert_eq(lab.exit_code, 2)
		assert_string_contains(lab.last_line(), "'not_there'; there are: ")
		assert_string_contains(lab.last_line(), ", ".join(LessonIndex.ids()))


func test_an_id_that_no_new_lesson_can_have_is_refused() -> void:
	var without_id := LabCommand.run("res://", ["new_lesson"])
	assert_eq(without_id.exit_code, 2)
	assert_string_contains(without_id.last_line(), "usage: ./lab new_lesson ID")
	var taken := LabCommand.run("res://", ["new_lesson", "dot_product"])
	assert_eq(taken.exit_code, 2)
	assert_string_contains(taken.last_line(), "there is a lesson 'dot_product' already")


func test_an_unknown_platform_is_refused_with_those_there_are() -> void:
	for arguments: PackedStringArray in [["export"], ["export", "windows"]]:
		var lab := LabCommand.run("res://", arguments)
		assert_eq(lab.exit_code, 2)
		assert_string_contains(lab.last_line(), "usage: ./lab export linux|web|all [--address=")


func test_an_unknown_demo_is_refused_with_the_ids() -> void:
	for arguments: PackedStringArray in [["export", "linux", "not_there"], ["needs", "not_there"]]:
		var lab := LabCommand.run("res://", arguments)
		assert_eq(lab.exit_code, 2)
		assert_string_contains(lab.last_line(), "'not_there'; there are: lab, ")
		assert_string_contains(lab.last_line(), ", ".join(LessonIndex.ids()))


func test_an_unknown_benchmark_is_refused() -> void:
	var lab := LabCommand.run("res://", ["bench", "not_there"])
	assert_eq(lab.exit_code, 2)
	assert_string_contains(lab.last_line(), "usage: ./lab bench NAME; there are: ")


func test_stability_prints_a_line_for_each_case_that_is_asked_for() -> void:
	var lab := LabCommand.run("res://", ["stability", "--quick", "wedge of 60"])
	assert_eq(lab.exit_code, 0)
	assert_string_contains(lab.output, "| pass | A ball shot into a wedge of 60° | 3 bounces")
	assert_string_starts_with(lab.last_line(), "1 passed, 0 failed")


func test_stability_says_so_when_no_case_fits() -> void:
	var lab := LabCommand.run("res://", ["stability", "not_there"])
	assert_eq(lab.exit_code, 2)
	assert_string_contains(lab.last_line(), "no case has 'not_there' in its title")


func test_true_prints_what_a_lesson_says_that_is_false() -> void:
	var lab := LabCommand.run("res://", ["true", "error_and_time", "--states", "2", "--seed", "3"])
	assert_eq(lab.exit_code, 0)
	assert_string_contains(lab.last_line(), "error_and_time: 0 kinds of false lines in 6 formulas")


func test_true_refuses_another_lesson_or_number() -> void:
	var lab := LabCommand.run("res://", ["true", "not_there"])
	assert_eq(lab.exit_code, 2)
	assert_string_contains(lab.last_line(), "there is no lesson 'not_there'; there are: ")
	lab = LabCommand.run("res://", ["true", "--states", "0"])
	assert_eq(lab.exit_code, 2)
	assert_string_contains(lab.last_line(), "--states must be a whole number from 1 to 999999")


func test_random_worlds_are_tried_for_the_time_and_of_the_kind_that_is_asked_for() -> void:
	var lab := LabCommand.run(
		"res://", ["stability", "--fuzz", "0.01", "--seed", "3", "whole_frame"]
	)
	assert_eq(lab.exit_code, 0, lab.output)
	assert_string_starts_with(lab.last_line(), "seed 3: ")
	assert_string_ends_with(lab.last_line(), " worlds tried, 0 with a problem")


func test_random_worlds_of_no_kind_and_no_seed_are_refused() -> void:
	var lab := LabCommand.run("res://", ["stability", "--fuzz", "0.01", "not_there"])
	assert_eq(lab.exit_code, 2)
	assert_string_contains(lab.last_line(), "no kind of worlds has 'not_there' in its name")
	lab = LabCommand.run("res://", ["stability", "--fuzz", "--seed", "0"])
	assert_eq(lab.exit_code, 2)
	assert_string_contains(lab.last_line(), "--seed must be a whole number from 1 to 999999")


func test_an_unknown_option_of_stability_is_refused() -> void:
	var lab := LabCommand.run("res://", ["stability", "--fast"])
	assert_eq(lab.exit_code, 2)
	assert_string_contains(lab.last_line(), "usage: ./lab stability [--quick] [WORD]")


func test_a_godot_that_is_not_there_is_refused() -> void:
	var lab := LabCommand.run("res://", ["setup"], ["GODOT=/not/there"])
	assert_eq(lab.exit_code, 2)
	assert_string_contains(lab.last_line(), "GODOT=/not/there is no program")


func test_a_program_that_is_no_godot_is_refused() -> void:
	var lab := LabCommand.run("res://", ["setup"], ["GODOT=echo"])
	assert_eq(lab.exit_code, 2)
	assert_string_contains(lab.last_line(), "4.5 or newer is needed")


func test_godot_4_6_gets_gut_9_6() -> void:
	assert_string_contains(_wanted_gut("4.6.3.stable.official.1234"), "GUT 9.6.0 (commit 9f3edeb1")


func test_godot_4_7_gets_gut_9_7() -> void:
	for version: String in ["4.7.stable.official.1234", "4.7.1.stable.custom_build"]:
		assert_string_contains(_wanted_gut(version), "GUT 9.7.0 (commit 3e53dbc6")


## What `./lab setup` says of GUT with a Godot that claims to be [param version], where no GUT can
## be had. It runs in a small project of its own, because it puts the stand-in there.
func _wanted_gut(version: String) -> String:
	var make := ProjectSettings.globalize_path("res://tests/integration/runner/make_project.sh")
	var project := ProjectSettings.globalize_path(_PROJECT)
	OS.execute("bash", [make, project])
	var godot := project.path_join("godot")
	FileAccess.open(godot, FileAccess.WRITE).store_string("#!/bin/sh\necho %s\n" % version)
	OS.execute("sh", ["-c", "chmod +x '%s'; rm -r '%s/addons/gut'" % [godot, project]])
	var environment: PackedStringArray = ["GODOT=" + godot, "XDG_CACHE_HOME=" + project]
	environment.append_array(["GUT_REPO=/not/there", "GUT_PUBLIC_REPO=/not/there"])
	var lab := LabCommand.run(_PROJECT, ["setup"], environment)
	assert_eq(lab.exit_code, 0)
	assert_string_contains(lab.last_line(), "GUT stand-in")
	return lab.output
