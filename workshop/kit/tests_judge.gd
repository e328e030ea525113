class_name WorkshopTestsJudge
extends RefCounted
## Judges a student's own tests: they must be green on the right classes, and red on each wrong way
## of the methods that their classes have. Only a child process may use it.

const _PLACE := "res://workshop/judged_test.gd"
## Seconds for one run of a test file; a usual one takes a hundredth of that.
const LONGEST := 2.0
## Seconds for all runs together.
const LONGEST_OF_ALL := 30.0

## What has been found out so far.
var verdict := WorkshopTestsVerdict.new()

var _tree: SceneTree
var _watchdog: WorkshopWatchdog
var _compiler: WorkshopCompiler
var _chameleons: Dictionary[String, String] = {}
var _put_there: GDScript
# For each test that is green on the right classes: its file, and the methods that it calls.
var _file_of_test: Dictionary[String, String] = {}
var _tested: Dictionary[String, PackedStringArray] = {}
var _was_red: Dictionary[String, bool] = {}
# Seconds that the runs took so far.
var _spent := 0.0


## Prepares; see [WorkshopJudge].
func _init(tree: SceneTree, errors: WorkshopHeardErrors, watchdog: WorkshopWatchdog) -> void:
	_tree = tree
	_watchdog = watchdog
	_compiler = WorkshopCompiler.new(errors)
	verdict.is_by_gut = WorkshopTestRun.is_by_gut()


## Judges the tests in these files, by their names; wait for it.
func judge(files: Dictionary[String, PackedByteArray]) -> void:
	for of_class: String in WorkshopFiles.CLASSES.values():
		_chameleons[of_class] = WorkshopChameleon.text_of(of_class)
	WorkshopTestRun.load_runner()
	_allow()
	_compiler.compile(files)
	_watchdog.rest()
	for file in files:
		await _try_on_right_classes(file)
	for task in WorkshopIndex.tasks():
		await _try_wrong_ways(task, files)
	for test_name in _file_of_test:
		if _tested[test_name] and not _was_red.has(test_name):
			verdict.never_red.append(test_name)
	verdict.is_complete = true


func _try_on_right_classes(file: String) -> void:
	if not _put(file):
		var problem := _compiler.problems[file]
		verdict.unreadable.append("%s, %d: %s" % [file, problem.line, problem.sentence])
		return
	var run := await _run()
	for test_name in run.failures:
		verdict.test_names.append(test_name)
		if run.failures[test_name]:
			verdict.red_on_right.append("%s: %s" % [test_name, run.failures[test_name]])
		elif test_name in run.without_assert:
			verdict.never_red.append(test_name)
		else:
			_file_of_test[test_name] = file
			_tested[test_name] = _methods_in(_compiler.codes[file], test_name)


func _try_wrong_ways(task: WorkshopTask, files: Dictionary[String, PackedByteArray]) -> void:
	var names_its_class := false
	var testing: PackedStringArray = []
	for file in files:
		names_its_class = names_its_class or _names(_compiler.codes[file], task.home)
		if _names(_compiler.codes[file], task.method):
			testing.append(file)
	if not names_its_class and not task.is_of_vector():
		return
	WorkshopChameleon.wrong_method = task.method
	WorkshopChameleon.wrong_way = null
	await _goes_red(testing)
	for way in task.ways:
		if way.is_in_tests:
			WorkshopChameleon.wrong_way = way
			var told := "%s: %s" % [task.method, way.sentence]
			if await _goes_red(testing):
				verdict.found.append(told)
			else:
				verdict.missed.append(told)
	WorkshopChameleon.wrong_method = ""


# Whether a test that is green on the right classes goes red now.
func _goes_red(files: PackedStringArray) -> bool:
	var is_found := false
	for file in files:
		if not file in _file_of_test.values() or not _put(file):
			continue
		var run := await _run()
		for test_name in run.failures:
			if run.failures[test_name] and _file_of_test.has(test_name):
				_was_red[test_name] = true
				is_found = true
	return is_found


func _put(file: String) -> bool:
	_allow()
	# GUT loads it from its place, where it stays as long as somebody holds it.
	_put_there = _compiler.compile_test(file, _chameleons)
	_watchdog.rest()
	return _put_there != null


func _run() -> WorkshopTestRun:
	var run := WorkshopTestRun.new()
	var begun := Time.get_ticks_msec()
	_allow()
	await run.run(_tree, _PLACE)
	_watchdog.rest()
	_spent += (Time.get_ticks_msec() - begun) / 1000.0
	return run


func _allow() -> void:
	_watchdog.allow(clampf(LONGEST_OF_ALL - _spent, 0.0, LONGEST))


# Only a file that names the method can tell how it answers.
static func _names(code: WorkshopCode, word: String) -> bool:
	return RegEx.create_from_string("\\b%s\\b" % word).search(code.text) != null


# The methods of the exercises that a test calls.
static func _methods_in(code: WorkshopCode, test_name: String) -> PackedStringArray:
	var methods: PackedStringArray = []
	for called in code.calls_in(test_name):
		if WorkshopIndex.task(called) and not called in methods:
			methods.append(called)
	return methods
