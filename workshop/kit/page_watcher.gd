class_name WorkshopPageWatcher
extends WorkshopWatcher
## The watcher where no child can be started, as in a browser: the student writes in the lab itself,
## and what he has written is judged in the lab's own process, with guards in it. It judges when it
## is asked to, and has said what it has to say when [method check_now] comes back.

var _errors := WorkshopHeardErrors.new()
# Null while nothing is written.
var _judge: WorkshopJudge
# The language in which the report is.
var _language := ""


func _ready() -> void:
	set_process(false)
	check_now()


## Judges the texts as they are now.
func check_now() -> void:
	began.emit()
	_hear(true)
	WorkshopGuard.forget_prints()
	_language = TranslationServer.get_locale()
	_judge_all()
	_hear(false)
	judged.emit(report)


## Judges anew where another language is spoken now: the sentences are in the report.
func say_again() -> void:
	if _language != TranslationServer.get_locale():
		check_now()


## Never: it waits for nothing.
func is_judging() -> bool:
	return false


## There is none.
func child_id() -> int:
	return -1


## See [method WorkshopWatcher.ask]; the answer comes in the same frame.
func ask(method: String, numbers: PackedFloat64Array) -> int:
	_questions += 1
	_answer.call_deferred(_questions, method, numbers)
	return _questions


func _answer(question: int, method: String, numbers: PackedFloat64Array) -> void:
	_hear(true)
	var answer := _judge.answer(method, numbers) if _judge else PackedFloat64Array()
	_hear(false)
	answered.emit(question, answer)


# What the engine says of the student's code is not said of the lab.
func _hear(is_listening: bool) -> void:
	WebPage.tell({"isJudging": is_listening})
	if is_listening:
		OS.add_logger(_errors)
	else:
		OS.remove_logger(_errors)


func _judge_all() -> void:
	if not WorkshopKeptCode.exercises().any(WorkshopKeptCode.is_written):
		_judge = null
		report = WorkshopReport.new()
		report.leave_open()
		return
	var problems := _problems()
	var written := WorkshopWrittenFiles.new(PackedInt32Array(problems.keys()))
	_judge = WorkshopJudge.new(_errors, WorkshopWatchdog.new(), [], true)
	_judge.judge(written.files, [])
	report = _judge.report
	for number in report.verdicts:
		var verdict := report.verdicts[number]
		verdict.line = written.line_in_text(number, verdict.file, verdict.line)
	report.verdicts.merge(problems, true)


# What is said of each text that cannot be compiled. Without it the others are judged.
func _problems() -> Dictionary[int, WorkshopVerdict]:
	var found: Dictionary[int, WorkshopVerdict] = {}
	var open: Array[WorkshopExercise] = []
	for exercise in WorkshopKeptCode.exercises():
		if WorkshopKeptCode.is_written(exercise) and not _is_closed(exercise):
			open.append(exercise)
	for exercise in open:
		_find_problem_alone(exercise, found)
	while _find_problem(found):
		pass
	return found


# A bracket or a string that is not closed is told by the engine in another text.
static func _is_closed(exercise: WorkshopExercise) -> bool:
	var layout := WorkshopCodeLayout.new(WorkshopKeptCode.text_of(exercise))
	for index in layout.tokens.size():
		var is_bracket := layout.text_at(index) in ["(", "[", "{", ")", "]", "}"]
		if layout.text_at(index) in ['"', "'"] or (is_bracket and layout.partners[index] < 0):
			return false
	return true


func _find_problem_alone(
	exercise: WorkshopExercise, found: Dictionary[int, WorkshopVerdict]
) -> void:
	var others: PackedInt32Array = []
	for other in WorkshopKeptCode.exercises():
		if other != exercise:
			others.append(other.number)
	var file := WorkshopFiles.file_of(exercise.home())
	var written := WorkshopWrittenFiles.new(others)
	var problem: WorkshopVerdict = _compiled(written).problems.get(file)
	if problem:
		var line := written.line_in_text(exercise.number, file, problem.line)
		_add(found, exercise.number, problem, line)


# Whether there is one more.
func _find_problem(found: Dictionary[int, WorkshopVerdict]) -> bool:
	var written := WorkshopWrittenFiles.new(PackedInt32Array(found.keys()))
	var problems := _compiled(written).problems
	for file in problems:
		var problem := problems[file]
		var number := written.exercise_at(file, problem.line)
		if number < 0 and problem.kind != WorkshopVerdict.Kind.WAITING:
			number = written.last_exercise_in(file)
		if number >= 0:
			var line := written.line_in_text(number, file, problem.line)
			_add(found, number, problem, line)
			return true
	return false


func _compiled(written: WorkshopWrittenFiles) -> WorkshopCompiler:
	var compiler := WorkshopCompiler.new(_errors, true)
	compiler.compile(written.files)
	return compiler


static func _add(
	found: Dictionary[int, WorkshopVerdict], number: int, problem: WorkshopVerdict, line: int
) -> void:
	problem.exercise = number
	problem.line = line
	found[number] = problem
