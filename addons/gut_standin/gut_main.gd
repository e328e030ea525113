extends Node
## Runs the collected tests one after the other, as GUT does.

const CollectedScript := preload("collected_script.gd")
const CollectedTest := preload("collected_test.gd")
const ErrorTracker := preload("error_tracker.gd")
const HookScript := preload("hook_script.gd")
const JunitWriter := preload("junit_writer.gd")
const CommandLine := preload("command_line.gd")
const ParameterHandler := preload("parameter_handler.gd")
const RunnerLog := preload("runner_log.gd")
const RunSummary := preload("run_summary.gd")
const TestScript := preload("test.gd")
const TestCollector := preload("test_collector.gd")

var options: CommandLine
var error_tracker := ErrorTracker.new()
var logger := RunnerLog.new()
## Set while a test with parameters runs.
var parameter_handler: ParameterHandler

var _collector := TestCollector.new()
var _current: CollectedTest
var _known_orphans := {}
var _to_free: Array[Object] = []
var _to_queue_free: Array[Node] = []


func get_test_collector() -> TestCollector:
	return _collector


func p(value: Variant, _level := 0) -> void:
	logger.show(str(value))


## Runs everything and returns the exit code.
func run() -> int:
	_collect()
	OS.add_logger(error_tracker)
	var hook_code := await _run_hook(options.text("pre_run_script"))
	for script: CollectedScript in _collector.scripts:
		if _is_asked_for(script):
			await _run_script(script)
	# What was queued to be freed is no orphan.
	await get_tree().process_frame
	hook_code = await _run_hook(options.text("post_run_script"))
	OS.remove_logger(error_tracker)
	var failed := RunSummary.show(_collector.scripts)
	if not options.text("junit_xml_file").is_empty():
		JunitWriter.write(_collector.scripts, options.text("junit_xml_file"))
	queue_free()
	return hook_code if hook_code >= 0 else mini(failed, 1)


func add_pass(text: String) -> void:
	if _current != null:
		_current.pass_texts.append(text)


func add_fail(text: String) -> void:
	var line := _line_of_test()
	var full_text := "%s\n      at line %d" % [text, line]
	logger.show("[Failed]:  " + full_text)
	if _current != null:
		_current.fail_texts.append(full_text)


func add_pending(text: String) -> void:
	logger.show("[Pending]:  " + text)
	if _current != null:
		_current.pending_texts.append(text)


func free_after_test(thing: Object) -> void:
	if thing is not RefCounted:
		_to_free.append(thing)


func queue_free_after_test(node: Node) -> void:
	_to_queue_free.append(node)


## The orphan nodes that were not there before.
func new_orphans() -> Array[int]:
	var found: Array[int] = []
	for id: int in Node.get_orphan_node_ids():
		if not _known_orphans.has(id):
			found.append(id)
	return found


func _collect() -> void:
	for folder: String in options.texts("dirs"):
		if not folder.is_empty():
			_collector.add_folder(
				folder,
				options.text("prefix"),
				options.text("suffix"),
				options.flag("include_subdirs"),
				options.text("selected")
			)
	for path: String in options.texts("tests"):
		_collector.add_script(path)


func _is_asked_for(script: CollectedScript) -> bool:
	return options.admits("selected", script.path.get_file())


func _run_hook(path: String) -> int:
	if path.is_empty():
		return -1
	var hook: HookScript = (load(path) as GDScript).new()
	hook.gut = self
	@warning_ignore("redundant_await")
	await hook.run()
	return hook.get_exit_code()


func _run_script(script: CollectedScript) -> void:
	if not options.admits("inner_class", script.inner_class):
		script.tests.clear()
		return
	logger.heading(script.full_name(), script.tests.size())
	var instance: TestScript = script.source.new()
	instance.gut = self
	add_child(instance)
	if instance.should_skip_script():
		script.was_skipped = true
		logger.show("- [Script skipped]")
	else:
		script.was_run = true
		await _run_around(script, instance.before_all, "before_all")
		for test: CollectedTest in script.tests:
			if options.admits("unit_test_name", test.name):
				await _run_test(script, instance, test)
		await _run_around(script, instance.after_all, "after_all")
	remove_child(instance)
	instance.queue_free()


func _run_around(script: CollectedScript, method: Callable, its_name: String) -> void:
	_current = CollectedTest.new()
	_current.name = its_name
	script.setup_teardown_tests.append(_current)
	await method.call()
	_current.was_run = _current.assert_count() > 0 or not _current.pending_texts.is_empty()
	_current = null


func _run_test(script: CollectedScript, instance: TestScript, test: CollectedTest) -> void:
	var begun := Time.get_ticks_usec()
	var id := "%s:%s" % [script.file_and_inner_class(), test.name]
	logger.show("* " + test.name)
	_current = test
	test.was_run = true
	parameter_handler = null
	await _run_once(instance, test.name, id)
	if test.takes_parameters:
		if parameter_handler == null:
			add_fail("The test has a parameter, but no use_parameters as its default.")
		while parameter_handler != null and not parameter_handler.is_done():
			await _run_once(instance, test.name, "%s[%d]" % [id, parameter_handler.count])
	parameter_handler = null
	if test.assert_count() == 0 and test.pending_texts.is_empty():
		logger.show("[Risky]:  %s did not assert" % test.name)
	test.seconds = (Time.get_ticks_usec() - begun) / 1e6
	_current = null


func _run_once(instance: TestScript, test_name: String, id: String) -> void:
	for orphan: int in Node.get_orphan_node_ids():
		_known_orphans[orphan] = true
	@warning_ignore("redundant_await")
	await instance.before_each()
	error_tracker.start_test(id)
	await instance.call(test_name)
	var unexpected := error_tracker.unexpected_errors()
	if not unexpected.is_empty():
		add_fail("Unexpected Errors:\n" + "\n".join(unexpected))
	error_tracker.end_test()
	instance.clear_signal_watcher()
	@warning_ignore("redundant_await")
	await instance.after_each()
	await _free_what_the_test_made()
	for orphan: int in new_orphans():
		logger.show("[Orphan]:  %s" % instance_from_id(orphan))


func _free_what_the_test_made() -> void:
	for thing: Object in _to_free:
		if is_instance_valid(thing):
			thing.free()
	_to_free.clear()
	if _to_queue_free.is_empty():
		return
	for node: Node in _to_queue_free:
		if is_instance_valid(node):
			node.queue_free()
	_to_queue_free.clear()
	await get_tree().process_frame


## The line of the running test's own function.
func _line_of_test() -> int:
	for frame: Dictionary in get_stack():
		if _current != null and frame["function"] == _current.name:
			return frame["line"]
	return -1
