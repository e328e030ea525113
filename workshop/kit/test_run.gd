class_name WorkshopTestRun
extends RefCounted
## Runs one test script by GUT, or by its stand-in where GUT is not installed.

const _GUT := "res://addons/gut/gut.gd"
const _GUT_ERRORS := "res://addons/gut/error_tracker.gd"
const _STAND_IN := "res://addons/gut_standin/gut_main.gd"
const _STAND_IN_OPTIONS := "res://addons/gut_standin/command_line.gd"

static var _runner: GDScript

## What went wrong in each test, by its name; "" for one that is green.
var failures: Dictionary[String, String] = {}
## The names of the tests without any assert.
var without_assert: PackedStringArray = []


## Whether GUT itself is installed.
static func is_by_gut() -> bool:
	return FileAccess.file_exists(_GUT)


## Loads what runs the tests. That takes longer than the first test, and is not the student's time.
static func load_runner() -> void:
	_runner = load(_GUT if is_by_gut() else _STAND_IN)


## Runs all tests of the script at [param path]; wait for it.
func run(tree: SceneTree, path: String) -> void:
	var runner: Node
	if is_by_gut():
		runner = await _run_by_gut(tree, path)
	else:
		runner = await _run_by_stand_in(tree, path)
	_read(WorkshopAny.object(runner.call("get_test_collector")))
	runner.queue_free()


func _run_by_gut(tree: SceneTree, path: String) -> Node:
	var gut: Node = _runner.callv("new", [])
	gut.set("log_level", 0)
	gut.set("_time_to_wait_for_final_queue_free", 0.0)
	tree.root.add_child(gut)
	(load(_GUT_ERRORS) as GDScript).callv("register_logger", [gut.get("error_tracker")])
	gut.call("add_script", path)
	gut.call("run_tests")
	await Signal(gut, "end_run")
	return gut


func _run_by_stand_in(tree: SceneTree, path: String) -> Node:
	var runner: Node = _runner.callv("new", [])
	var options: Object = (load(_STAND_IN_OPTIONS) as GDScript).callv("new", [])
	var values: Dictionary = options.get("values")
	values.merge({"dirs": [], "tests": [path], "pre_run_script": "", "post_run_script": ""}, true)
	values["junit_xml_file"] = ""
	runner.set("options", options)
	tree.root.add_child(runner)
	@warning_ignore("redundant_await")
	await runner.call("run")
	return runner


func _read(collector: Object) -> void:
	var scripts: Array = collector.get("scripts")
	for script: Object in scripts:
		var tests: Array = script.get("tests")
		for test: Object in tests:
			_read_test(test)


func _read_test(test: Object) -> void:
	var test_name: String = test.get("name")
	var failed := _texts(test.get("fail_texts"))
	var passed := _texts(test.get("pass_texts"))
	failures[test_name] = " ".join(failed[0].split("\n", false)).strip_edges() if failed else ""
	if failed.is_empty() and passed.is_empty():
		without_assert.append(test_name)


# GUT keeps a list, its stand-in a packed one.
static func _texts(kept: Variant) -> PackedStringArray:
	return kept
