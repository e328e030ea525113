class_name OwnCode
extends FoldableContainer
## What the lab says of the student's own code for one lesson: the first exercise of the lesson that
## is not right yet, and how far he has come. Folded while nothing is written.

## The student wants to write the methods of [param exercise] in the lab itself.
signal write_wanted(exercise: WorkshopExercise)

## Its action, with what it does in a word for the help line: source text.
const ACTIONS: Dictionary[StringName, String] = {&"lab_check_code": "check your code"}

# How much of its color has what was said of the file before.
const _FAINT := Color(1.0, 1.0, 1.0, 0.45)

## The student has folded it: it unfolds by itself no more, in no lesson.
static var stays_folded := false

var _lesson: Lesson
var _watcher: WorkshopWatcher
var _exercises: Array[WorkshopExercise] = []
var _was_unfolded := false
# Whether a verdict is shown, and whether the next one is about a file that was saved since then.
var _has_verdict := false
var _is_new := false
# Whether the sentence has the right numbers in it.
var _tells_numbers := false

@onready var _verdict: Control = %Verdict
@onready var _ball: Control = %Ball
@onready var _sign: Label = %Sign
@onready var _heading: Label = %Heading
@onready var _place: Label = %Place
@onready var _sentence: Label = %Sentence
@onready var _probe: Control = %Probe
@onready var _called: Label = %Called
@onready var _got: Label = %Got
@onready var _wanted: Label = %Wanted
@onready var _costs: Control = %Costs
@onready var _error: Label = %Error
@onready var _time: Label = %Time
@onready var _ratio: Label = %Ratio
@onready var _tests: Label = %Tests
@onready var _mark: Label = %Mark
@onready var _checking: Label = %Checking


func _ready() -> void:
	# Nobody is followed yet.
	set_process(false)
	set_process_unhandled_input(false)
	folding_changed.connect(func(is_closed: bool) -> void: stays_folded = is_closed)


## Shows from now on what [param watcher] hears about [param exercises], those of [param lesson] in
## their order.
func follow(lesson: Lesson, watcher: WorkshopWatcher, exercises: Array[WorkshopExercise]) -> void:
	_lesson = lesson
	_watcher = watcher
	_exercises = exercises
	set_process(true)
	set_process_unhandled_input(true)
	(%Check as Button).pressed.connect(watcher.check_now)
	watcher.began.connect(_grow_old)
	watcher.judged.connect(_show_report)
	var write := %Write as Button
	write.visible = not WorkshopChild.can_run()
	write.pressed.connect(_want_to_write)
	_heading.text = OwnCodeTexts.heading(exercises[0])
	if watcher.report:
		_show_report(watcher.report)


## Unfolds it, and brings it into view.
func unfold() -> void:
	_unfold()
	get_tree().process_frame.connect(_come_into_view, CONNECT_ONE_SHOT)


func _process(_seconds: float) -> void:
	# Blank, it keeps its place.
	var is_judging := not _watcher.report or _watcher.is_judging()
	_checking.self_modulate.a = 1.0 if is_judging else 0.0
	# The right numbers may be those that the lesson asks for.
	_wanted.self_modulate.a = 0.0 if _lesson.is_asking() else 1.0
	_sentence.self_modulate.a = 0.0 if _lesson.is_asking() and _tells_numbers else 1.0


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"lab_check_code", false, true):
		_watcher.check_now()


func _want_to_write() -> void:
	var exercise := _exercise_to_show(_watcher.report) if _watcher.report else null
	write_wanted.emit(exercise if exercise else _exercises[0])


func _grow_old() -> void:
	_is_new = _has_verdict
	_verdict.modulate = _FAINT
	for row: Control in [_probe, _costs]:
		row.modulate = _FAINT


func _show_report(report: WorkshopReport) -> void:
	var exercise := _exercise_to_show(report)
	if not exercise:
		return
	_show_verdict(exercise, report.verdict(exercise.number))
	_tests.text = OwnCodeTexts.tests(report.tests)
	_tests.visible = _tests.text != ""
	if report.is_complete:
		_mark.text = OwnCodeTexts.mark(report)
	_unfold_once(report)
	if _is_new and not folded:
		get_tree().process_frame.connect(_come_into_view, CONNECT_ONE_SHOT)
	_is_new = _is_new and not report.is_complete
	_has_verdict = true


# The first that is not right, else the last one; null while that is not known.
func _exercise_to_show(report: WorkshopReport) -> WorkshopExercise:
	for exercise in _exercises:
		if not report.is_right(exercise.number):
			return exercise if report.verdict(exercise.number) else null
	return _exercises[-1]


func _show_verdict(exercise: WorkshopExercise, verdict: WorkshopVerdict) -> void:
	_verdict.modulate = Color.WHITE
	_sign.text = OwnCodeTexts.sign_of(verdict)
	_ball.self_modulate = Palette.color(OwnCodeTexts.role_of(verdict))
	_heading.text = OwnCodeTexts.heading(exercise)
	_place.text = OwnCodeTexts.place(verdict)
	_sentence.text = verdict.sentence
	_tells_numbers = verdict.kind == WorkshopVerdict.Kind.UNKNOWN
	_show_probe(exercise.task(verdict.method), verdict)
	_show_costs(verdict)


func _show_probe(task: WorkshopTask, verdict: WorkshopVerdict) -> void:
	_probe.modulate = Color.WHITE
	_probe.visible = task != null and verdict.probe != "" and not verdict.wanted.is_empty()
	if _probe.visible:
		_called.text = "%s: %s" % [verdict.method, verdict.probe]
		_got.text = OwnCodeTexts.answer(task, verdict.got)
		_wanted.text = OwnCodeTexts.answer(task, verdict.wanted)


func _show_costs(verdict: WorkshopVerdict) -> void:
	_costs.modulate = Color.WHITE
	_costs.visible = not verdict.costs.is_empty()
	if _costs.visible:
		_error.text = NumberText.size(verdict.error())
		_time.text = OwnCodeTexts.run_time(verdict)
		_ratio.text = OwnCodeTexts.ratio(verdict)


# By itself it does so once, when something is written; what the student folds counts after that.
func _unfold_once(report: WorkshopReport) -> void:
	if _was_unfolded or stays_folded or not _exercises.any(_is_begun.bind(report)):
		return
	_unfold()


# The student has not done it himself.
func _unfold() -> void:
	_was_unfolded = true
	set_block_signals(true)
	folded = false
	set_block_signals(false)


static func _is_begun(exercise: WorkshopExercise, report: WorkshopReport) -> bool:
	var verdict := report.verdict(exercise.number)
	return verdict != null and verdict.kind != WorkshopVerdict.Kind.OPEN


# The student looks at his editor: when he comes back, the sentence is there.
func _come_into_view() -> void:
	var above := get_parent()
	while above and not above is ScrollContainer:
		above = above.get_parent()
	if above:
		for part: Control in [_tests, _costs, _probe, _sentence, _verdict]:
			if part.is_visible_in_tree():
				(above as ScrollContainer).ensure_control_visible(part)
