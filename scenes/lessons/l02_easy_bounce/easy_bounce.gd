extends Lesson
## The lesson on the easy bounce: a ball, a level line, three short steps; then the line is tilted.

const _STEP_COUNT := 5
## While it plays, so many frames are shown a second: slow enough to see each of them.
const _FRAMES_PER_SECOND := 8.0
## Pixels between places to which handles snap; a key at the line's end tilts it by a degree.
const _SNAP_STEP := 4.0

## Tilts to pick, in degrees, by their titles (source text).
const _PRESETS: Dictionary[String, float] = {
	"Level": 0.0, "10°": 10.0, "30°": 30.0, "−30°": -30.0, "−45°": -45.0
}

var _model := EasyBounceModel.new()
var _step := _STEP_COUNT - 1
var _rng := RandomNumberGenerator.new()
var _exercise_kind := BounceExercise.Kind.PUT_BACK

var _steps: Steps
var _formula: EasyBounceFormula
var _readout: Readout
var _options: LessonOptions
var _transport: Transport
var _question: Question
var _exercise: BounceExercise

@onready var _drawing: EasyBounceDrawing = %Drawing
@onready var _line: DraggableVector = %Line
@onready var _ball: BallHandle = %BallHandle
@onready var _head: Handle = %VelocityHandle
@onready var _verdict: EasyBounceVerdict = %Verdict


func start() -> void:
	_bring_services()
	_connect_board()
	_connect_formula()
	_fill_options()
	_ask()
	board.snap_step = _SNAP_STEP
	resized.connect(_show_all)
	_show_all()


func state() -> Dictionary:
	return EasyBounceSetup.to_dictionary(_model)


func show_state(stored: Dictionary) -> void:
	_transport.is_playing = false
	EasyBounceSetup.from_dictionary(_model, stored)
	_show_all()


func link_problem(linked: Dictionary) -> String:
	return EasyBounceSetup.problem_of(linked)


func _bring_services() -> void:
	_steps = services[&"steps"] as Steps
	_readout = services[&"readout"] as Readout
	_options = services[&"options"] as LessonOptions
	_transport = services[&"transport"] as Transport
	_question = services[&"question"] as Question


func _connect_board() -> void:
	_line.moved.connect(_drag_line)
	_ball.moved.connect(_drag_ball)
	_head.moved.connect(_drag_velocity)
	for part: Node in [_line, _ball, _head]:
		part.connect(&"released", _finish)
	_steps.step_changed.connect(_go_to_step)
	_transport.advanced.connect(_advance)


func _connect_formula() -> void:
	var panel := services[&"formula"] as Formula
	_formula = EasyBounceFormula.new(panel)
	panel.number_entered.connect(_enter_number)


func _fill_options() -> void:
	_options.add_switch("is_wall", tr("Wall instead of floor"))
	_options.switched.connect(_switch)
	for title: String in _PRESETS:
		_options.add_preset(title, tr(title))
	_options.preset_picked.connect(_tilt_to)
	_question.exercise_wanted.connect(_ask)
	_question.board_wanted.connect(_show_exercise.unbind(1))


# What the student does.


func _drag_ball(point: Vec2) -> void:
	_take_hold()
	_model.ball.position = point.copy()
	_show_model()


func _drag_velocity(head: Vec2) -> void:
	_take_hold()
	_model.ball.velocity = head.minus(_model.ball.position)
	_show_model()


func _drag_line(start_point: Vec2, end_point: Vec2) -> void:
	_transport.is_playing = false
	var line := _model.line()
	if end_point.equals_approx(line.end, 0.0):
		_model.tilt_degrees = EasyBounceSetup.tilt_toward(_model, start_point, true)
	elif start_point.equals_approx(line.start, 0.0):
		_model.tilt_degrees = EasyBounceSetup.tilt_toward(_model, end_point, false)
	else:
		_model.pivot = board.snapped_to_step(_model.pivot.plus(start_point.minus(line.start)))
	_show_model()


func _take_hold() -> void:
	_transport.is_playing = false
	_model.take_hold()


func _advance(seconds: float) -> void:
	# A single step is one frame; while playing, frames are shown slower than they would run.
	var frames_per_second := _FRAMES_PER_SECOND
	if not _transport.is_playing:
		frames_per_second = 1.0 / Transport.STEP_SECONDS
	var shown := _model.frame()
	_model.advance(seconds * frames_per_second)
	if _model.frame() != shown:
		_show_model()


func _enter_number(name_in_line: String, value: float) -> void:
	var problem := EasyBounceSetup.problem(name_in_line, value)
	noticed.emit(problem)
	if not problem:
		_put_number(name_in_line, value)
	_finish()


func _put_number(name_in_line: String, value: float) -> void:
	if name_in_line in ["px", "py", "vx", "vy"]:
		_take_hold()
	match name_in_line:
		"px":
			_model.ball.position.x = value
		"py":
			_model.ball.position.y = value
		"vx":
			_model.ball.velocity.x = value
		"vy":
			_model.ball.velocity.y = value
		"r":
			_model.ball.radius = value
		"tilt":
			_model.tilt_degrees = value


func _switch(_key: String, _on: bool) -> void:
	_transport.is_playing = false
	EasyBounceSetup.swap_axes(_model)
	_finish()


func _tilt_to(preset: String) -> void:
	_transport.is_playing = false
	_model.rewind()
	_model.tilt_degrees = _PRESETS[preset]
	_finish()


func _show_exercise() -> void:
	_transport.is_playing = false
	_exercise.set_up(_model)
	_finish()


func _ask() -> void:
	_exercise = BounceExercise.fresh(_exercise_kind, _rng)
	_exercise_kind = (_exercise_kind + 1) % BounceExercise.Kind.size() as BounceExercise.Kind
	_question.show_exercise(_exercise)


func _go_to_step(step: int) -> void:
	_step = step
	_show_all()


func _finish() -> void:
	_show_all()
	edited.emit()


# What the student sees.


func _show_all() -> void:
	var ball := _model.ball
	var line := _model.line()
	board.fit(
		[_view_corner(), ball.position, ball.position.plus(ball.velocity), line.start, line.end]
	)
	_options.show_switch("is_wall", _model.is_wall)
	_show_model()


# The whole bounce needs more room than what happens in one frame.
func _view_corner() -> Vec2:
	if _step == EasyBounceTexts.Step.BOUNCE:
		return Vec2.new(200.0, 220.0)
	return Vec2.new(EasyBounceModel.HALF_LENGTH, 120.0)


func _show_model() -> void:
	var moved := _model.moved_ball(_model.frame())
	_steps.show_sentences(EasyBounceTexts.sentences(_model), _step)
	_drawing.show_model(_model, _step)
	_ball.place_ball(moved.position, moved.radius)
	_head.place(moved.position.plus(moved.velocity))
	_head.visible = EasyBounceTexts.needs_velocity(_step)
	_formula.show_model(_model, moved, _step)
	_verdict.show_model(_model, moved, _step)
	EasyBounceReadout.show_model(_readout, _model, moved)
