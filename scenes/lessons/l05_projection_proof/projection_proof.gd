extends Lesson
## The lesson that proves that a · b̂ is the shadow of a on b: turn both until b lies on the x axis.
##
## Where both vectors end at the start is in the scene: HeadA and HeadB.

## Seconds that the whole turn takes while time runs, and when a step asks for it.
const _TURN_SECONDS := 2.0
const _STEP_TURN_SECONDS := 1.0

## Presets by their titles (source text): what each changes in the model's state.
const _PRESETS: Dictionary[String, Dictionary] = {
	"Lecture": {a = [7.0, 1.0], b = [8.0, -6.0]},
	"One bit": {a = [5.0, 1.0], b = [3.0, 4.0]},
	"Obtuse": {a = [-5.0, 2.0], b = [8.0, -6.0]},
	"Right angle": {a = [3.0, 4.0], b = [8.0, -6.0]},
	"Zero": {a = [7.0, 1.0], b = [0.0, 0.0]},
}

var _model := ProjectionProofModel.new()
var _formula: ProjectionProofFormula
# The share of the turn that the step asks for; _process turns the drawing until it is reached.
var _wanted_share := 1.0

@onready var _steps: Steps = services.get(&"steps")
@onready var _transport: Transport = services.get(&"transport")
@onready var _readout: Readout = services.get(&"readout")
@onready var _drawing: ProjectionProofDrawing = %Drawing
@onready var _plot: Plot = %Plot
@onready var _verdict: VerdictCard = %Verdict


func start() -> void:
	set_process(false)
	_model.set_a((%HeadA as Handle).at())
	_model.set_b((%HeadB as Handle).at())
	_let_drag(%HeadA as Handle, _model.set_a)
	_let_drag(%HeadB as Handle, _model.set_b)
	# What is seen turned is dragged turned.
	_let_drag(%HeadTurnedA as Handle, _model.set_turned_a)
	_let_drag(%HeadTurnedB as Handle, _model.set_reach_of_turned_b)
	on_point(MOUSE_BUTTON_LEFT, func(at: Vec2) -> void: _model.set_a(board.snapped_to_step(at)))
	on_point(MOUSE_BUTTON_RIGHT, func(at: Vec2) -> void: _model.set_b(board.snapped_to_step(at)))
	_plot.x_pointed.connect(_turn_to)
	_fill_panel()
	begin(_model, _show, _model.points_to_show)


func _let_drag(handle: Handle, change: Callable) -> void:
	on_drag(handle.moved, handle.released, change)


func _fill_panel() -> void:
	var formula := services[&"formula"] as Formula
	_formula = ProjectionProofFormula.new(formula)
	(services[&"options"] as LessonOptions).offer_presets(_PRESETS)
	var kinds := TurningExercise.Kind.size()
	(services[&"question"] as Question).offer(TurningExercise.fresh, kinds)
	_steps.step_changed.connect(_turn_for_step)
	_transport.advanced.connect(_run)
	on_edit(formula.number_entered, _model.enter)
	on_pick(_model.take)


# The turn is not part of the state: undo and reset change the vectors, and the turn goes on.
func show_state(stored: Dictionary) -> void:
	_model.from_dictionary(stored)
	show_all()


# The turn.


# A drag also stops the turn that a step has begun.
func pause() -> void:
	set_process(false)
	super()


func _turn_to(percent: float) -> void:
	pause()
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


func _turn_for_step(step: int) -> void:
	pause()
	_wanted_share = 0.0 if step == ProjectionProofTexts.Step.WANTED else 1.0
	set_process(true)


func _process(delta: float) -> void:
	var share := move_toward(_model.turned_share, _wanted_share, delta / _STEP_TURN_SECONDS)
	_model.turned_share = share
	if share == _wanted_share:
		set_process(false)
	_show_turn()


# What the student sees.


func _show() -> void:
	_steps.tell(ProjectionProofTexts.sentences(_model))
	_formula.show_model(_model)
	_show_verdict()
	_show_way("turned", tr("x of a′"), _model.x_of_turned_a)
	_show_way("dot", "a · " + ProjectionProofTexts.UNIT, _model.dot_with_unit)
	_show_turn()


# What changes during the turn; the results do not.
func _show_turn() -> void:
	_drawing.show_model(_model, _steps.step)
	_formula.show_turn(_model, _steps.step)
	var x_at := func(percent: float) -> float: return _model.x_at_share(percent / 100.0)
	_plot.show_function(x_at, _model.a.length(), _model.turned_share * 100.0)


func _show_verdict() -> void:
	var is_equal := _model.units_apart() == 0.0 and _model.has_direction()
	var role := Palette.Role.RIGHT if is_equal else Palette.Role.QUIET
	var sign_text := "=" if is_equal else "≈"
	if not _model.has_direction():
		sign_text = "0"
	var is_last := _steps.step == ProjectionProofTexts.Step.COMPARE
	_verdict.visible = is_last or not _model.has_direction()
	_verdict.show_verdict(sign_text, role, ProjectionProofTexts.comparison(_model))


func _show_way(key: String, title: String, way: Callable) -> void:
	var value: float = way.call()
	var error := ExactProjection.error_of_scalar_projection(value, _model.a, _model.b)
	_readout.show_result(key, title, value, error, CallTimer.nanoseconds(way))
