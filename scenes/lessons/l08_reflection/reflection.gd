extends Lesson
## The lesson on the law of reflection and the bounciness: subtract the part along the normal.

## Ready-made situations by their titles (source text): x and y of v, x and y of the line, C.
const _PRESETS: Dictionary[String, Array] = {
	"Lecture": [3.0, 4.0, -7.0, 0.0, 1.0],
	"C = 0.5": [3.0, 4.0, -7.0, 0.0, 0.5],
	"Angled": [0.0, 5.0, -8.0, -6.0, 1.0],
	"Head on": [0.0, 5.0, -7.0, 0.0, 0.8],
	"Along": [4.0, 0.0, -7.0, 0.0, 1.0],
}

var _model := ReflectionModel.new()
var _step := ReflectionModel.Step.BOUNCE
var _rng := RandomNumberGenerator.new()
var _exercise: ReflectionExercise
var _exercise_kind := ReflectionExercise.Kind.MIRROR

var _steps: Steps
var _formula: ReflectionFormula
var _readout: Readout
var _options: LessonOptions
var _transport: Transport
var _mistakes: Mistakes
var _question: Question

@onready var _drawing: ReflectionDrawing = %Drawing
@onready var _verdict: VerdictCard = %Verdict
@onready var _table: GodotTable = %Table


func start() -> void:
	_bring_services()
	_connect_board()
	_connect_formula()
	_fill_options()
	_ask()
	resized.connect(_show_all)
	_show_all()


func state() -> Dictionary:
	return _model.to_dictionary()


func show_state(stored: Dictionary) -> void:
	_model.from_dictionary(stored)
	_show_all()
	noticed.emit(_model.refusal())


func link_problem(linked: Dictionary) -> String:
	return ReflectionModel.problem_of(linked)


func _bring_services() -> void:
	_steps = services[&"steps"] as Steps
	_readout = services[&"readout"] as Readout
	_options = services[&"options"] as LessonOptions
	_transport = services[&"transport"] as Transport
	_mistakes = services[&"mistakes"] as Mistakes
	_question = services[&"question"] as Question
	_steps.step_changed.connect(_go_to_step)
	_transport.advanced.connect(_run)
	_question.exercise_wanted.connect(_ask)
	_question.board_wanted.connect(_show_exercise.unbind(1))


func _connect_board() -> void:
	_connect_handle(
		%Start as Handle, func(at: Vec2) -> void: _model.velocity = Vec2.new().minus(at)
	)
	_connect_handle(%VelocityHead as Handle, func(at: Vec2) -> void: _model.velocity = at.copy())
	_connect_handle(%LineStart as Handle, func(at: Vec2) -> void: _turn_line(Vec2.new().minus(at)))
	_connect_handle(%LineEnd as Handle, _turn_line)
	_connect_handle(%NormalHead as Handle, _drag_normal)
	_connect_handle(%LeavingHead as Handle, _drag_leaving)


func _connect_handle(handle: Handle, change: Callable) -> void:
	handle.moved.connect(_move.bind(change))
	handle.released.connect(_finish)


func _connect_formula() -> void:
	var panel := services[&"formula"] as Formula
	_formula = ReflectionFormula.new(panel)
	panel.number_entered.connect(_enter_number)


func _fill_options() -> void:
	_options.add_switch("has_unit_normal", tr("Normal of length 1"))
	_options.switched.connect(_switch)
	for title: String in _PRESETS:
		_options.add_preset(title, tr(title))
	_options.preset_picked.connect(_set_up)
	for info in ReflectionMistakes.infos():
		_mistakes.add_mistake(info)
	_mistakes.mistake_picked.connect(_pick_mistake)


# What the student does.


func _move(at: Vec2, change: Callable) -> void:
	_transport.is_playing = false
	change.call(at)
	_show_model()


func _turn_line(head: Vec2) -> void:
	if head.length() > 0.0:
		_model.along = head.copy()


func _drag_normal(head: Vec2) -> void:
	_model.point_normal(head)
	if not _model.has_unit_normal and head.length() > 0.0:
		_model.normal_length = head.length()


