extends Lesson
## The lesson that proves that a · b̂ is the shadow of a on b: turn both until b lies on the x axis.

## The whole turn takes this long, in seconds, when time runs.
const _TURN_SECONDS := 2.0
## And when a step asks for it.
const _STEP_TURN_SECONDS := 1.0

## Ready-made situations by their titles (source text): x and y of a, x and y of b.
const _PRESETS: Dictionary[String, Array] = {
	"Lecture": [7.0, 1.0, 8.0, -6.0],
	"One bit": [5.0, 1.0, 3.0, 4.0],
	"Obtuse": [-5.0, 2.0, 8.0, -6.0],
	"Right angle": [3.0, 4.0, 8.0, -6.0],
	"Zero": [7.0, 1.0, 0.0, 0.0],
}

var _model := ProjectionProofModel.new()
var _step := ProjectionProofTexts.Step.COMPARE
# The share of the turn that the step asks for, while it is being carried out.
var _wanted_share := 1.0
var _rng := RandomNumberGenerator.new()
var _exercise: TurningExercise
var _exercise_kind := TurningExercise.Kind.TURNED_A

var _steps: Steps
var _formula: ProjectionProofFormula
var _readout: Readout
var _transport: Transport
var _question: Question

@onready var _drawing: ProjectionProofDrawing = %Drawing
@onready var _plot: Plot = %Plot
@onready var _verdict: VerdictCard = %Verdict


func start() -> void:
	set_process(false)
	_steps = services[&"steps"] as Steps
	_readout = services[&"readout"] as Readout
	_transport = services[&"transport"] as Transport
	_question = services[&"question"] as Question
	_connect_board()
	_connect_services()
	_ask()
	resized.connect(_show_all)
	_show_all()


func state() -> Dictionary:
	return _model.to_dictionary()


func show_state(stored: Dictionary) -> void:
	_model.from_dictionary(stored)
	_show_all()


func _connect_board() -> void:
	board.pointed.connect(_point)
	board.released.connect(_finish)
	_connect_handle(%HeadA as Handle, _move_a)
	_connect_handle(%HeadB as Handle, _move_b)
	_connect_handle(%HeadTurnedA as Handle, _move_turned_a)
	_connect_handle(%HeadTurnedB as Handle, _move_turned_b)
	_plot.x_pointed.connect(_turn_to)


func _connect_handle(handle: Handle, move: Callable) -> void:
	handle.moved.connect(move)
	handle.released.connect(_finish)


func _connect_services() -> void:
	var panel := services[&"formula"] as Formula
	_formula = ProjectionProofFormula.new(panel)
	panel.number_entered.connect(_enter_number)
	var options := services[&"options"] as LessonOptions
	for title: String in _PRESETS:
		options.add_preset(title, tr(title))
	options.preset_picked.connect(_set_up)
	_steps.step_changed.connect(_go_to_step)
	_transport.advanced.connect(_run)
	_question.exercise_wanted.connect(_ask)
	_question.board_wanted.connect(func(_asked: Exercise) -> void: _take(_exercise.a, _exercise.b))


# What the student does.


func _point(at: Vec2, button: MouseButton) -> void:
	if button == MOUSE_BUTTON_LEFT:
		_move_a(board.snapped_to_step(at))
	else:
		_move_b(board.snapped_to_step(at))


func _move_a(head: Vec2) -> void:
	_stop()
	_model.a = head.copy()
	_show_model()


func _move_b(head: Vec2) -> void:
	_stop()
	_model.b = head.copy()
	_show_model()


# What is seen turned is dragged turned.
func _move_turned_a(head: Vec2) -> void:
	_stop()
	_model.set_turned_a(head)
	_show_model()


func _move_turned_b(head: Vec2) -> void:
	_stop()
	_model.set_reach_of_turned_b(head)
	_show_model()


func _turn_to(percent: float) -> void:
	_stop()
	_model.turned_share = percent / 100.0
	_show_turn()


func _run(seconds: float) -> void:
	set_process(false)
	if _transport.is_playing and _model.turned_share == 1.0:
		_model.turned_share = 0.0
	_model.turned_share += seconds / _TURN_SECONDS
	if _model.turned_share == 1.0:
		_transport.is_playing = false
	_show_turn()


func _enter_number(name_in_line: String, value: float) -> void:
	var vector := _model.a if name_in_line[0] == "a" else _model.b
	if name_in_line[1] == "x":
		vector.x = value
	else:
		vector.y = value
	_finish()


func _set_up(preset: String) -> void:
	var numbers: PackedFloat64Array = _PRESETS[preset]
	_take(Vec2.new(numbers[0], numbers[1]), Vec2.new(numbers[2], numbers[3]))


func _take(a: Vec2, b: Vec2) -> void:
	_model.a = a.copy()
	_model.b = b.copy()
	_finish()


func _ask() -> void:
	_exercise = TurningExercise.fresh(_exercise_kind, _rng)
	_exercise_kind = ((_exercise_kind + 1) % TurningExercise.Kind.size() as TurningExercise.Kind)
	_question.show_exercise(_exercise)


func _go_to_step(step: int) -> void:
	_transport.is_playing = false
	_step = step as ProjectionProofTexts.Step
	_wanted_share = 0.0 if _step == ProjectionProofTexts.Step.WANTED else 1.0
	set_process(true)
	_show_all()


func _process(delta: float) -> void:
	_model.turned_share = move_toward(
		_model.turned_share, _wanted_share, delta / _STEP_TURN_SECONDS
	)
	if _model.turned_share == _wanted_share:
		set_process(false)
	_show_turn()


func _stop() -> void:
	set_process(false)
	_transport.is_playing = false


func _finish() -> void:
	_show_all()
	edited.emit()


# What the student sees.


func _show_all() -> void:
	# A little more than the turned b reaches, so that its label stays clear of that of the axis.
	var beyond := _model.fully_turned(_model.b).scaled(1.12)
	board.fit([_model.a, _model.b, _model.fully_turned(_model.a), beyond])
	_show_model()


func _show_model() -> void:
	_steps.show_sentences(ProjectionProofTexts.sentences(_model), _step)
	_formula.show_model(_model, _step)
	_show_verdict()
	_show_way("turned", tr("x of a′"), _model.x_of_turned_a)
	_show_way("dot", "a · " + ProjectionProofTexts.UNIT, _model.dot_with_unit)
	_show_turn()


func _show_turn() -> void:
	_drawing.show_model(_model, _step)
	_formula.show_turn(_model, _step)
	var x_at := func(percent: float) -> float: return _model.x_at_share(percent / 100.0)
	_plot.show_function(x_at, _model.a.length(), _model.turned_share * 100.0)


func _show_verdict() -> void:
	var is_equal := _model.units_apart() == 0.0 and _model.has_direction()
	var role := Palette.Role.RIGHT if is_equal else Palette.Role.QUIET
	var sign_text := "=" if is_equal else "≈"
	_verdict.visible = _step == ProjectionProofTexts.Step.COMPARE or not _model.has_direction()
	_verdict.show_verdict(
		sign_text if _model.has_direction() else "0", role, ProjectionProofTexts.comparison(_model)
	)


func _show_way(key: String, title: String, way: Callable) -> void:
	var value: float = way.call()
	var error := ExactProjection.error_of_scalar_projection(value, _model.a, _model.b)
	_readout.show_result(key, title, value, error, CallTimer.nanoseconds(way))
