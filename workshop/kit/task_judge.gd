class_name WorkshopTaskJudge
extends RefCounted
## Tries one method of a student on all its probes, and says what became of it.

## The call that runs just now, for the watchdog.
var probe_now: WorkshopProbe

var _task: WorkshopTask
var _code: WorkshopCode
var _errors: WorkshopHeardErrors
var _verdict: WorkshopVerdict
var _answers: Array[PackedFloat64Array] = []
var _rights: Array[PackedFloat64Array] = []
# The line in his file that was heard of.
var _line_of: Callable
var _is_guarded := false
var _has_given_copy := false
var _spoiled: WorkshopProbe = null


## Prepares for the method [param task] in the file that [param compiler] has compiled.
func _init(task: WorkshopTask, compiler: WorkshopCompiler, errors: WorkshopHeardErrors) -> void:
	var file := WorkshopFiles.file_of(task.home)
	_line_of = compiler.line_in.bind(file)
	_is_guarded = compiler.is_guarded
	_task = task
	_code = compiler.codes[file]
	_errors = errors
	_verdict = WorkshopVerdict.new()
	_verdict.method = task.method
	_verdict.file = file


## The name of the method.
func method() -> String:
	return _task.method


## The verdict on the method, without the number of its exercise.
func judge(classes: Dictionary[String, GDScript]) -> WorkshopVerdict:
	var home := classes[_task.home]
	_verdict.line = _code.line_of(_task.method)
	if not _is_there(home) or not _is_begun():
		return _verdict
	if not _makes_vectors(classes["MyVec2"]) or not _makes_balls(home):
		return _verdict
	var trying := WorkshopCall.new(_task, classes["MyVec2"], home, _task.method)
	for probe in _task.probes:
		if not _try(trying, probe):
			return _verdict
	_name_what_it_is()
	return _verdict


func _is_there(home: GDScript) -> bool:
	var names: PackedStringArray = []
	for known: Dictionary in home.get_script_method_list():
		var known_name: String = known["name"]
		names.append(known_name)
		if known_name == _task.method:
			return _takes_enough(known)
	var sentence := LabText.translate("The method %s is not there.") % _task.method
	var nearest := WorkshopSentences.nearest_to(_task.method, names)
	if nearest and not WorkshopIndex.task(nearest):
		sentence = LabText.translate("The lab looks for %s: do you mean that by %s?")
		sentence = sentence % [_task.method, nearest]
		_verdict.line = _code.line_of(nearest)
	return _stop(WorkshopVerdict.Kind.MISSING, sentence)


func _takes_enough(known: Dictionary) -> bool:
	var arguments: Array = known["args"]
	var defaults: Array = known["default_args"]
	var wanted := _task.parameters().length()
	if arguments.size() >= wanted and arguments.size() - defaults.size() <= wanted:
		return true
	var sentence := LabText.translate("%s takes %d parameters, but %d are handed over.")
	return _stop(WorkshopVerdict.Kind.MISSING, sentence % [_task.method, arguments.size(), wanted])


# An unchanged starter is no mistake.
func _is_begun() -> bool:
	var starter := WorkshopCode.new(
		WorkshopFiles.starter(WorkshopFiles.file_of(_task.home)).to_utf8_buffer()
	)
	if _code.shape_of(_task.method) != starter.shape_of(_task.method):
		return true
	return _stop(
		WorkshopVerdict.Kind.OPEN, WorkshopVerdict.sentence_of_open(_task.method, _verdict.file)
	)


func _makes_vectors(vector: GDScript) -> bool:
	_begin(1)
	var made: Variant = vector.callv(&"new", [3.0, 4.0])
	if made is Object:
		var three_four := WorkshopAny.object(made)
		if is_same(three_four.get("x"), 3.0) and is_same(three_four.get("y"), 4.0):
			return true
	var sentence := LabText.translate("MyVec2.new(3.0, 4.0) must give x = 3.0 and y = 4.0.")
	return _stop(WorkshopVerdict.Kind.MISSING, sentence)


func _makes_balls(home: GDScript) -> bool:
	if not _task.takes.contains("B"):
		return true
	var constants := home.get_script_constant_map()
	if constants.get("MyBall") is GDScript and constants.get("MySegment") is GDScript:
		return true
	var sentence := LabText.translate("The classes MyBall and MySegment must stay in the file.")
	return _stop(WorkshopVerdict.Kind.MISSING, sentence)


func _try(trying: WorkshopCall, probe: WorkshopProbe) -> bool:
	probe_now = probe
	_begin(probe.repeats)
	var answer := trying.run_probe(probe)
	var right := WorkshopCall.right_answer(_task, probe)
	_note(probe, answer.numbers, right)
	if _errors.has_overflowed:
		var endless := LabText.translate("%s calls itself without end.") % _task.method
		return _stop(WorkshopVerdict.Kind.ENDLESS, endless)
	if _is_guarded and WorkshopGuard.over:
		return _stop_at_guard(probe)
	if _errors.heard:
		_verdict.line = _line_of.call(_errors.heard[0])
		# A guard does not end the method: what came back is not what it would be.
		if not _errors.heard[0].file:
			_verdict.got.clear()
		var message := _errors.heard[0].message
		var sentence := WorkshopSentences.of_stop(message, _code.functions())
		return _stop(WorkshopVerdict.Kind.BROKEN, sentence)
	match answer.kind:
		WorkshopAnswer.Kind.NOTHING:
			var nothing := LabText.translate("%s gives nothing back: it needs a return.")
			return _stop(WorkshopVerdict.Kind.MISSING, nothing % _task.method)
		WorkshopAnswer.Kind.WRONG_KIND:
			return _stop(WorkshopVerdict.Kind.MISSING, _wrong_kind(answer.came_back))
		WorkshopAnswer.Kind.COPY:
			_has_given_copy = true
	if answer.spoiled and not _spoiled:
		_spoiled = probe
	_answers.append(answer.numbers)
	_rights.append(right)
	return true


