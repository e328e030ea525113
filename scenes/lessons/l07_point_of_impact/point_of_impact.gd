extends Lesson
## The lesson on position reset and point of impact: where within a frame a ball touches a line.

const _STEP_COUNT := 5
## A wrong fraction of the frame larger than this does not make the board smaller.
const _LARGEST_SHOWN_FRACTION := 20.0

## Ready-made situations by their titles (source text): x and y of the old and of the new position,
## and the length of the line. The speeds are those of the course's scenes, in pixels per frame.
const _PRESETS: Dictionary[String, Array] = {
	"Course": [6.0, -58.0, 6.0, 42.0, 150.0],
	"10 px": [6.0, -13.0, 6.0, -3.0, 150.0],
	"38 px": [6.0, -27.0, 6.0, 11.0, 150.0],
	"72 px": [6.0, -44.0, 6.0, 28.0, 150.0],
	"500 px": [6.0, -258.0, 6.0, 242.0, 500.0],
	"Not yet": [6.0, -58.0, 6.0, -20.5, 150.0],
	"Inside": [3.0, -4.0, 3.0, 21.0, 150.0],
	"Away": [12.0, -16.0, 12.0, -66.0, 150.0],
	"Leaving": [3.0, -4.0, 3.0, -29.0, 150.0],
	"Along": [-34.0, -88.0, 46.0, -28.0, 150.0],
}

var _model := PointOfImpactModel.new()
var _step := _STEP_COUNT - 1
var _rng := RandomNumberGenerator.new()
var _exercise: PointOfImpactExercise
var _exercise_kind := PointOfImpactExercise.Kind.FRACTION
var _steps: Steps
var _formula: PointOfImpactFormula
var _results: PointOfImpactResults
var _options: LessonOptions
var _mistakes: Mistakes
var _question: Question

@onready var _drawing: PointOfImpactDrawing = %Drawing
@onready var _line: DraggableVector = %Line
@onready var _old: BallHandle = %OldHandle
@onready var _new: BallHandle = %NewHandle
@onready var _verdict: VerdictCard = %Verdict


func start() -> void:
	board.snap_step = 1.0
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
	return PointOfImpactModel.problem_of(linked)


func _bring_services() -> void:
	_steps = services[&"steps"] as Steps
	_results = PointOfImpactResults.new(services[&"readout"] as Readout)
	_options = services[&"options"] as LessonOptions
	_mistakes = services[&"mistakes"] as Mistakes
	_question = services[&"question"] as Question


func _connect_board() -> void:
	board.pointed.connect(_point)
	_line.moved.connect(_move_line)
	_old.moved.connect(_move_old)
	_new.moved.connect(_move_new)
	for part: Object in [board, _line, _old, _new]:
		part.connect(&"released", _finish)


func _connect_panel() -> void:
	var panel := services[&"formula"] as Formula
	_formula = PointOfImpactFormula.new(panel)
	panel.number_entered.connect(_enter_number)
	_steps.step_changed.connect(_go_to_step)
	for title: String in _PRESETS:
		_options.add_preset(title, tr(title))
	_options.preset_picked.connect(_set_up)
	for mistake in PointOfImpactMistakes.infos():
		_mistakes.add_mistake(mistake)
	_mistakes.mistake_picked.connect(_make_mistake)
	_question.exercise_wanted.connect(_ask)
	_question.board_wanted.connect(_show_exercise.unbind(1))


# What the student does.


func _point(at: Vec2, button: MouseButton) -> void:
	if button == MOUSE_BUTTON_LEFT:
		_move_old(board.snapped_to_step(at))
	else:
		_move_new(board.snapped_to_step(at))


func _move_old(to: Vec2) -> void:
	_model.old_position = to.copy()
	_show_model()


func _move_new(to: Vec2) -> void:
	_model.new_position = to.copy()
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
		"old_x":
			_model.old_position.x = value
		"old_y":
			_model.old_position.y = value
		"new_x":
			_model.new_position.x = value
		"new_y":
			_model.new_position.y = value
		"sx":
			start_point.x = value
		"sy":
			start_point.y = value
		"ex":
			end_point.x = value
		"ey":
			end_point.y = value
		"r":
			return _model.set_radius(value)
		"speed":
			return _model.set_speed(value)
	return _model.move_line(start_point, end_point)


func _set_up(preset: String) -> void:
	var numbers: PackedFloat64Array = _PRESETS[preset]
	var fresh := PointOfImpactModel.new()
	fresh.old_position.set_xy(numbers[0], numbers[1])
	fresh.new_position.set_xy(numbers[2], numbers[3])
	var half := fresh.line.along().normalized().scaled(numbers[4] / 2.0)
	fresh.line = LineSegment.new(half.negated(), half)
	fresh.mistake = _model.mistake
	_model = fresh
	_finish()


# A mistake that this frame would not show brings one along that does.
func _make_mistake(number: int) -> void:
	_model.mistake = number
	if number != 0 and not _model.shows_mistake():
		_set_up("Not yet")
	else:
		_finish()


func _show_exercise() -> void:
	var fresh := PointOfImpactModel.new()
	fresh.old_position = _exercise.old_position.copy()
	fresh.new_position = _exercise.new_position.copy()
	fresh.radius = _exercise.radius
	fresh.line = _exercise.line.copy()
	fresh.mistake = _model.mistake
	_model = fresh
	_finish()


func _ask() -> void:
	_exercise = PointOfImpactExercise.fresh(_exercise_kind, _rng)
	_exercise_kind = (
		(_exercise_kind + 1) % PointOfImpactExercise.Kind.size() as PointOfImpactExercise.Kind
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
	var half_radius := Vec2.new(_model.radius / 2.0, _model.radius / 2.0)
	var points: Array[Vec2] = [_model.line.start, _model.line.end]
	for centre: Vec2 in [_model.old_position, _model.new_position]:
		points.append(centre.plus(half_radius))
		points.append(centre.minus(half_radius))
	if _model.mistake != 0 and absf(_model.fraction_with_mistake()) < _LARGEST_SHOWN_FRACTION:
		points.append(_model.position_with_mistake())
	board.fit(points)
	_results.measure(_model)
	_mistakes.show_mistake(_model.mistake)
	_show_model()


func _show_model() -> void:
	_steps.show_sentences(PointOfImpactTexts.sentences(_model), _step)
	_drawing.show_model(_model, _step)
	_formula.show_model(_model, _step)
	var hits := _model.impact().hit
	_verdict.show_verdict(
		"!" if hits else "×",
		Palette.Role.PROJECTION if hits else Palette.Role.QUIET,
		PointOfImpactTexts.verdict(_model)
	)
	var places: PackedVector2Array = [
		board.to_screen(_model.old_position), board.to_screen(_model.new_position)
	]
	_verdict.keep_off(places, _model.radius * board.pixels_per_unit)
	_results.show_model(_model)
