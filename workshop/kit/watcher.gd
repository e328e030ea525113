class_name WorkshopWatcher
extends Node
## Watches the student's files, has them judged whenever he saves one, and tells what came of it. It
## never waits: his code runs in a child process.
##
## Add it to the scene tree; it begins by itself and ends its children when it leaves.

## The judge has said something new: [param report] is complete, or holds what is known already.
signal judged(report: WorkshopReport)
## A saved file has been seen, and is judged from now on.
signal began
## The answer to the question with this number, see [method ask]; empty where the method gives none.
signal answered(question: int, numbers: PackedFloat64Array)

## Seconds from one look at the files to the next.
const LOOK_EVERY := 0.1
## A child that says nothing for so many seconds is ended.
const PATIENCE := 20.0
## The same for one that runs his tests once for every wrong way.
const PATIENCE_WITH_TESTS := 60.0

## The folder with the student's files.
var folder := WorkshopFiles.FOLDER
## What is known about the files as they are now; null before the first time.
var report: WorkshopReport = null

var _fingerprint := ""
var _tests_fingerprint := ""
var _next_look := 0.0
var _worker: WorkshopChild = null
var _worker_since := 0.0
# How many exercises were judged when the latest child began.
var _verdicts_before := -1
var _tester: WorkshopChild = null
var _tester_since := 0.0
var _questions := 0
var _pending: Dictionary = {}


func _ready() -> void:
	if WorkshopChild.can_run():
		WorkshopFiles.put_starters(folder)
	else:
		set_process(false)


func _exit_tree() -> void:
	_stop(_worker)
	_stop(_tester)


func _process(seconds: float) -> void:
	_next_look -= seconds
	if _next_look <= 0.0:
		_next_look = LOOK_EVERY
		_look()
	_hear_worker()
	_hear_tester()


## Judges the files now, whether they have changed or not.
func check_now() -> void:
	_fingerprint = ""
	_tests_fingerprint = ""
	_next_look = 0.0


## Whether something is judged just now.
func is_judging() -> bool:
	return _tester != null or (report != null and not report.is_complete)


## The process that judges his classes and answers; -1 where there is none.
func child_id() -> int:
	return _worker.id() if _worker else -1


## Asks for what the student's [param method] gives for other numbers, in the order of
## [member WorkshopTask.takes]. The answer comes with [signal answered] and the number that this
## returns; where a newer question of the same method was asked meanwhile, only that one is
## answered.
func ask(method: String, numbers: PackedFloat64Array) -> int:
	_questions += 1
	var bits := WorkshopVerdict.bits_of(numbers)
	_pending[method] = {"ask": str(_questions), "method": method, "numbers": bits}
	_send_pending()
	return _questions


# In another language all is said anew.
func _look() -> void:
	var language := TranslationServer.get_locale()
	var classes := PackedStringArray(WorkshopFiles.CLASSES.keys())
	var fingerprint := language + WorkshopFiles.fingerprint(folder, classes)
	if fingerprint != _fingerprint:
		_fingerprint = fingerprint
		_begin_judging()
	var tests := WorkshopFiles.tests(folder)
	var tests_fingerprint := language + WorkshopFiles.fingerprint(folder, tests)
	if tests_fingerprint != _tests_fingerprint:
		_tests_fingerprint = tests_fingerprint
		_stop(_tester)
		_tester = null
		if not WorkshopFiles.are_starters(folder, tests):
			_tester = WorkshopChild.new("tests", folder)
			_tester_since = _now()


func _begin_judging() -> void:
	var tests := report.tests if report else null
	report = WorkshopReport.new()
	report.tests = tests
	_verdicts_before = -1
	if WorkshopFiles.are_starters(folder, PackedStringArray(WorkshopFiles.CLASSES.keys())):
		_stop(_worker)
		_worker = null
		report.leave_open()
		judged.emit(report)
		return
	_start_worker()
	began.emit()


func _start_worker() -> void:
	_stop(_worker)
	_worker = WorkshopChild.new("judge", folder, report)
	_worker_since = _now()


func _hear_worker() -> void:
	if not _worker:
		return
	var was_running := _worker.is_running()
	for message in _worker.said():
		if message.has("report"):
			report.take(WorkshopAny.dictionary(message["report"]))
			judged.emit(report)
			_send_pending()
		elif message.has("answer"):
			_take_answer(message)
	if report.is_complete:
		# One that a question has ended is started again by the next question.
		_worker = _worker if was_running else null
	elif not was_running or _now() - _worker_since > PATIENCE:
		_go_on_without_it()


# The child has ended before it was through: the rest is judged by another one.
func _go_on_without_it() -> void:
	report.go_on_after_end(_verdicts_before)
	_verdicts_before = report.verdicts.size()
	judged.emit(report)
	if not report.is_complete:
		_start_worker()


func _hear_tester() -> void:
	if not _tester:
		return
	var was_running := _tester.is_running()
	for message in _tester.said():
		if message.has("tests"):
			var told := WorkshopAny.dictionary(message["tests"])
			report.tests = WorkshopTestsVerdict.from_dictionary(told)
			judged.emit(report)
	if not was_running or _now() - _tester_since > PATIENCE_WITH_TESTS:
		_stop(_tester)
		_tester = null


func _send_pending() -> void:
	if not report or not report.is_complete or _pending.is_empty():
		return
	if not _worker:
		_start_worker()
		return
	for request: Dictionary in _pending.values():
		_worker.tell(request)
	_pending.clear()


func _take_answer(message: Dictionary) -> void:
	var question: String = message["answer"]
	var bits: String = message["numbers"]
	answered.emit(question.to_int(), WorkshopVerdict.numbers_of(bits))


static func _stop(child: WorkshopChild) -> void:
	if child:
		child.stop()


static func _now() -> float:
	return Time.get_ticks_msec() / 1000.0
