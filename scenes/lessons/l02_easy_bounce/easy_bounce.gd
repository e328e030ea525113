extends Lesson
## The lesson on the easy bounce: a ball, a level line, three short steps; then the line is tilted.
##
## Where ball, velocity and line lie at the start is in the scene: the middle of Line is the point
## about which it is tilted.

## How many frames a second are shown while it plays: slow enough to see each of them.
const _FRAMES_PER_SECOND := 8.0
## The board shows the plane from the origin to this corner: for the whole bounce, for one frame.
const _CORNER_OF_BOUNCE := Vector2(200.0, 230.0)
const _CORNER_OF_FRAME := Vector2(EasyBounceModel.HALF_LENGTH, 120.0)

## At the opening the ball goes to and fro so often, back by this share of v: it always overlaps the
## line, so that a press at any time leaves a hit.
const _SWINGS := 5.0
const _SWING := 0.4

## Tilts to pick, in degrees, by their titles (source text).
const _PRESETS: Dictionary[String, float] = {
	"0°": 0.0, "10°": 10.0, "30°": 30.0, "−30°": -30.0, "−45°": -45.0
}

var _model := EasyBounceModel.new()
var _formula: EasyBounceFormula
var _readout: EasyBounceReadout

@onready var _transport: Transport = services.get(&"transport")
@onready var _drawing: EasyBounceDrawing = %Drawing
@onready var _line: DraggableVector = %Line
@onready var _ball: BallHandle = %BallHandle
@onready var _head: Handle = %VelocityHandle
@onready var _verdict: EasyBounceVerdict = %Verdict


func start() -> void:
	var velocity := _head.at().minus(_ball.at())
	_model.ball = Ball.new(_ball.at(), _ball.radius, velocity)
	_model.pivot = _line.tail_point().lerped(_line.head_point(), 0.5)
	_model.tilt_degrees = _model.tilt_toward(_line.tail_point(), true)
	on_drag(_line.moved, _line.released, _drag_line)
	on_drag(_ball.moved, _ball.released, _drag_ball)
	on_drag(_head.moved, _head.released, _drag_velocity)
	_fill_panel()
	begin(_model, _show, _seen_points)
	_ask()
	open_with(_swing.bind(_model.ball.copy()))


func _ask() -> void:
	var place := tr(
		"Where must the centre go, so that the ball just touches? Drag the “?” there, then step forward."
	)
	ask_before(EasyBounceTexts.Step.PUT_BACK, place, _place_to_guess, _first_guess)
	var component := tr("The ball bounces off. Which component of v changes its sign?")
	var components: PackedStringArray = [tr("x of v"), tr("y of v"), tr("both")]
	ask_choice_before(EasyBounceTexts.Step.FLIP, component, components, _model.flipped_component)


func _fill_panel() -> void:
	_formula = EasyBounceFormula.new(services[&"formula"] as Formula)
	on_enter(_enter)
	_readout = EasyBounceReadout.new(services[&"readout"] as Readout)
	_transport.advanced.connect(_advance)
	var options := services[&"options"] as LessonOptions
	options.add_switch("is_wall", tr("Wall instead of floor"))
	options.add_presets(_PRESETS.keys())
	on_edit(options.switched, _swap_axes.unbind(2))
	on_edit(options.preset_picked, _tilt_to)
	var question := services[&"question"] as Question
	question.offer(BounceExercise.fresh, BounceExercise.Kind.size())
	on_edit(question.board_wanted, _show_exercise)


# What moves by itself: back along v and on again, to hundredths, so that the numbers stay short.
func _swing(seconds: float, first: Ball) -> void:
	var share := OpeningMotion.to_and_fro(seconds, _SWINGS)
	var place := first.position.minus(first.velocity.scaled(_SWING * share))
	_model.ball.position.set_xy(snappedf(place.x, 0.01), snappedf(place.y, 0.01))


# What the student does.


func _drag_ball(point: Vec2) -> void:
	_model.take_hold()
	_model.ball.position = point.copy()


func _drag_velocity(head: Vec2) -> void:
	_model.take_hold()
	_model.ball.velocity = head.minus(_model.ball.position)


func _drag_line(start_point: Vec2, end_point: Vec2) -> void:
	var line := _model.line()
	if end_point.equals_approx(line.end, 0.0):
		_model.tilt_degrees = _model.tilt_toward(start_point, true)
	elif start_point.equals_approx(line.start, 0.0):
		_model.tilt_degrees = _model.tilt_toward(end_point, false)
	else:
		_model.pivot = board.snapped_to_step(_model.pivot.plus(start_point.minus(line.start)))


# A single step is one frame; while it plays, frames are shown slower than they would run. Between
# two frames nothing changes.
func _advance(seconds: float) -> void:
	var frames_per_second := _FRAMES_PER_SECOND
	if not _transport.is_playing:
		frames_per_second = 1.0 / Transport.STEP_SECONDS
	var shown := _model.frame()
	_model.advance(seconds * frames_per_second)
	if _model.frame() != shown:
		_show()


func _enter(name_in_line: String, value: float) -> String:
	if EasyBounceModel.is_of_moving_ball(name_in_line):
		pause()
	return _model.enter(name_in_line, value)


func _swap_axes() -> void:
	pause()
	_model.swap_axes()


func _tilt_to(preset: String) -> void:
	pause()
	_model.rewind()
	_model.tilt_degrees = _PRESETS[preset]


func _show_exercise(exercise: BounceExercise) -> void:
	pause()
	exercise.set_up(_model)


# What the student sees.


# Null where nothing has to be put back.
func _place_to_guess() -> Vec2:
	var moved := _model.moved_ball(_model.frame())
	return _model.right_result(moved).position if _model.right_detects(moved) else null


func _first_guess() -> Vec2:
	return _model.moved_ball(_model.frame()).position


func _seen_points() -> Array[Vec2]:
	var ball := _model.ball
	var line := _model.line()
	var is_bounce := step == EasyBounceTexts.Step.BOUNCE
	var corner := Vec2.from_vector2(_CORNER_OF_BOUNCE if is_bounce else _CORNER_OF_FRAME)
	return [corner, ball.position, ball.position.plus(ball.velocity), line.start, line.end]


func _show() -> void:
	var moved := _model.moved_ball(_model.frame())
	_drawing.show_model(_model, step)
	_ball.place_ball(moved.position, moved.radius)
	_head.place(moved.position.plus(moved.velocity))
	_head.visible = EasyBounceTexts.needs_velocity(step)
	_formula.show_model(_model, moved, step)
	_readout.show_model(_model, moved, step)
	tell_code(EasyBounceCode.lines(_model, moved, step), EasyBounceCode.inputs(_model, moved))
	_verdict.show_model(_model, moved, step)
	tell_steps(EasyBounceTexts.sentences(_model, moved))
