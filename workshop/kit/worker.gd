extends SceneTree
## The child process in which a student's code runs, and the only one. It judges what is in a
## folder, tells it line by line, and answers then what the lab asks. It ends when the lab does.
## Usage: godot --headless --path . -s workshop/kit/worker.gd -- judge|tests FOLDER KEY LANGUAGE
## SKIPPED STOPPED

var _key := ""
var _folder := ""
var _errors := WorkshopHeardErrors.new()
var _watchdog := WorkshopWatchdog.new()
var _judge: WorkshopJudge
var _tests: WorkshopTestsJudge
var _listener := Thread.new()
var _requests: PackedStringArray = []
var _request_came := Semaphore.new()
var _asked := ""


func _initialize() -> void:
	var arguments := OS.get_cmdline_user_args()
	Engine.print_to_stdout = false
	_folder = arguments[1]
	_key = arguments[2]
	TranslationServer.set_locale(arguments[3])
	OS.add_logger(_errors)
	var problem := _listener.start(_listen)
	assert(problem == OK, "the listening thread has started")
	_watchdog.last_words = _say_last_words
	_watchdog.start()
	if arguments[0] == "tests":
		_judge_tests.call_deferred()
	else:
		_judge_all(arguments[4], arguments[5].split(",", false))


func _judge_all(skipped: String, stopped: PackedStringArray) -> void:
	_judge = WorkshopJudge.new(_errors, _watchdog, stopped)
	var numbers: PackedInt32Array = []
	for number in skipped.split(",", false):
		numbers.append(number.to_int())
	_judge.judge(_files(WorkshopFiles.of_student(_folder), false), numbers)
	var shape := WorkshopShape.new(_judge.compiler.codes)
	_say({"report": _judge.report.to_dictionary(), "tokens": shape.tokens, "shape": shape.sum})
	while true:
		_request_came.wait()
		_answer(WorkshopAny.dictionary(JSON.parse_string(_next_request())))


func _judge_tests() -> void:
	await process_frame
	_tests = WorkshopTestsJudge.new(self, _errors, _watchdog)
	await _tests.judge(_files(WorkshopFiles.tests(_folder), true))
	_say({"tests": _tests.verdict.to_dictionary()})
	OS.kill(OS.get_process_id())


func _files(names: PackedStringArray, are_tests: bool) -> Dictionary[String, PackedByteArray]:
	var files: Dictionary[String, PackedByteArray] = {}
	for file in names:
		if are_tests or WorkshopFiles.CLASSES.has(file):
			files[file] = FileAccess.get_file_as_bytes(_folder.path_join(file))
	return files


# Answers one question of the lab: what the student's method gives for other numbers.
func _answer(request: Dictionary) -> void:
	_asked = request["ask"]
	var method: String = request["method"]
	var bits: String = request["numbers"]
	var answer := _judge.answer(method, WorkshopVerdict.numbers_of(bits))
	_say({"answer": _asked, "numbers": WorkshopVerdict.bits_of(answer), "sentence": ""})


# In the watchdog's thread, while the student's code hangs in the other one.
func _say_last_words(kind: WorkshopVerdict.Kind) -> void:
	if _tests:
		var sentence := LabText.translate("Your tests do not come to an end.")
		_tests.verdict.unreadable.insert(0, sentence)
		_say({"tests": _tests.verdict.to_dictionary()})
	elif _judge.report.is_complete:
		_say({"answer": _asked, "numbers": "", "sentence": ""})
	else:
		var verdict := _judge.verdict_at_the_end(kind)
		_judge.report.verdicts[verdict.exercise] = verdict
		_say({"report": _judge.report.to_dictionary()})


func _say(message: Dictionary) -> void:
	Engine.print_to_stdout = true
	printraw("%s %s\n" % [_key, JSON.stringify(message)])
	Engine.print_to_stdout = false


# What the engine reads has lost its line break, and may hold several requests or a part of one. An
# empty text says that the lab is gone.
func _listen() -> void:
	var unread := ""
	while true:
		var part := OS.read_string_from_stdin(65536)
		if not part:
			OS.kill(OS.get_process_id())
		var lines := (unread + part).split("\n")
		unread = ""
		for line in lines:
			if JSON.new().parse(line) == OK:
				_requests.append(line)
				_request_came.post()
			else:
				unread = line


func _next_request() -> String:
	var request := _requests[0]
	_requests.remove_at(0)
	return request
