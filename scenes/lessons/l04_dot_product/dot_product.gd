extends Lesson
## The lesson on the dot product: two vectors, the shadow of one on the other, and the numbers
## beside them. Where both vectors lie at the start is in the scene.

const _LAST_STEP := 4
## The sweep turns the shadowed vector this fast, in degrees a second.
const _SWEEP_SPEED := 30.0

## Presets by their titles (source text): x and y of a, x and y of b.
const _PRESETS: Dictionary[String, Array] = {
	"Lecture": [7.0, 1.0, 8.0, -6.0],
	"Right angle": [4.0, 3.0, 6.0, -8.0],
	"Obtuse": [-5.0, 2.0, 8.0, -6.0],
	"Huge": [4e15, 3e15, 6e15, -8e15],
	"Zero": [7.0, 1.0, 0.0, 0.0],
}

var _model := DotProductModel.new()
var _formula: DotProductFormula
var _steps: Steps
var _options: LessonOptions

@onready var _drawing: DotProductDrawing = %Drawing
@onready var _a: DraggableVector = %A
@onready var _b: DraggableVector = %B
@onready var _plot: Plot = %Plot
@onready var _verdict: VerdictCard = %Verdict


func start() -> void:
	_move_a(_a.tail_point(), _a.head_point())
	_move_b(_b.tail_point(), _b.head_point())
	on_drag(board.pointed, board.released, _point)
	on_drag(_a.moved, _a.released, _move_a)
	on_drag(_b.moved, _b.released, _move_b)
	on_drag(_plot.x_pointed, _plot.released, _turn_to)
	_fill_panel()
	begin(_model, _show, _model.ends)


func _fill_panel() -> void:
	var formula := services[&"formula"] as Formula
	_formula = DotProductFormula.new(formula)
	on_edit(formula.number_entered, _enter_number)
	_steps = services[&"steps"] as Steps
	_steps.open_at(_LAST_STEP)
	on_move((services[&"transport"] as Transport).advanced, _sweep)
	_options = services[&"options"] as LessonOptions
	_options.add_switch("normalizes", tr("Normalize"))
	_options.add_switch("is_swapped", tr("b on a"))
	_options.add_presets(_PRESETS.keys())
	on_edit(_options.switched, _model.set)
	on_edit(_options.preset_picked, _set_up)
	var question := services[&"question"] as Question
	question.offer(ProjectionExercise.fresh, ProjectionExercise.Kind.size(), 1)
	on_edit(question.board_wanted, _show_exercise)


# What the student does.


func _point(at: Vec2, button: MouseButton) -> void:
	var head := board.snapped_to_step(at)
	if button == MOUSE_BUTTON_LEFT:
		_move_a(_model.a_tail, head)
	else:
		_move_b(_model.b_tail, head)


func _move_a(tail: Vec2, head: Vec2) -> void:
	_model.a_tail = tail.copy()
	_model.a_head = head.copy()


func _move_b(tail: Vec2, head: Vec2) -> void:
	_model.b_tail = tail.copy()
	_model.b_head = head.copy()


func _turn_to(degrees: float) -> void:
	_model.set_signed_angle_degrees(roundf(degrees))


func _sweep(seconds: float) -> void:
	_model.set_signed_angle_degrees(_model.signed_angle_degrees() + _SWEEP_SPEED * seconds)


func _enter_number(name_in_line: String, value: float) -> void:
	var tail := _model.a_tail if name_in_line[0] == "a" else _model.b_tail
	var head := _model.a_head if name_in_line[0] == "a" else _model.b_head
	if name_in_line[1] == "x":
		head.x = tail.x + value
	else:
		head.y = tail.y + value


func _set_up(preset: String) -> void:
	var numbers: PackedFloat64Array = _PRESETS[preset]
	_move_a(Vec2.new(), Vec2.new(numbers[0], numbers[1]))
	_move_b(Vec2.new(), Vec2.new(numbers[2], numbers[3]))


func _show_exercise(exercise: ProjectionExercise) -> void:
	_move_a(Vec2.new(), exercise.a)
	_move_b(Vec2.new(), exercise.b)


# What the student sees.


func _show() -> void:
	_drawing.show_model(_model, _steps.step)
	_formula.show_model(_model, _steps.step)
	_steps.tell(DotProductTexts.sentences(_model))
	_options.show_switch("normalizes", _model.normalizes)
	_options.show_switch("is_swapped", _model.is_swapped)
	_show_verdict()
	_show_plot()
	_show_calls()


# With the course's ball: green ahead, red behind.
func _show_verdict() -> void:
	var roles: Array[Palette.Role] = [Palette.Role.WRONG, Palette.Role.QUIET, Palette.Role.RIGHT]
	var sign_text: String = [NumberText.MINUS, "0", "+"][_model.side() + 1]
	_verdict.show_verdict(sign_text, roles[_model.side() + 1], DotProductTexts.verdict(_model))


func _show_plot() -> void:
	var reach := _model.a().length() * _model.b().length()
	var product := func(degrees: float) -> float: return reach * cos(Vec2.deg_to_rad(degrees))
	_plot.show_function(product, reach, _model.signed_angle_degrees())


func _show_calls() -> void:
	var shadowed := _model.shadowed()
	var onto := _model.onto()
	var by_dot := shadowed.scalar_projection.bind(onto)
	if not _model.normalizes:
		by_dot = shadowed.dot.bind(onto)
	_show_call("dot", tr("dot product"), by_dot)
	_show_call("primitive", tr("atan2 and cos"), PrimitiveProjection.scalar.bind(shadowed, onto))


func _show_call(key: String, title: String, method: Callable) -> void:
	var value: float = method.call()
	var error := ExactProjection.error_of_scalar_projection(value, _model.shadowed(), _model.onto())
	var readout := services[&"readout"] as Readout
	readout.show_result(key, title, value, error, CallTimer.nanoseconds(method))
