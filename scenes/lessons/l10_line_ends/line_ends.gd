extends Lesson
## The lesson on line ends: the same shot at five kinds of line, and the touch on a round cap by a
## quadratic.

## One frame lasts so many seconds when it is played.
const _SECONDS_PER_FRAME := 2.0

var _model := LineEndsModel.new()
var _step := LineEndsTexts.Step.size() - 1
var _rng := RandomNumberGenerator.new()
var _exercise: CapExercise
# Why the last change could not be taken; "" where it could.
var _refusal := ""
var _exercise_kind := CapExercise.Kind.FRACTION

var _steps: Steps
var _formula: LineEndsFormula
var _readout: LineEndsReadout
var _transport: Transport
var _mistakes: Mistakes
var _question: Question

@onready var _drawing: LineEndsDrawing = %Drawing


func start() -> void:
	_steps = services[&"steps"] as Steps
	_readout = LineEndsReadout.new(services[&"readout"] as Readout)
	_transport = services[&"transport"] as Transport
	_mistakes = services[&"mistakes"] as Mistakes
	_question = services[&"question"] as Question
	_connect_board()
	_connect_formula()
	_connect_panel()
	_ask()
	resized.connect(_show_all)
	_show_all()


func state() -> Dictionary:
	return _model.to_dictionary()


func show_state(stored: Dictionary) -> void:
	_transport.is_playing = false
	_model.from_dictionary(stored)
	_show_all()


func link_problem(linked: Dictionary) -> String:
	return LineEndsModel.problem_of(linked)


func _connect_board() -> void:
	_drawing.shot_moved.connect(_move_shot)
	_drawing.line_moved.connect(_move_line)
	_drawing.released.connect(_finish)


func _connect_formula() -> void:
	var panel := services[&"formula"] as Formula
	_formula = LineEndsFormula.new(panel)
	panel.number_entered.connect(_enter_number)


func _connect_panel() -> void:
	var options := services[&"options"] as LessonOptions
	for title: String in LineEndsPresets.SHOTS:
		options.add_preset(title, tr(title))
	options.preset_picked.connect(_set_up)
	for mistake in LineEndsMistakeTexts.infos():
		_mistakes.add_mistake(mistake)
	_mistakes.mistake_picked.connect(_switch_mistake)
	_steps.step_changed.connect(_go_to_step)
	_transport.advanced.connect(_advance)
	_question.exercise_wanted.connect(_ask)
	_question.board_wanted.connect(_show_exercise.unbind(1))


# What the student does.


func _move_shot(tail: Vec2, head: Vec2) -> void:
	_transport.is_playing = false
	_change(
		func() -> void:
			_model.start = tail.copy()
			_model.motion = head.minus(tail)
	)


func _move_line(from: Vec2, to: Vec2) -> void:
	_transport.is_playing = false
	_change(func() -> void: _model.segment = LineSegment.new(from, to))


# What cannot be is refused: the old shot stays.
func _change(edit: Callable) -> void:
	var old := _model.to_dictionary()
	edit.call()
	_refusal = _model.problem()
	if _refusal:
		_model.from_dictionary(old)
	_show_model()


func _enter_number(name_in_line: String, value: float) -> void:
	_refusal = LineEndsFormula.enter(_model, name_in_line, value)
	_finish()


func _set_up(preset: String) -> void:
	LineEndsPresets.lay(_model, preset)
	_finish()


# A mistake that this shot would not show brings its own shot along.
func _switch_mistake(number: int) -> void:
	_model.mistake = number
	if number != 0 and not LineEndsMistakes.shows(number, _model):
		LineEndsPresets.lay(_model, LineEndsMistakeTexts.telling_preset(number))
	_finish()


func _advance(seconds: float) -> void:
	if _transport.is_playing and _model.fraction >= 1.0:
		_model.fraction = 0.0
	_model.fraction = clampf(_model.fraction + seconds / _SECONDS_PER_FRAME, 0.0, 1.0)
	if _model.fraction >= 1.0:
		_transport.is_playing = false
	_drawing.show_model(_model, _step)


func _show_exercise() -> void:
	_exercise.lay(_model)
	_finish()


func _ask() -> void:
	_exercise = CapExercise.fresh(_exercise_kind, _rng)
	_exercise_kind = (_exercise_kind + 1) % CapExercise.Kind.size() as CapExercise.Kind
	_question.show_exercise(_exercise)


func _go_to_step(step: int) -> void:
	_step = step
	_show_all()


func _finish() -> void:
	_show_all()
	edited.emit()
	noticed.emit(_refusal)
	_refusal = ""


# What the student sees.


func _show_all() -> void:
	_drawing.fit(_model)
	_steps.show_sentences(LineEndsTexts.sentences(), _step)
	_mistakes.show_mistake(_model.mistake)
	_show_model()


func _show_model() -> void:
	_drawing.show_model(_model, _step)
	_formula.show_model(_model, _step)
	_readout.show_model(_model)
