extends Lesson
## The lesson on the dot product: two vectors, the shadow of one on the other, and the numbers
## beside them. Where both vectors lie at the start is in the scene.

## The sweep turns the shadowed vector this fast, in degrees a second.
const _SWEEP_SPEED := 30.0

var _model := DotProductModel.new()
var _formula: DotProductFormula

@onready var _readout: Readout = services.get(&"readout")
@onready var _drawing: DotProductDrawing = %Drawing
@onready var _a: DraggableVector = %A
@onready var _b: DraggableVector = %B
@onready var _plot: Plot = %Plot
@onready var _verdict: VerdictCard = %Verdict


func start() -> void:
	_move_a(_a.tail_point(), _a.head_point())
	_move_b(_b.tail_point(), _b.head_point())
	on_point(MOUSE_BUTTON_LEFT, func(at: Vec2) -> void: _model.a_head = board.snapped_to_step(at))
	on_point(MOUSE_BUTTON_RIGHT, func(at: Vec2) -> void: _model.b_head = board.snapped_to_step(at))
	on_drag(_a.moved, _a.released, _move_a)
	on_drag(_b.moved, _b.released, _move_b)
	on_drag(_plot.x_pointed, _plot.released, _turn_to)
	_formula = DotProductFormula.new(services[&"formula"] as Formula)
	on_enter(_enter_number)
	on_move((services[&"transport"] as Transport).advanced, _sweep)
	var options := services[&"options"] as LessonOptions
	options.add_switch("normalizes", tr("Normalize"))
	options.add_switch("is_swapped", tr("b on a"))
	options.offer_presets(DotProductModel.PRESETS)
	var kinds := ProjectionExercise.Kind.size()
	(services[&"question"] as Question).offer(ProjectionExercise.fresh, kinds, 1)
	on_pick(_model.take)
	begin(_model, _show, _model.ends)


# What the student does.


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
	match name_in_line:
		"ax":
			_model.a_head.x = _model.a_tail.x + value
		"ay":
			_model.a_head.y = _model.a_tail.y + value
		"bx":
			_model.b_head.x = _model.b_tail.x + value
		"by":
			_model.b_head.y = _model.b_tail.y + value


# What the student sees.


func _show() -> void:
	tell_steps(DotProductTexts.sentences(_model))
	_drawing.show_model(_model, step)
	_formula.show_model(_model, step)
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
	_readout.show_result(key, title, value, error, CallTimer.nanoseconds(method))