func _begin(repeats: int) -> void:
	_errors.begin()
	if _is_guarded:
		WorkshopGuard.begin(_errors, repeats)


func _stop_at_guard(probe: WorkshopProbe) -> bool:
	var kind := WorkshopGuard.kind
	_verdict.line = WorkshopGuard.line
	_verdict.got.clear()
	_verdict.wanted.clear()
	return _stop(kind, WorkshopVerdict.sentence_of_end(kind, _task.method, probe.title))


func _wrong_kind(came_back: String) -> String:
	var wanted: String = {"v": "MyVec2", "f": "float", "b": "bool"}[_task.gives]
	return (
		LabText.translate("%s must give a %s back, not a %s.") % [_task.method, wanted, came_back]
	)


func _name_what_it_is() -> void:
	if _has_given_copy:
		var sentence := LabText.translate(
			"%s must change the vector itself: yours gives back a new one."
		)
		_verdict.mistake = 0
		_stop(WorkshopVerdict.Kind.MISTAKE, sentence % _task.method)
		return
	if _spoiled:
		_verdict.mistake = _task.spoiling_number
		_verdict.probe = _spoiled.title
		_stop(WorkshopVerdict.Kind.MISTAKE, _task.spoiling_sentence)
		return
	var wrong := _first_wrong()
	if wrong < 0:
		_verdict.probe = ""
		_verdict.is_excellent = _is_right_on_extra()
		_stop(WorkshopVerdict.Kind.RIGHT, _sentence_of_right())
		return
	_note(_task.probes[wrong], _answers[wrong], _rights[wrong])
	var way := _way_taken()
	if way:
		_verdict.mistake = way.number
		_stop(WorkshopVerdict.Kind.MISTAKE, way.sentence)
	else:
		_stop(WorkshopVerdict.Kind.UNKNOWN, _sentence_of_unknown())


# The way with which the student agrees on all probes that it is about.
func _way_taken() -> WorkshopWay:
	for way in _task.ways:
		if not way.is_extra and not way.spoils_inputs and _agrees_with(way):
			return way
	return null


func _agrees_with(way: WorkshopWay) -> bool:
	for index in _task.probes.size():
		var probe := _task.probes[index]
		if is_compared(way, probe):
			var told: PackedFloat64Array = answer_of(way, probe)
			if not probe.agrees(_answers[index], told):
				return false
	return true


## Whether a way says something about a probe.
static func is_compared(way: WorkshopWay, probe: WorkshopProbe) -> bool:
	if probe.is_extra or probe.repeats > 1:
		return false
	return way.is_about_special or not probe.is_special


## What a wrong way answers to a probe.
static func answer_of(way: WorkshopWay, probe: WorkshopProbe) -> PackedFloat64Array:
	return way.answer.call(probe.numbers)


func _first_wrong() -> int:
	for index in _task.probes.size():
		var probe := _task.probes[index]
		if not probe.is_extra and not probe.agrees(_answers[index], _rights[index]):
			return index
	return -1


# Right is also to refuse what cannot be answered: the vector stays as it was then.
func _is_right_on_extra() -> bool:
	for index in _task.probes.size():
		var probe := _task.probes[index]
		if probe.is_extra and not probe.agrees(_answers[index], _rights[index]):
			if not probe.agrees(_answers[index], probe.numbers.slice(0, _answers[index].size())):
				return false
	return true


func _sentence_of_right() -> String:
	if not _verdict.is_excellent:
		for way in _task.ways:
			if way.is_extra:
				return LabText.translate("%s is right. %s") % [_task.method, way.sentence]
	return LabText.translate("%s is right.") % _task.method


func _sentence_of_unknown() -> String:
	var got := WorkshopVerdict.text_of(_verdict.got)
	var wanted := WorkshopVerdict.text_of(_verdict.wanted)
	var sentence := LabText.translate("%s for %s: got %s, wanted %s.")
	return sentence % [_task.method, _verdict.probe, got, wanted]


func _note(probe: WorkshopProbe, got: PackedFloat64Array, wanted: PackedFloat64Array) -> void:
	_verdict.probe = probe.title
	_verdict.asked = probe.numbers
	_verdict.got = got
	_verdict.wanted = wanted


func _stop(kind: WorkshopVerdict.Kind, sentence: String) -> bool:
	_verdict.kind = kind
	_verdict.sentence = sentence
	return false


## The largest difference from the right answers, after [method judge].
func error() -> float:
	var largest := 0.0
	for index in _answers.size():
		if _task.probes[index].repeats == 1 and not _task.probes[index].is_extra:
			for place in _rights[index].size():
				var difference := absf(_answers[index][place] - _rights[index][place])
				largest = maxf(largest, difference if is_finite(difference) else 0.0)
	return largest
