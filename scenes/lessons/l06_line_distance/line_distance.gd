extends Lesson
## The lesson on the distance of a ball from a line: from any point of the line, along the normal,
## less the radius. Where line, point and ball lie at the start is in the scene.

## The opening slides p this share of the line to both sides, and so often in 20 seconds.
const _SLIDE := 0.3
const _SLIDES := 3.0
## A frame of the flight lasts so long, to be seen.
const _FRAME_SECONDS := 0.4

var _model := LineDistanceModel.new()
# Seconds that the flight has run since its first frame.
var _flown := 0.0

@onready var _transport: Transport = services.get(&"transport")
@onready var _options: LessonOptions = services.get(&"options")
@onready var _drawing: LineDistanceDrawing = %Drawing
@onready var _line: DraggableVector = %Line
@onready var _from: Handle = %From
@onready var _ball: BallView = %Ball
@onready var _ball_handle: BallHandle = %BallHandle


func start() -> void:
	_model.line = LineSegment.new(_line.tail_point(), _line.head_point())
	_model.slide_to(_from.at())
	_model.ball = Ball.new(_ball.at(), _ball.radius)
	on_drag(_line.moved, _line.released, _model.move_line)
	on_drag(_from.moved, _from.released, _model.slide_to)
	on_drag(_ball_handle.moved, _ball_handle.released, _move_ball)
	on_point(MOUSE_BUTTON_LEFT, _put_ball)
	on_point(MOUSE_BUTTON_RIGHT, _model.slide_to)
	show_in_panel(LineDistanceFormula.new(services[&"formula"] as Formula))
	show_in_panel(LineDistanceReadout.new(services[&"readout"] as Readout))
	offer_presets(LineDistanceModel.PRESETS)
	_options.add_choice("rule", tr("Where the ball is red"), LineDistanceTexts.rules())
	on_edit(_options.chosen, func(_key: String, place: int) -> void: _model.set_rule(place))
	on_move(_transport.advanced, _run_flight)
	offer_mistakes(LineDistanceMistakes.infos(), LineDistanceTexts.step_of_mistake)
	offer_questions(LineDistanceExercise)
	on_pick(_model.take, _show_speed)
	begin(_model, _show, _model.points_to_show)
	open_with_swing(_slide_p.bind(_model.from_share), _SLIDES)


# What moves by itself.


# To hundredths, so that the numbers beside it stay short.
func _slide_p(share: float, first: float) -> void:
	_model.from_share = first + snappedf(_SLIDE * share, 0.01)


# The flight is not part of the state: undo changes the ball, and the flight is shown to its end.
func _run_flight(seconds: float) -> void:
	if not _transport.is_playing:
		_model.frame += int(signf(seconds))
		_flown = _model.frame * _FRAME_SECONDS
	else:
		var is_over := _model.frame == _model.detection().last_frame()
		_flown = seconds if is_over else _flown + seconds
		_model.frame = int(_flown / _FRAME_SECONDS)
		_transport.is_playing = _model.frame < _model.detection().last_frame()


# What the student does.


func _move_ball(to: Vec2) -> void:
	_model.ball.position = to.copy()


func _put_ball(at: Vec2) -> void:
	_move_ball(board.snapped_to_step(at))


# A ball that is slow or fast is shown in its flight.
func _show_speed(changes: Dictionary) -> void:
	if changes.has("speed"):
		(services[&"steps"] as Steps).go_to(LineDistanceTexts.Step.DETECTION)


# What the student sees.


func _show() -> void:
	ask_before(
		LineDistanceTexts.Step.DISTANCE,
		LineDistanceTexts.question_on_foot(),
		_model.foot,
		_model.from
	)
	ask_choice_before(
		LineDistanceTexts.Step.GAP,
		LineDistanceTexts.question_on_gap(),
		LineDistanceTexts.choices(),
		LineDistanceTexts.right_choice.bind(_model)
	)
	tell_steps(LineDistanceTexts.sentences(_model))
	tell_code(LineDistanceCode.lines(_model, step), LineDistanceCode.inputs(_model, step))
	_options.show_choice("rule", _model.rule)
	_options.reveal_choice("rule", step == LineDistanceTexts.Step.DETECTION)
	_transport.visible = step == LineDistanceTexts.Step.DETECTION
	_drawing.show_model(_model, step)
