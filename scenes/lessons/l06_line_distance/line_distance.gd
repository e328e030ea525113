extends Lesson
## The lesson on the distance of a ball from a line: from any point of the line, along the normal,
## less the radius. Where line, point and ball lie at the start is in the scene.

const _LINE: PackedFloat64Array = [200.0, 150.0, -200.0, -150.0]
## Presets by their titles (source text): what each changes in the model's state.
const _PRESETS: Dictionary[String, Dictionary] = {
	"Free": {line = _LINE, ball = [120.0, -35.0, 30.0], from_share = 0.7},
	"Too close": {line = _LINE, ball = [75.0, 25.0, 30.0], from_share = 0.8},
	"Behind": {line = _LINE, ball = [24.0, 93.0, 30.0], from_share = 0.8},
	"Past the end": {line = _LINE, ball = [263.0, 166.0, 30.0], from_share = 0.6},
	"Far p": {line = _LINE, ball = [120.0, -35.0, 30.0], from_share = -0.4},
}

var _model := LineDistanceModel.new()
var _formula: LineDistanceFormula
var _readout: LineDistanceReadout

@onready var _steps: Steps = services.get(&"steps")
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
	_formula = LineDistanceFormula.new(services[&"formula"] as Formula)
	_readout = LineDistanceReadout.new(services[&"readout"] as Readout)
	(services[&"options"] as LessonOptions).offer_presets(_PRESETS)
	(services[&"mistakes"] as Mistakes).add_all(LineDistanceMistakes.infos())
	var kinds := LineDistanceExercise.Kind.size()
	(services[&"question"] as Question).offer(LineDistanceExercise.fresh, kinds)
	on_edit((services[&"formula"] as Formula).number_entered, _model.enter)
	on_pick(_model.take)
	begin(_model, _show, _model.points_to_show)


# What the student does.


func _move_ball(to: Vec2) -> void:
	_model.ball.position = to.copy()


func _put_ball(at: Vec2) -> void:
	_move_ball(board.snapped_to_step(at))


# What the student sees.


func show_all() -> void:
	# Not during a drag: measuring would slow it down.
	_readout.measure(_model)
	super()


func _show() -> void:
	_steps.tell(LineDistanceTexts.sentences(_model))
	_drawing.show_model(_model, _steps.step)
	_formula.show_model(_model, _steps.step)
	_readout.show_model(_model)
