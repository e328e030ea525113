extends Lesson
## The lesson on the distance of a ball from a line: from any point of the line, along the normal,
## less the radius.

const _STEP_COUNT := 5
## Handles snap to so many pixels.
const _SNAP := 5.0

## Ready-made situations by their titles (source text): x and y of the ball's centre, place of p.
const _PRESETS: Dictionary[String, Array] = {
	"Free": [120.0, -35.0, 0.7],
	"Too close": [75.0, 25.0, 0.8],
	"Behind": [24.0, 93.0, 0.8],
	"Past the end": [263.0, 166.0, 0.6],
	"Far p": [120.0, -35.0, -0.4],
}

var _model := LineDistanceModel.new()
var _step := _STEP_COUNT - 1
var _rng := RandomNumberGenerator.new()
var _exercise: LineDistanceExercise
var _exercise_kind := LineDistanceExercise.Kind.DISTANCE
var _steps: Steps
var _formula: LineDistanceFormula
var _results: LineDistanceResults
var _options: LessonOptions
var _mistakes: Mistakes
var _question: Question

@onready var _drawing: LineDistanceDrawing = %Drawing
@onready var _line: DraggableVector = %Line
@onready var _from: Handle = %From
@onready var _ball: BallHandle = %BallHandle
@onready var _verdict: VerdictCard = %Verdict


func start() -> void:
	board.snap_step = _SNAP
	_bring_services()
	_connect_board()
	_connect_panel()
	_ask()
	resized.connect(_show_all)
	_show_all()


func state() -> Dictionary:
	return _model.to_dictionary()


func show_state(stored: Dictionary) -> void:
	_model.from_dictionary(stored)
	_show_all()


func link_problem(linked: Dictionary) -> String:
	return LineDistanceModel.problem_of(linked)


func _bring_services() -> void:
	_steps = services[&"steps"] as Steps
	_results = LineDistanceResults.new(services[&"readout"] as Readout)
	_options = services[&"options"] as LessonOptions
	_mistakes = services[&"mistakes"] as Mistakes
	_question = services[&"question"] as Question


func _connect_board() -> void:
	board.pointed.connect(_point)
	_line.moved.connect(_move_line)
	_from.moved.connect(_slide)
	_ball.moved.connect(_move_ball)
	for part: Object in [board, _line, _from, _ball]:
		part.connect(&"released", _finish)


func _connect_panel() -> void:
	var panel := services[&"formula"] as Formula
	_formula = LineDistanceFormula.new(panel)
	panel.number_entered.connect(_enter_number)
	_steps.step_changed.connect(_go_to_step)
	for title: String in _PRESETS:
		_options.add_preset(title, tr(title))
	_options.preset_picked.connect(_set_up)
	for mistake in LineDistanceMistakes.infos():
		_mistakes.add_mistake(mistake)
	_mistakes.mistake_picked.connect(_make_mistake)
	_question.exercise_wanted.connect(_ask)
	_question.board_wanted.connect(_show_exercise.unbind(1))


# What the student does.


func _point(at: Vec2, button: MouseButton) -> void:
	if button == MOUSE_BUTTON_LEFT:
		_move_ball(board.snapped_to_step(at))
	else:
		_slide(at)


func _move_ball(to: Vec2) -> void:
	_model.ball.position = to.copy()
	_show_model()


func _slide(to: Vec2) -> void:
	_model.slide_to(to)
	_show_model()


func _move_line(tail: Vec2, head: Vec2) -> void:
	noticed.emit(_model.move_line(tail, head))
	_show_model()


func _enter_number(name_in_line: String, value: float) -> void:
	noticed.emit(_problem_of(name_in_line, value))
	_finish()


# Takes the number over. "" if it could be taken, else one sentence.
func _problem_of(name_in_line: String, value: float) -> String:
	var start_point := _model.line.start.copy()
	var end_point := _model.line.end.copy()
	match name_in_line:
		"sx":
			start_point.x = value
		"sy":
			start_point.y = value
		"ex":
			end_point.x = value
		"ey":
			end_point.y = value
		"cx":
			_model.ball.position.x = value
		"cy":
			_model.ball.position.y = value
		"share":
			_model.from_share = value
		"r":
			return _model.resize_ball(value)
	return _model.move_line(start_point, end_point)


func _set_up(preset: String) -> void:
	var numbers: PackedFloat64Array = _PRESETS[preset]
	var fresh := LineDistanceModel.new()
	fresh.ball.position.set_xy(numbers[0], numbers[1])
	fresh.from_share = numbers[2]
	fresh.mistake = _model.mistake
	_model = fresh
	_finish()


func _make_mistake(number: int) -> void:
	_model.mistake = number
	_finish()


func _show_exercise() -> void:
	_model.line = _exercise.line.copy()
	_model.ball = _exercise.ball.copy()
	_model.from_share = 0.0
	_finish()


func _ask() -> void:
	_exercise = LineDistanceExercise.fresh(_exercise_kind, _rng)
	_exercise_kind = (
		(_exercise_kind + 1) % LineDistanceExercise.Kind.size() as LineDistanceExercise.Kind
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
	var corner := _model.from().plus(_model.ball.position.minus(_model.foot()))
	var centre := _model.ball.position
	var half_radius := Vec2.new(_model.ball.radius / 2.0, _model.ball.radius / 2.0)
	board.fit(
		[
			_model.line.start,
			_model.line.end,
			_model.from(),
			corner,
			centre.minus(half_radius),
			centre.plus(half_radius)
		]
	)
	_results.measure(_model)
	_mistakes.show_mistake(_model.mistake)
	_show_model()


func _show_model() -> void:
	_steps.show_sentences(LineDistanceTexts.sentences(_model), _step)
	_drawing.show_model(_model, _step)
	_formula.show_model(_model, _step)
	var is_good := not _model.is_overlapping()
	_verdict.show_verdict(
		"+" if not _model.is_behind() else NumberText.MINUS,
		Palette.Role.RIGHT if is_good else Palette.Role.WRONG,
		LineDistanceTexts.verdict(_model)
	)
	var balls: PackedVector2Array = [board.to_screen(_model.ball.position)]
	var wrong := _model.position_with_mistake()
	if _model.mistake != 0 and wrong.is_finite():
		balls.append(board.to_screen(wrong))
	_verdict.keep_off(balls, _model.ball.radius * board.pixels_per_unit)
	_results.show_model(_model)
