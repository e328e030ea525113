class_name WorkshopJudge
extends RefCounted
## Judges all exercises of a student, one after the other. The student's code runs here: so only a
## child process may use it, unless the code is guarded.

## Filled exercise by exercise.
var report := WorkshopReport.new()
## The compiled classes, once they are.
var compiler: WorkshopCompiler
## The exercise that is judged just now.
var exercise_now := 0

var _errors: WorkshopHeardErrors
var _watchdog: WorkshopWatchdog
var _task_judge: WorkshopTaskJudge
var _verdict_of_task: Dictionary[String, WorkshopVerdict] = {}
var _stopped: PackedStringArray = []
# Whether the files are compiled: even that may take too long.
var _is_read := false


## Prepares; [param errors] hears the engine already, and [param watchdog] watches. What calls one
## of the methods in [param stopped] is not run: they have ended a child before. A watchdog that was
## not started watches nothing: then the code must be guarded.
func _init(
	errors: WorkshopHeardErrors,
	watchdog: WorkshopWatchdog,
	stopped: PackedStringArray,
	with_guards: bool = false
) -> void:
	_stopped = stopped
	_errors = errors
	_watchdog = watchdog
	compiler = WorkshopCompiler.new(errors, with_guards)


## Judges what is in these files, by their names, but for the exercises in [param skipped], which
## have their verdicts already.
func judge(files: Dictionary[String, PackedByteArray], skipped: PackedInt32Array) -> void:
	exercise_now = _first_but(skipped)
	_watchdog.allow(WorkshopWatchdog.LONGEST)
	compiler.compile(files)
	_is_read = true
	for exercise in WorkshopIndex.exercises():
		exercise_now = exercise.number
		if exercise.tasks and not exercise.number in skipped:
			_watchdog.allow(WorkshopWatchdog.LONGEST)
			report.verdicts[exercise.number] = _verdict_on(exercise)
			if compiler.is_guarded and WorkshopGuard.over:
				_go_on_without(report.verdicts[exercise.number])
			if report.is_complete:
				break
	_watchdog.rest()
	report.is_complete = true


## What the student's [param method] gives for other numbers than those of a probe, in the order of
## [member WorkshopTask.takes]; nothing where it cannot be called, or is stopped.
func answer(method: String, numbers: PackedFloat64Array) -> PackedFloat64Array:
	var task := WorkshopIndex.task(method)
	var vector: GDScript = compiler.classes.get("MyVec2")
	var home: GDScript = compiler.classes.get(task.home)
	if not vector or not home or not _has_method(task):
		return []
	_errors.begin()
	_watchdog.allow(WorkshopWatchdog.LONGEST)
	if compiler.is_guarded:
		WorkshopGuard.begin(_errors)
	var given := WorkshopCall.new(task, vector, home, method).run(numbers)
	_watchdog.rest()
	var is_stopped := compiler.is_guarded and WorkshopGuard.over
	if _errors.heard or _errors.has_overflowed or is_stopped:
		return []
	return given.numbers


## The verdict on the exercise that runs just now, which has to be ended.
func verdict_at_the_end(kind: WorkshopVerdict.Kind) -> WorkshopVerdict:
	var verdict := WorkshopVerdict.new()
	verdict.exercise = exercise_now
	verdict.kind = kind
	var exercise := WorkshopIndex.exercise(exercise_now)
	verdict.method = exercise.tasks[0].method
	verdict.file = WorkshopFiles.file_of(exercise.home())
	if _task_judge:
		verdict.method = _task_judge.method()
		if _task_judge.probe_now:
			verdict.probe = _task_judge.probe_now.title
			verdict.asked = _task_judge.probe_now.numbers
	if not _is_read:
		verdict.sentence = LabText.translate("Your files cannot be read in time.")
		return verdict
	if compiler.codes.has(verdict.file):
		verdict.line = compiler.codes[verdict.file].line_of(verdict.method)
	verdict.sentence = WorkshopVerdict.sentence_of_end(kind, verdict.method, verdict.probe)
	return verdict


