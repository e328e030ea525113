extends RefCounted
## The files in one folder, judged from beginning to end in children, one after the other. Nothing
## here waits, but for [method judge].

const _WAIT := 2

## What the judge says.
var report := WorkshopReport.new()
## What tells a copy, see [WorkshopShape].
var shape := ""
## How much code that stands for.
var tokens := 0

var _folder := ""
var _home := ""
var _child: WorkshopChild
var _is_testing := false
var _known := -1
var _since := 0


## The files in [param folder]. The children write what they have to write into [param home]; ""
## for that of the user.
func _init(folder: String, home: String = "") -> void:
	_folder = folder
	_home = home


## Judges the classes, then the tests; waits for both.
func judge() -> void:
	begin()
	while not look():
		OS.delay_msec(_WAIT)


## Starts the first child, if one is needed.
func begin() -> void:
	if WorkshopFiles.are_starters(_folder, PackedStringArray(WorkshopFiles.CLASSES.keys())):
		report.leave_open()
	else:
		_start("judge")


## Hears the child, and starts the next one when it is through. Whether all is judged.
func look() -> bool:
	if _child and not _is_through():
		return false
	if not _is_testing and not report.is_complete:
		report.go_on_after_end(_known)
		_known = report.verdicts.size()
		if not report.is_complete:
			_start("judge")
			return false
	var tests := WorkshopFiles.tests(_folder)
	if not _is_testing and not WorkshopFiles.are_starters(_folder, tests):
		_is_testing = true
		_start("tests")
		return false
	if _is_testing and not report.tests:
		report.tests = WorkshopTestsVerdict.of_crash()
	return true


func _start(task: String) -> void:
	if _home:
		OS.set_environment("HOME", _home)
	_child = WorkshopChild.new(task, _folder, report)
	_since = Time.get_ticks_msec()


# Whether the child has said all that it will say. It is ended then.
func _is_through() -> bool:
	var was_running := _child.is_running()
	var messages := _child.said()
	while messages:
		for message in messages:
			_take(message)
		messages = _child.said()
	var is_told := report.tests != null if _is_testing else report.is_complete
	var longest := WorkshopWatcher.PATIENCE
	if _is_testing:
		longest = WorkshopWatcher.PATIENCE_WITH_TESTS
	var is_late := Time.get_ticks_msec() - _since > longest * 1000.0
	if was_running and not is_told and not is_late:
		return false
	_child.stop()
	_child = null
	return true


func _take(message: Dictionary) -> void:
	if message.has("report"):
		report.take(WorkshopAny.dictionary(message["report"]))
		shape = message.get("shape", "")
		tokens = int(WorkshopAny.number(message.get("tokens", 0)))
	elif message.has("tests"):
		report.tests = WorkshopTestsVerdict.from_dictionary(
			WorkshopAny.dictionary(message["tests"])
		)
