extends "res://addons/gut/hook_script.gd"
## Runs after the last test and finds what the runner itself lets pass: scripts that were not run,
## tests without an assert, orphan nodes, errors and warnings that no test expected. Sets the exit
## code, and leaves `build/test/report.txt` to `./lab test`: `passed N`, then a line `problem TEXT`
## for each thing that is wrong.

const REPORT := "res://build/test/report.txt"
## How the runner ends a failure's text.
const AT_LINE := "  at line "
# A student's own tests are run by the workshop's kit.
const _OF_THE_WORKSHOP := "res://workshop/"

var _passed := 0
var _problems := PackedStringArray()


func run() -> void:
	print("=== last test")
	_look_at_tests()
	_look_for_scripts_not_run()
	_look_at_engine_messages()
	_look_at_runner_warnings()
	_look_for_orphans()
	if _passed == 0:
		_problems.append("no test passed")
	_write()
	set_exit_code(0 if _problems.is_empty() else 1)


func _write() -> void:
	var file := FileAccess.open(REPORT, FileAccess.WRITE)
	file.store_line("passed %d" % _passed)
	for problem: String in _problems:
		var line := " ".join(problem.split("\n", false)).replace("res://", "")
		file.store_line("problem " + line.strip_edges())


func _look_for_orphans() -> void:
	for id: int in Node.get_orphan_node_ids():
		_problems.append("an orphan node was left: %s" % instance_from_id(id))


# What the runner offers is untyped in GUT, so it is asked by name here and nowhere else.
@warning_ignore_start("unsafe_method_access", "unsafe_property_access", "unsafe_call_argument")


func _look_at_tests() -> void:
	for script: Variant in gut.get_test_collector().scripts:
		if script.was_skipped and OS.get_name() != "Windows":
			_problems.append("%s was skipped" % script.path)
		for test: Variant in script.setup_teardown_tests + script.tests:
			if test.was_run:
				_look_at_test(script.path, test)


func _look_at_test(path: String, test: Variant) -> void:
	if test.is_failing():
		_problems.append("%s %s: %s" % [_place_of(path, test), test.name, _first_failure_of(test)])
	elif test.is_pending():
		_problems.append("%s %s is pending: %s" % [path, test.name, test.pending_texts[0]])
	elif not test.is_passing():
		_problems.append("%s %s asserts nothing" % [path, test.name])
	elif test.name.begins_with("test_"):
		_passed += 1


func _first_failure_of(test: Variant) -> String:
	var text: String = test.fail_texts[0].get_slice(AT_LINE, 0).strip_edges()
	var others: int = test.fail_texts.size() - 1
	return text if others == 0 else "%s (and %d more)" % [text, others]


## The file and line of the first failure.
func _place_of(path: String, test: Variant) -> String:
	var line: int = test.fail_texts[0].get_slice(AT_LINE, 1).to_int()
	if line > 0:
		return "%s:%d" % [path, line]
	for id: String in gut.error_tracker.errors.items:
		if id.begins_with("%s:%s" % [path.get_file(), test.name]):
			return _origin_of(gut.error_tracker.errors.items[id][0])
	return path


## Where a message comes from: the innermost line of GDScript, else the engine's own source.
func _origin_of(message: Variant) -> String:
	for trace: Variant in message.backtrace:
		if trace is ScriptBacktrace and trace.get_frame_count() > 0:
			return "%s:%d" % [trace.get_frame_file(0), trace.get_frame_line(0)]
	return "%s:%d" % [message.file, message.line]


func _look_for_scripts_not_run() -> void:
	var tests_of := {}
	for script: Variant in gut.get_test_collector().scripts:
		if script.was_run or script.was_skipped:
			tests_of[script.path] = tests_of.get(script.path, 0) + script.tests.size()
	for path: String in ScriptsOnDisk.tests_below("res://"):
		if path.begins_with(_OF_THE_WORKSHOP):
			continue
		if not tests_of.has(path):
			if RunOptions.asks_for(path):
				_problems.append("%s was not run: it does not parse, or lies outside tests/" % path)
		elif tests_of[path] == 0:
			_problems.append("%s holds no test" % path)


## Unexpected errors fail their test; left are warnings, and errors outside a test.
func _look_at_engine_messages() -> void:
	for id: String in gut.error_tracker.errors.items:
		for message: Variant in gut.error_tracker.errors.items[id]:
			if not message.handled and (message.is_push_warning() or not id.contains(":test_")):
				_problems.append("%s unexpected message: %s" % [_origin_of(message), message.code])


func _look_at_runner_warnings() -> void:
	for text: String in gut.logger.get_warnings() + gut.logger.get_deprecated():
		if not text.begins_with("Ignoring script"):
			_problems.append("the test runner warns: " + text)
