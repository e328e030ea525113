class_name LabCommand
extends RefCounted
## One run of `./lab`, and what came of it.

var exit_code := -1
## What it printed, errors included.
var output := ""


## False on Windows: test scripts that need `./lab` are skipped there.
static func is_possible() -> bool:
	return OS.get_name() != "Windows"


## Runs `./lab` of [param project], a path in `res://`, with the Godot and the test runner that run
## this. [param environment] holds `NAME=value`, and overrides.
static func run(
	project: String, arguments: PackedStringArray, environment: PackedStringArray = []
) -> LabCommand:
	var words: PackedStringArray = [ProjectSettings.globalize_path(project.path_join("lab"))]
	return run_words(words + arguments, environment)


## The same for a command that calls `./lab` itself.
static func run_words(
	command_words: PackedStringArray, environment: PackedStringArray = []
) -> LabCommand:
	var words: PackedStringArray = ["GODOT=" + OS.get_executable_path(), "GUT_REPO=" + _runner()]
	words.append_array(environment + command_words)
	var command := LabCommand.new()
	var said := []
	command.exit_code = OS.execute("env", words, said, true)
	command.output = said[0]
	return command


func last_line() -> String:
	return output.strip_edges().get_slice("\n", output.strip_edges().count("\n"))


## Empty keeps GUT, which lies in addons/gut already; `none` keeps its stand-in.
static func _runner() -> String:
	var plugin := FileAccess.get_file_as_string("res://addons/gut/plugin.cfg")
	return "none" if plugin.contains("stand-in") else ""
