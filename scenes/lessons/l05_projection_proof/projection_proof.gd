extends Lesson
## The lesson that proves that a · b̂ is the shadow of a on b: turn both until b lies on the x axis.
##
## Where both vectors end at the start is in the scene: HeadA and HeadB.

## Seconds that the whole turn takes while time runs, and when a step asks for it.
const _TURN_SECONDS := 2.0
const _STEP_TURN_SECONDS := 1.0
## The opening swings a so far to both sides, in degrees, and so often in 20 seconds.
const _SWING := 25.0
const _SWINGS := 2.0

var _model := ProjectionProofModel.new()
var _formula: ProjectionProofFormula
# The share of the turn that the step asks for; _process turns the drawing until it is reached.
var _wanted_share := 0.0

@onready var _transport: Transport = services.get(&"transport")
@onready var _readout: Readout = services.get(&"readout")
@onready var _drawing: ProjectionProofDrawing = %Drawing
@onready var _plot: Plot = %Plot
@onready var _verdict: VerdictCard = %Verdict


func start() -> void:
	set_process(false)
	_model.set_a((%HeadA as Handle).at())
	_model.set_b((%HeadB as Handle).at())
	on_handle(%HeadA as Handle, _model.set_a)
	on_handle(%HeadB as Handle, _model.set_b)
	# What is seen turned is dragged turned.
	on_handle(%HeadTurnedA as Handle, _model.set_turned_a)
	on_handle(%HeadTurnedB as Handle, _model.set_reach_of_turned_b)
	on_point(MOUSE_BUTTON_LEFT, func(at: Vec2) -> void: _model.set_a(board.snapped_to_step(at)))
	on_point(MOUSE_BUTTON_RIGHT, func(at: Vec2) -> void: _model.set_b(board.snapped_to_step(at)))
	_plot.x_pointed.connect(_turn_to)
	add_child(CardPlace.new(_plot, board, services[&"steps"]))
	_formula = ProjectionProofFormula.new(services[&"formula"] as Formula)
	offer_presets(ProjectionProofModel.PRESETS)
	offer_questions(TurningExercise, TurningExercise.of_the_lecture)
	(services[&"steps"] as Steps).step_changed.connect(_turn_for_step)
	_transport.advanced.connect(_run)
	_model.turned_share = 0.0
	begin(_model, _show, _model.points_to_show)
	open_with_swing(_swing.bind(_model.a.copy()), _SWINGS)


# The turn is not part of the state: undo and reset change the vectors, and the turn goes on.
func show_state(stored: Dictionary) -> void:
	_model.from_dictionary(stored)
	show_all()


# What moves by itself, to hundredths.
func _swing(share: float, first: Vec2) -> void:
	var swung := first.copy()
	swung.rotate_degrees(_SWING * share)
	_model.set_a(Vec2.new(snappedf(swung.x, 0.01), snappedf(swung.y, 0.01)))


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
	var turned := seconds / _TURN_SECONDS
	_model.turned_share = _transport.flown(_model.turned_share, turned, 1.0)
	_show_turn()


func _turn_for_step(to: int) -> void:
	pause()
	_wanted_share = 0.0 if to == ProjectionProofTexts.Step.WANTED else 1.0
	set_process(true)


func _process(delta: float) -> void:
	var share := move_toward(_model.turned_share, _wanted_share, delta / _STEP_TURN_SECONDS)
	_model.turned_share = share
	if share == _wanted_share:
		set_process(false)
	_show_turn()


# What the student sees.


func _show() -> void:
	ask_before(
		ProjectionProofTexts.Step.TURN,
		ProjectionProofTexts.question_on_turn(),
		func() -> Vec2: return _model.fully_turned(_model.a) if _model.has_direction() else null,
		func() -> Vec2: return _model.a.scaled(0.7)
	)
	ask_choice_before(
		ProjectionProofTexts.Step.READ_OFF,
		ProjectionProofTexts.question_on_shadow(),
		ProjectionProofTexts.choices(),
		ProjectionProofTexts.right_choice.bind(_model)
	)
	_formula.show_model(_model)
	var is_last := step == ProjectionProofTexts.Step.COMPARE
	_readout.visible = is_last and _model.has_direction()
	_show_way("turned", tr("x of a′"), _model.x_of_turned_a)
	_show_way("dot", "a · " + ProjectionProofTexts.UNIT, _model.dot_with_unit)
	_show_turn()
	_show_verdict()


# What changes during the turn; the results do not.
func _show_turn() -> void:
	tell_steps(ProjectionProofTexts.sentences(_model))
	tell_code(ProjectionProofCode.lines(_model, step), ProjectionProofCode.inputs(_model))
	_drawing.show_model(_model, step)
	_formula.show_turn(_model, step)
	var x_at := func(percent: float) -> float: return _model.x_at_share(percent / 100.0)
	_plot.visible = step >= ProjectionProofTexts.Step.TURN and _model.has_direction()
	_plot.show_function(x_at, _model.a.length(), _model.turned_share * 100.0)


func _show_verdict() -> void:
	var is_equal := _model.units_apart() == 0.0 and _model.has_direction()
	var role := Palette.Role.RIGHT if is_equal else Palette.Role.QUIET
	var sign_text := "=" if is_equal else "≈"
	if not _model.has_direction():
		sign_text = "0"
	var is_last := step == ProjectionProofTexts.Step.COMPARE
	_verdict.visible = is_last or not _model.has_direction()
	_verdict.show_verdict(sign_text, role, ProjectionProofTexts.comparison(_model))


func _show_way(key: String, title: String, way: Callable) -> void:
	var value: float = way.call()
	var error := ExactProjection.error_of_scalar_projection(value, _model.a, _model.b)
	_readout.show_result(key, title, value, error, CallTimer.nanoseconds(way))