func _drag_leaving(head: Vec2) -> void:
	_steps.go_to(ReflectionModel.Step.BOUNCE)
	_model.aim_bounciness(head)


func _enter_number(name_in_line: String, value: float) -> void:
	var problem := _model.enter(name_in_line, value)
	_show_all()
	if problem:
		noticed.emit(problem)
	else:
		_finish()


func _switch(key: String, on: bool) -> void:
	_model.set(key, on)
	_finish()


func _set_up(preset: String) -> void:
	var numbers: PackedFloat64Array = _PRESETS[preset]
	var velocity := Vec2.new(numbers[0], numbers[1])
	_take(velocity, Vec2.new(numbers[2], numbers[3]), numbers[4])


func _pick_mistake(number: int) -> void:
	_model.mistake = number
	# With C = 1 the bounciness does nothing, on whichever part it acts.
	if number == ReflectionMistakes.BOUNCY_TANGENT and _model.bounciness == 1.0:
		_model.bounciness = 0.5
	_finish()


func _show_exercise() -> void:
	_take(_exercise.velocity, _exercise.along, _exercise.bounciness)


func _take(velocity: Vec2, along: Vec2, bounciness: float) -> void:
	_model.velocity = velocity.copy()
	_model.along = along.copy()
	_model.bounciness = bounciness
	_model.has_unit_normal = true
	_finish()


func _ask() -> void:
	_exercise = ReflectionExercise.fresh(_exercise_kind, _rng)
	_exercise_kind = (
		(_exercise_kind + 1) % ReflectionExercise.Kind.size() as ReflectionExercise.Kind
	)
	_question.show_exercise(_exercise)


func _go_to_step(step: int) -> void:
	_step = step as ReflectionModel.Step
	_show_all()


func _run(seconds: float) -> void:
	if _transport.is_playing and _model.time == ReflectionModel.END:
		_model.time = ReflectionModel.START
	_model.time += seconds
	if _model.time == ReflectionModel.END:
		_transport.is_playing = false
	_drawing.show_ball(_model, _step)


func _finish() -> void:
	_show_all()
	edited.emit()
	noticed.emit(_model.refusal())


# What the student sees.


func _show_all() -> void:
	var points: Array[Vec2] = [_model.along]
	for point: Vec2 in [_model.velocity, _model.velocity_after(2.0)]:
		# Twice as much room below: the table of Godot's methods stands there.
		points.append(Vec2.new(point.x, 1.75 * point.y))
	board.fit(points)
	_options.show_switch("has_unit_normal", _model.has_unit_normal)
	_mistakes.show_mistake(_model.mistake)
	_show_model()


func _show_model() -> void:
	_steps.show_sentences(ReflectionTexts.sentences(_model), _step)
	_drawing.show_model(_model, _step)
	_formula.show_model(_model, _step)
	_table.show_model(_model)
	_show_verdict()
	_show_readout()


func _show_verdict() -> void:
	# The notice says it, in the same place.
	_verdict.visible = _model.refusal() == ""
	var sign_text := ReflectionTexts.verdict_sign(_model, _step)
	var role := Palette.Role.QUIET
	if sign_text == "=":
		role = Palette.Role.RIGHT
	_verdict.show_verdict(sign_text, role, ReflectionTexts.verdict(_model, _step))


func _show_readout() -> void:
	var title := "reflect(n, C)"
	if _model.refusal():
		_readout.show_texts("reflect", [title, tr("refused"), "", ""])
		return
	var result := _model.reflected()
	var error := ExactReflection.error_of(
		result, _model.velocity, _model.along, 1.0 + _model.bounciness
	)
	var way := _model.velocity.reflected.bind(_model.used_normal(), _model.bounciness)
	var time := tr("%s ns") % NumberText.short(CallTimer.nanoseconds(way), 2)
	var value := NumberText.pair(result.x, result.y)
	_readout.show_texts("reflect", [title, value, NumberText.size(error), time])
