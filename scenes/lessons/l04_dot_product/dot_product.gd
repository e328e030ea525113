extends Lesson
## The lesson on the dot product: two vectors, the shadow of one on the other, and the numbers
## beside them.

const _STEP_COUNT := 5
## The sweep turns the shadowed vector this fast, in degrees a second.
const _SWEEP_SPEED := 30.0

## Ready-made situations by their titles (source text): x and y of a, x and y of b.
const _PRESETS: Dictionary[String, Array] = {
	"Lecture": [7.0, 1.0, 8.0, -6.0],
	"Right angle": [4.0, 3.0, 6.0, -8.0],
	"Obtuse": [-5.0, 2.0, 8.0, -6.0],
	"Huge": [4e15, 3e15, 6e15, -8e15],
	"Zero": [7.0, 1.0, 0.0, 0.0],
}

var _model := DotProductModel.new()
var _step := _STEP_COUNT - 1
var _rng := RandomNumberGenerator.new()
var _exercise: ProjectionExercise
var _exercise_kind := ProjectionExercise.Kind.SCALAR

var _steps: Steps
var _formula: DotProductFormula
var _readout: Readout
var _options: LessonOptions
var _transport: Transport
var _question: Question

@onready var _drawing: DotProductDrawing = %Drawing
@onready var _a: DraggableVector = %A
@onready var _b: DraggableVector = %B
@onready var _plot: Plot = %Plot
@onready var _verdict: VerdictCard = %Verdict


func start() -> void:
	_bring_services()
	_connect_board()
	_connect_formula()
	_fill_options()
	_ask()
	resized.connect(_show_all)
	_show_all()


func state() -> Dictionary:
	return _model.to_dictionary()


func show_state(stored: Dictionary) -> void:
	_model.from_dictionary(stored)
	_show_all()


func _bring_services() -> void:
	_steps = services[&"steps"] as Steps
	_readout = services[&"readout"] as Readout
	_options = services[&"options"] as LessonOptions
	_transport = services[&"transport"] as Transport
	_question = services[&"question"] as Question


func _connect_board() -> void:
	pointed.connect(_point)
	released.connect(_finish)
	_a.moved.connect(_move_a)
	_b.moved.connect(_move_b)
	_a.released.connect(_finish)
	_b.released.connect(_finish)
	_plot.x_pointed.connect(_turn_to)
	_plot.released.connect(_finish)
	_steps.step_changed.connect(_go_to_step)
	_transport.advanced.connect(_sweep)


func _connect_formula() -> void:
	var panel := services[&"formula"] as Formula
	_formula = DotProductFormula.new(panel)
	panel.number_entered.connect(_enter_number)
	panel.role_pointed.connect(_drawing.light)
	panel.refused.connect(noticed.emit)


func _fill_options() -> void:
	_options.add_switch("normalizes", tr("Normalize"))
	_options.add_switch("is_swapped", tr("b on a"))
	_options.switched.connect(_switch)
	for title: String in _PRESETS:
		_options.add_preset(title, tr(title))
	_options.preset_picked.connect(_set_up)
	_question.exercise_wanted.connect(_ask)
	_question.board_wanted.connect(_show_exercise)


# What the student does.


func _point(at: Vec2, button: MouseButton) -> void:
	var head := snapped_to_step(at)
	if button == MOUSE_BUTTON_LEFT:
		_move_a(_model.a_tail, head)
	else:
		_move_b(_model.b_tail, head)


func _move_a(tail: Vec2, head: Vec2) -> void:
	_transport.is_playing = false
	_model.a_tail = tail.copy()
	_model.a_head = head.copy()
	_show_model()


func _move_b(tail: Vec2, head: Vec2) -> void:
	_transport.is_playing = false
	_model.b_tail = tail.copy()
	_model.b_head = head.copy()
	_show_model()


func _turn_to(degrees: float) -> void:
	_transport.is_playing = false
	_model.set_signed_angle_degrees(roundf(degrees))
	_show_model()


func _sweep(seconds: float) -> void:
	_model.set_signed_angle_degrees(_model.signed_angle_degrees() + _SWEEP_SPEED * seconds)
	_show_model()


func _enter_number(name_in_line: String, value: float) -> void:
	var tail := _model.a_tail if name_in_line[0] == "a" else _model.b_tail
	var head := _model.a_head if name_in_line[0] == "a" else _model.b_head
	if name_in_line[1] == "x":
		head.x = tail.x + value
	else:
		head.y = tail.y + value
	_finish()


func _switch(key: String, on: bool) -> void:
	_model.set(key, on)
	_finish()


func _set_up(preset: String) -> void:
	var numbers: PackedFloat64Array = _PRESETS[preset]
	_lay_from_origin(Vec2.new(numbers[0], numbers[1]), Vec2.new(numbers[2], numbers[3]))


func _show_exercise() -> void:
	_lay_from_origin(_exercise.a, _exercise.b)


func _lay_from_origin(a: Vec2, b: Vec2) -> void:
	_model.a_tail = Vec2.new()
	_model.b_tail = Vec2.new()
	_model.a_head = a.copy()
	_model.b_head = b.copy()
	_finish()


func _ask() -> void:
	_exercise = ProjectionExercise.fresh(_exercise_kind, _rng)
	_exercise_kind = (
		(_exercise_kind + 1) % ProjectionExercise.Kind.size() as ProjectionExercise.Kind
	)
	_question.show_exercise(_exercise)


func _go_to_step(step: int) -> void:
	_step = step
	_show_all()


func _finish() -> void:
	_show_all()
	edited.emit()


# What the student sees.


func _show_all() -> void:
	fit([_model.a_tail, _model.a_head, _model.b_tail, _model.b_head])
	_options.show_switch("normalizes", _model.normalizes)
	_options.show_switch("is_swapped", _model.is_swapped)
	_steps.show_sentences(DotProductTexts.sentences(_model), _step)
	_show_model()


func _show_model() -> void:
	_drawing.show_model(_model, _step)
	_formula.show_model(_model, _step)
	_show_verdict()
	_show_plot()
	_show_readout()


# With the course's ball: green ahead, red behind.
func _show_verdict() -> void:
	var roles: Array[Palette.Role] = [Palette.Role.WRONG, Palette.Role.QUIET, Palette.Role.RIGHT]
	var sign_text: String = [NumberText.MINUS, "0", "+"][_model.side() + 1]
	_verdict.show_verdict(sign_text, roles[_model.side() + 1], DotProductTexts.verdict(_model))


func _show_plot() -> void:
	var reach := _model.a().length() * _model.b().length()
	var product := func(degrees: float) -> float: return reach * cos(Vec2.deg_to_rad(degrees))
	_plot.show_function(product, reach, _model.signed_angle_degrees())


func _show_readout() -> void:
	var shadowed := _model.shadowed()
	var onto := _model.onto()
	var dot_way := shadowed.dot.bind(onto)
	if _model.normalizes:
		dot_way = shadowed.scalar_projection.bind(onto)
	_show_way("dot", tr("dot product"), dot_way)
	_show_way("primitive", tr("atan2 and cos"), PrimitiveProjection.scalar.bind(shadowed, onto))


func _show_way(key: String, title: String, way: Callable) -> void:
	var value: float = way.call()
	var error := ExactProjection.error_of_scalar_projection(value, _model.shadowed(), _model.onto())
	_readout.show_result(key, title, value, error, CallTimer.nanoseconds(way))
