extends Lesson
## The lesson on the dot product: two vectors, the shadow of one on the other, and the numbers
## beside them. Where both vectors lie at the start is in the scene.

## What a click does, in a word for the help line: source text.
const ACTIONS: Dictionary[StringName, String] = {&"left_click": "a", &"right_click": "b"}
## The sweep turns the shadowed vector this fast, in degrees a second.
const _SWEEP_SPEED := 30.0
## The opening swings a so far to both sides, in degrees, and so often in 20 seconds.
const _SWING := 30.0
const _SWINGS := 2.0

var _model := DotProductModel.new()
var _formula: DotProductFormula

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
	add_child(CardPlace.new(_plot, board, services[&"steps"]))
	_formula = DotProductFormula.new(services[&"formula"] as Formula)
	show_in_panel(DotProductReadout.new(services[&"readout"] as Readout))
	on_move((services[&"transport"] as Transport).advanced, _sweep)
	add_switch("normalizes", tr("Normalize"))
	add_switch("is_swapped", tr("b on a"))
	offer_presets(DotProductModel.PRESETS)
	offer_questions(ProjectionExercise, ProjectionExercise.of_the_lecture, 1)
	begin(_model, _show, _model.ends)
	open_with_swing(_swing.bind(_model.a()), _SWINGS)


# What moves by itself.


# To hundredths, so that the numbers beside it stay short.
func _swing(share: float, first: Vec2) -> void:
	var swung := first.copy()
	swung.rotate_degrees(_SWING * share)
	var head := _model.a_tail.plus(swung)
	_model.a_head.set_xy(snappedf(head.x, 0.01), snappedf(head.y, 0.01))


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


# What the student sees.


func _show() -> void:
	ask_before(
		DotProductTexts.Step.SCALAR,
		DotProductTexts.question(_model),
		_model.shadow_end,
		func() -> Vec2: return _model.a_head.lerped(_model.b_head, 0.5)
	)
	ask_choice_before(
		DotProductTexts.Step.BOTH,
		DotProductTexts.question_on_both(_model),
		DotProductTexts.choices_on_both(),
		_right_choice
	)
	tell_steps(DotProductTexts.sentences(_model))
	_drawing.show_model(_model, step)
	_formula.show_model(_model, step, (services[&"transport"] as Transport).is_playing)
	_show_verdict()
	_show_plot()
	tell_code(DotProductCode.lines(_model, step), DotProductCode.inputs(_model))


# Whether the other shadow is longer, shorter or as long; -1 where there is nothing to compare.
func _right_choice() -> int:
	if not _model.normalizes or not _model.shadow_end():
		return -1
	if _model.is_dot_zero() or _model.has_equal_lengths():
		return 2
	return 0 if _model.onto().length() > _model.shadowed().length() else 1


# With the course's ball: green ahead, red behind.
func _show_verdict() -> void:
	_verdict.visible = step >= DotProductTexts.Step.SCALAR
	var roles: Array[Palette.Role] = [Palette.Role.WRONG, Palette.Role.QUIET, Palette.Role.RIGHT]
	var role := roles[_model.side() + 1]
	var sign_text: String = [NumberText.MINUS, "0", "+"][_model.side() + 1]
	if _model.is_wrong():
		role = Palette.Role.WRONG
		sign_text = "✗"
	_verdict.show_verdict(sign_text, role, DotProductTexts.verdict(_model))


func _show_plot() -> void:
	var has_angle := _model.a().length() > 0.0 and _model.b().length() > 0.0
	_plot.visible = has_angle and step >= DotProductTexts.Step.ANGLE
	var reach := _model.a().length() * _model.b().length()
	var product := func(degrees: float) -> float: return reach * cos(Vec2.deg_to_rad(degrees))
	_plot.show_function(product, reach, _model.signed_angle_degrees())