# A guard has stopped a method, as otherwise the watchdog would have: what calls it is not run.
func _go_on_without(verdict: WorkshopVerdict) -> void:
	WorkshopGuard.begin(_errors)
	if verdict.method and not _errors.has_overflowed:
		_stopped.append(verdict.method)
		report.go_on_after_end(-1)


func _has_method(task: WorkshopTask) -> bool:
	var code := compiler.codes[WorkshopFiles.file_of(task.home)]
	return task.method in code.functions()


func _verdict_on(exercise: WorkshopExercise) -> WorkshopVerdict:
	var file := WorkshopFiles.file_of(exercise.home())
	var verdict: WorkshopVerdict
	if not compiler.codes.has(file):
		verdict = WorkshopVerdict.new()
		verdict.kind = WorkshopVerdict.Kind.MISSING
		verdict.file = file
		verdict.sentence = LabText.translate("The file %s is not there.") % file
	elif compiler.problems.has(file):
		verdict = WorkshopVerdict.from_dictionary(_read_back(compiler.problems[file]))
	else:
		verdict = _verdict_on_methods(exercise, compiler.codes[file])
	verdict.exercise = exercise.number
	return verdict


# As it would come through a pipe: a copy, in which whole numbers are floats.
static func _read_back(verdict: WorkshopVerdict) -> Dictionary:
	return JSON.parse_string(JSON.stringify(verdict.to_dictionary()))


# The first method that is not right speaks for the exercise.
func _verdict_on_methods(exercise: WorkshopExercise, code: WorkshopCode) -> WorkshopVerdict:
	var last: WorkshopVerdict
	var costs: PackedFloat64Array = [0.0, 0.0, 0.0, 0.0]
	for task in exercise.tasks:
		for used in code.calls_in(task.method):
			if used in _stopped:
				return _verdict_on_waiting(task, used, code)
		_task_judge = WorkshopTaskJudge.new(task, compiler, _errors)
		last = _task_judge.judge(compiler.classes)
		_verdict_of_task[task.method] = last
		if not last.is_right():
			_blame_what_it_uses(last, task, code)
			return last
		# Guards take most of the time.
		if not compiler.is_guarded:
			_add_costs(costs, task)
			last.costs = costs
	return last


# The dearest method of an exercise counts.
func _add_costs(costs: PackedFloat64Array, task: WorkshopTask) -> void:
	var timed := WorkshopCall.new(
		task, compiler.classes["MyVec2"], compiler.classes[task.home], task.method
	)
	var time := WorkshopRunTime.new(task, timed)
	costs[3] = maxf(costs[3], _task_judge.error())
	if time.ratio > costs[2]:
		costs[0] = time.nanoseconds
		costs[1] = time.reference_nanoseconds
		costs[2] = time.ratio


# What goes wrong inside a method that it calls is to be mended there first.
func _blame_what_it_uses(verdict: WorkshopVerdict, task: WorkshopTask, code: WorkshopCode) -> void:
	if verdict.kind in [WorkshopVerdict.Kind.OPEN, WorkshopVerdict.Kind.RIGHT]:
		return
	for used in code.calls_in(task.method):
		var other: WorkshopVerdict = _verdict_of_task.get(used)
		if other and used != task.method and not other.is_right():
			_let_wait(verdict, task, used)
			return


# What uses a method that ended a child would only end this one, too.
func _verdict_on_waiting(task: WorkshopTask, used: String, code: WorkshopCode) -> WorkshopVerdict:
	var verdict := WorkshopVerdict.new()
	verdict.method = task.method
	verdict.file = WorkshopFiles.file_of(task.home)
	verdict.line = code.line_of(task.method)
	_let_wait(verdict, task, used)
	_stopped.append(task.method)
	return verdict


static func _let_wait(verdict: WorkshopVerdict, task: WorkshopTask, used: String) -> void:
	verdict.kind = WorkshopVerdict.Kind.WAITING
	verdict.mistake = 0
	verdict.sentence = LabText.translate("%s uses %s, which is not right yet: mend that first.")
	verdict.sentence = verdict.sentence % [task.method, used]


static func _first_but(skipped: PackedInt32Array) -> int:
	for exercise in WorkshopIndex.exercises():
		if exercise.tasks and not exercise.number in skipped:
			return exercise.number
	return 0
