extends Lesson
## The lesson on position reset and point of impact: where within a frame a ball touches a line.
## Where the line and both positions of the ball are at the start is in the scene.

## In the opening the ghost flies so often to new and back, in 20 seconds.
const _FLIGHTS := 5.0

var _model := PointOfImpactModel.new()

@onready var _drawing: PointOfImpactDrawing = %Drawing
@onready var _line: DraggableVector = %Line
@onready var _old: BallView = %Old
@onready var _new: BallView = %New
@onready var _old_handle: BallHandle = %OldHandle
@onready var _new_handle: BallHandle = %NewHandle
@onready var _ghost_handle: Handle = %GhostHandle


func start() -> void:
	_model.line = LineSegment.new(_line.tail_point(), _line.head_point())
	_model.radius = _old.radius
	_move_old(_old.at())
	_move_new(_new.at())
	_model.slide_to(_ghost_handle.at())
	on_drag(_line.moved, _line.released, _model.move_line)
	on_drag(_old_handle.moved, _old_handle.released, _move_old)
	on_drag(_new_handle.moved, _new_handle.released, _move_new)
	on_drag(_ghost_handle.moved, _ghost_handle.released, _model.slide_to)
	on_point(MOUSE_BUTTON_LEFT, func(at: Vec2) -> void: _move_old(board.snapped_to_step(at)))
	on_point(MOUSE_BUTTON_RIGHT, func(at: Vec2) -> void: _move_new(board.snapped_to_step(at)))
	show_in_panel(PointOfImpactFormula.new(services[&"formula"] as Formula))
	show_in_panel(PointOfImpactReadout.new(services[&"readout"] as Readout))
	offer_presets(PointOfImpactModel.PRESETS)
	offer_mistakes(PointOfImpactMistakes.infos(), PointOfImpactTexts.step_of_mistake)
	offer_questions(PointOfImpactExercise)
	begin(_model, _show, _model.points_to_show)
	open_with(_fly.bind(_model.moment))


# What moves by itself: the ghost flies along v and back.
func _fly(seconds: float, first: float) -> void:
	var turn := acos(1.0 - 2.0 * first) + TAU * _FLIGHTS * seconds / OpeningMotion.LONGEST
	_model.moment = snappedf(0.5 - 0.5 * cos(turn), 0.01)


# What the student does.


func _move_old(to: Vec2) -> void:
	_model.old_position = to.copy()


func _move_new(to: Vec2) -> void:
	_model.new_position = to.copy()


# What the student sees.


func _show() -> void:
	ask_choice_before(
		PointOfImpactTexts.Step.FRACTION,
		PointOfImpactTexts.question_on_case(),
		PointOfImpactTexts.choices(),
		PointOfImpactTexts.right_choice.bind(_model)
	)
	ask_before(
		PointOfImpactTexts.Step.IMPACT,
		PointOfImpactTexts.question_on_impact(),
		_model.touch_in_frame,
		func() -> Vec2: return _model.old_position.lerped(_model.new_position, 0.1)
	)
	tell_steps(PointOfImpactTexts.sentences(_model))
	tell_code(PointOfImpactCode.lines(_model, step), PointOfImpactCode.inputs(_model, step))
	_drawing.show_model(_model, step)
