extends Lesson
## The lesson on the dot product: two vectors, the shadow of one on the other, and the numbers beside them.

const _STEP_COUNT := 5
## The sweep turns the shadowed vector this fast, in degrees a second.
const _SWEEP_SPEED := 30.0

## Ready-made situations by their titles (source text): x and y of a, x and y of b.
const _PRESETS: Dictionary[String, PackedFloat64Array] = {
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
var _formula: Formula
var _readout: Readout
var _options: Options
var _transport: Transport
var _question: Question

@onready var _a: DraggableVector = %A
@onready var _b: DraggableVector = %B
@onready var _unit: Arrow = %Unit
@onready var _projection: Arrow = %Projection
@onready var _rest: Arrow = %Rest
@onready var _tail_shadow: Arrow = %TailShadow
@onready var _head_shadow: Arrow = %HeadShadow
@onready var _angle: AngleArc = %Angle
@onready var _right_angle: AngleArc = %RightAngle
@onready var _plot: Plot = %Plot
@onready var _verdict: SignVerdict = %Verdict


func start() -> void:
	_bring_services()
	_connect_board()
	_define_formula()
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
	_formula = services[&"formula"] as Formula
	_readout = services[&"readout"] as Readout
	_options = services[&"options"] as Options
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


func _define_formula() -> void:
	_formula.define_symbol("a", "a", Palette.Role.A)
	_formula.define_symbol("b", "b", Palette.Role.B)
	_formula.define_symbol("p", "p", Palette.Role.PROJECTION)
	_formula.define_number("ax", Palette.Role.A, tr("x of a"))
	_formula.define_number("ay", Palette.Role.A, tr("y of a"))
	_formula.define_number("bx", Palette.Role.B, tr("x of b"))
	_formula.define_number("by", Palette.Role.B, tr("y of b"))
	_formula.define_number("e_pair", Palette.Role.UNIT)
	_formula.define_number("dot", Palette.Role.INK)
	_formula.define_number("scalar", Palette.Role.PROJECTION)
	_formula.define_number("p_pair", Palette.Role.PROJECTION)
	_formula.define_number("rest_pair", Palette.Role.REST)
	_formula.define_number("check", Palette.Role.REST)
	_formula.number_entered.connect(_enter_number)
	_formula.role_pointed.connect(_light)
	_formula.refused.connect(noticed.emit)


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
	var head := snapped_to_grid(at)
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
	var numbers := _PRESETS[preset]
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
	_exercise_kind = (_exercise_kind + 1) % ProjectionExercise.Kind.size() as ProjectionExercise.Kind
	_question.show_exercise(_exercise)


func _go_to_step(step: int) -> void:
	_step = step
	_show_all()


func _finish() -> void:
	_show_all()
	edited.emit()


func _light(role: Palette.Role) -> void:
	_a.light(role == Palette.Role.A)
	_b.light(role == Palette.Role.B)
	_unit.lit = role == Palette.Role.UNIT
	_projection.lit = role == Palette.Role.PROJECTION
	_rest.lit = role == Palette.Role.REST


# What the student sees.


func _show_all() -> void:
	fit([_model.a_tail, _model.a_head, _model.b_tail, _model.b_head])
	_options.show_switch("normalizes", _model.normalizes)
	_options.show_switch("is_swapped", _model.is_swapped)
	_steps.show_sentences(DotProductTexts.sentences(_model), _step)
	_show_model()


func _show_model() -> void:
	_a.lay(_model.a_tail, _model.a_head)
	_b.lay(_model.b_tail, _model.b_head)
	_show_projection()
	_show_angle()
	_show_formula()
	_show_readout()
	_verdict.show_sign(_model.side(), _model.scalar_projection())


func _show_projection() -> void:
	var tail := _model.shadowed_tail()
	var head := tail.plus(_model.shadowed())
	var onto_tail := _model.onto_tail()
	var tail_foot := _model.foot(tail)
	var head_foot := _model.foot(head)
	_unit.label = DotProductTexts.unit_symbol(_model)
	_unit.lay(onto_tail, onto_tail.plus(_model.unit()))
	_projection.lay(tail_foot, tail_foot.plus(_model.vector_projection()))
	_rest.lay(tail.plus(_model.vector_projection()), head)
	_tail_shadow.lay(tail, tail_foot)
	_head_shadow.lay(head, head_foot)
	_right_angle.measure(head_foot, _model.onto().negated(), _model.rest())
	_unit.keep_label_from(head)
	_projection.keep_label_from(head)
	_rest.keep_label_from(tail)
	_show_by_step()


func _show_by_step() -> void:
	_unit.visible = _step >= 1 and _model.normalizes
	_tail_shadow.visible = _step >= 2
	_head_shadow.visible = _step >= 2
	_projection.visible = _step >= 3
	_rest.visible = _step >= 4 and _model.normalizes
	_right_angle.visible = _right_angle.visible and _rest.visible


func _show_angle() -> void:
	_angle.measure(_model.onto_tail(), _model.onto(), _model.shadowed())
	var reach := _model.a().length() * _model.b().length()
	var product := func(degrees: float) -> float: return reach * cos(Vec2.deg_to_rad(degrees))
	_plot.show_function(product, reach, _model.signed_angle_degrees())


func _show_formula() -> void:
	_formula.define_symbol("u", DotProductTexts.shadowed_symbol(_model), _shadowed_role())
	_formula.define_symbol("w", DotProductTexts.onto_symbol(_model), _onto_role())
	_formula.define_symbol("e", DotProductTexts.unit_symbol(_model), Palette.Role.UNIT)
	for name_in_line: String in ["u_x", "u_y"]:
		_formula.define_number(name_in_line, _shadowed_role())
	for name_in_line: String in ["w_x", "w_y", "w_length"]:
		_formula.define_number(name_in_line, _onto_role())
	_formula.show_lines(DotProductTexts.lines(_model, _step))
	_put_numbers(_model.a(), _model.b(), _model.shadowed(), _model.onto())
	_formula.set_number("dot", _model.dot())
	_formula.set_number("scalar", _model.scalar_projection())
	_put_pair("e_pair", _model.unit())
	_put_pair("p_pair", _model.vector_projection())
	_put_pair("rest_pair", _model.rest())
	_formula.set_number("check", _model.rest().dot(_model.onto()))


func _put_numbers(a: Vec2, b: Vec2, shadowed: Vec2, onto: Vec2) -> void:
	_formula.set_number("ax", a.x)
	_formula.set_number("ay", a.y)
	_formula.set_number("bx", b.x)
	_formula.set_number("by", b.y)
	_formula.set_number("u_x", shadowed.x)
	_formula.set_number("u_y", shadowed.y)
	_formula.set_number("w_x", onto.x)
	_formula.set_number("w_y", onto.y)
	_formula.set_number("w_length", onto.length())


func _put_pair(name_in_line: String, vector: Vec2) -> void:
	_formula.set_text(name_in_line, NumberText.pair(vector.x, vector.y))


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
	_readout.show_row(key, title, value, error, CallTimer.nanoseconds(way))


func _shadowed_role() -> Palette.Role:
	return Palette.Role.B if _model.is_swapped else Palette.Role.A


func _onto_role() -> Palette.Role:
	return Palette.Role.A if _model.is_swapped else Palette.Role.B
