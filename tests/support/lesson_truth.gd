class_name LessonTruth
extends RefCounted
## Shows a lesson in many states, at each of its steps, and collects what it says that is false.

## All states have been looked at in [param step], counted from 1.
signal step_seen(step: int)


## A false line, or what a judge has found.
class Finding:
	extends RefCounted
	## The step, counted from 1.
	var step: int
	## What is false, with the line.
	var sentence: String
	## The text behind `#` that opens this state.
	var link: String
	## How many states have a line of this kind that is false.
	var count := 1

	## As a report writes it.
	func text() -> String:
		return "step %d, %d times: %s  #%s" % [step, count, sentence, link]


# Numbers are left out where two lines are compared.
const _NUMBER := "[-−]?(?:\\d+(?:\\.\\d+)?(?:e[-−+]?\\d+)?|∞|NaN)"
const _REMARK := " \\(rounding: [^)]*\\)"
# Parts of a formula that were replaced are freed at the end of a frame.
const _STATES_IN_A_FRAME := 20

## What was found, the first one of each kind.
var findings: Array[Finding] = []
## How many formulas were read.
var read_count := 0

var _frame: LessonFrame
var _judge: LessonJudge
# Has problems(lines).
var _reader: RefCounted
var _known: Dictionary[String, Finding] = {}
var _remark_finder := RegEx.create_from_string(_REMARK)
var _number_finder := RegEx.create_from_string("%s\\.\\.%s|\\(%s\\)|%s".replace("%s", _NUMBER))


## Of the lesson that [param frame] has opened.
func _init(frame: LessonFrame) -> void:
	_frame = frame
	var words := LessonWords.of(frame.lesson_info.id)
	if words.is_code:
		_reader = CodeReader.new()
	else:
		_reader = FormulaReader.new(words)
	_judge = LessonJudge.of(frame.lesson_info.id)


## Looks at so many states with this seed, each at every step.
func look_at(state_count: int, seed_number: int) -> void:
	CallTimer.is_measuring = false
	await _look_at(state_count, seed_number)
	CallTimer.is_measuring = true


## Looks at what is shown now.
func look() -> void:
	var formula: Formula = _frame.lesson.services.get(&"formula")
	if formula:
		read_count += 1
		var problems: PackedStringArray = _reader.call(&"problems", _lines_of(formula))
		for sentence in problems:
			_tell(sentence)
	var seen := SeenLesson.of(_frame)
	for problem: String in [_judge.problem(seen), _problem_of_unit(seen)]:
		if problem:
			_tell(problem)


func _look_at(state_count: int, seed_number: int) -> void:
	var lesson := _frame.lesson
	var states := LessonStates.new(lesson, seed_number)
	var wanted: Array[Dictionary] = []
	for i in state_count:
		wanted.append(states.state(i))
	var steps: Steps = lesson.services.get(&"steps")
	var step := 0
	while true:
		if steps:
			steps.go_to(step)
		for i in state_count:
			lesson.show_link(wanted[i])
			look()
			if i % _STATES_IN_A_FRAME == 0:
				await _frame.get_tree().process_frame
		step += 1
		step_seen.emit(step)
		if not steps:
			return
		steps.go_to(step)
		if steps.step < step:
			return


# In radians nothing is written in degrees but what the report calls its cases, and nothing in
# radians otherwise.
func _problem_of_unit(seen: SeenLesson) -> String:
	if _frame.lesson_info.id == &"error_and_time":
		return ""
	var texts := PackedStringArray([seen.sentence]) + seen.verdict + seen.lines + seen.labels
	var other_unit := "°" if Conventions.uses_radians() else "π| rad\\b"
	for text in texts:
		if RegEx.create_from_string(other_unit).search(text):
			return "it is not the unit that was chosen: “%s”" % text
	return ""


func _tell(sentence: String) -> void:
	var step := _frame.lesson.step + 1
	var kind := _number_finder.sub(_remark_finder.sub(sentence, "", true), "0", true)
	if _known.has(kind):
		_known[kind].count += 1
		return
	var finding := Finding.new()
	finding.step = step
	finding.sentence = sentence
	finding.link = _frame.link.text()
	_known[kind] = finding
	findings.append(finding)


# The lines of a formula. A field has another minus sign than a label.
static func _lines_of(formula: Formula) -> PackedStringArray:
	var lines: PackedStringArray = []
	for row in formula.get_children():
		var line := ""
		for part in row.get_children():
			if part is LineEdit:
				line += (part as LineEdit).text.replace("-", NumberText.MINUS)
			elif part is Label:
				line += (part as Label).text
		lines.append(line)
	return lines
