extends Lesson
## The lesson on the law of reflection and the bounciness: subtract the part along the normal.
## Velocity, line and bounciness at the start are in the scene: the handles there show them.

## The length of the normal where its switch is off: one of length 1 is taken by default.
@export_range(0.001, 100.0, 0.001, "or_greater") var normal_length := 2.0

var _model := ReflectionModel.new()

@onready var _transport: Transport = services.get(&"transport")
@onready var _readout: Readout = services.get(&"readout")
@onready var _drawing: ReflectionDrawing = %Drawing
@onready var _velocity_head: Handle = %VelocityHead
@onready var _line_end: Handle = %LineEnd
@onready var _leaving_head: Handle = %LeavingHead


func start() -> void:
	_aim(_velocity_head.at())
	_model.along = _line_end.at()
	_model.fit_bounciness(_leaving_head.at())
	_model.normal_length = normal_length
	on_handle(_velocity_head, _aim)
	on_handle(%ComingTail as Handle, func(at: Vec2) -> void: _aim(Vec2.new().minus(at)))
	on_handle(_line_end, _turn_line)
	on_handle(%LineStart as Handle, func(at: Vec2) -> void: _turn_line(Vec2.new().minus(at)))
	on_handle(%NormalHead as Handle, _drag_normal)
	on_handle(_leaving_head, _drag_leaving)
	add_child(CardPlace.new(%Table as Control, board, services[&"formula"]))
	show_in_panel(ReflectionFormula.new(services[&"formula"] as Formula))
	add_switch("has_unit_normal", tr("Normal of length 1"))
	offer_presets(ReflectionModel.PRESETS)
	offer_mistakes(ReflectionMistakes.infos())
	offer_questions(ReflectionExercise, ReflectionExercise.of_the_lecture)
	# While the ball flies, nothing else has to be shown anew.
	_transport.advanced.connect(_fly)
	about_to_show.connect(_tell_refusal)
	begin(_model, _show, _spanned_points)
	open_with(_play_shot)


# What moves by itself: the ball flies in, bounces and flies off, once. Then it waits at the start.
func _play_shot(seconds: float) -> void:
	var time := ReflectionModel.START + seconds
	_model.time = time if time < ReflectionModel.END else ReflectionModel.START


# What the student does.


func _aim(head: Vec2) -> void:
	_model.velocity = head.copy()


func _turn_line(end: Vec2) -> void:
	if end.length() > 0.0:
		_model.along = end.copy()


func _drag_normal(head: Vec2) -> void:
	_model.point_normal(head)
	if not _model.has_unit_normal and head.length() > 0.0:
		_model.normal_length = head.length()


func _drag_leaving(head: Vec2) -> void:
	(services[&"steps"] as Steps).go_to(ReflectionModel.Step.BOUNCE)
	_model.fit_bounciness(head)


func _fly(seconds: float) -> void:
	var end := ReflectionModel.END
	_model.time = _transport.flown(_model.time, seconds, end, ReflectionModel.START)
	_drawing.show_ball(_model, _step())


# What the student sees.


# A refusal stays in the notice line as long as it holds.
func _tell_refusal() -> void:
	if _model.refusal():
		noticed.emit(_model.refusal())


func _spanned_points() -> Array[Vec2]:
	var points: Array[Vec2] = [_model.along]
	for point: Vec2 in [_model.velocity, _model.velocity_after(2.0)]:
		# Room below for the table of Godot's methods.
		points.append(Vec2.new(point.x, 1.75 * point.y))
	return points


func _show() -> void:
	ask_choice_before(
		ReflectionModel.Step.SLIDE,
		ReflectionTexts.question_on_slide(),
		ReflectionTexts.choices(),
		func() -> int: return 1 if _has_part() and not _model.stops_after(1.0) else -1
	)
	ask_before(
		ReflectionModel.Step.MIRROR,
		ReflectionTexts.question_on_mirror(),
		func() -> Vec2: return _model.velocity_after(2.0) if _has_part() else null,
		_model.velocity_after.bind(1.0)
	)
	tell_steps(ReflectionTexts.sentences(_model))
	tell_code(ReflectionCode.lines(_model, _step()), ReflectionCode.inputs(_model))
	_drawing.show_model(_model, _step())
	_show_call()


func _has_part() -> bool:
	return not _model.is_along_line() and not _model.refusal()


func _step() -> ReflectionModel.Step:
	return step as ReflectionModel.Step


func _show_call() -> void:
	_readout.visible = _step() == ReflectionModel.Step.BOUNCE
	var title := "reflect(n̂, C)"
	if _model.refusal():
		_readout.show_texts("reflect", [title, tr("refused"), "", ""])
		return
	var times := 1.0 + _model.bounciness
	var result := _model.reflected()
	var error := ExactReflection.error_of(result, _model.velocity, _model.along, times)
	var method := _model.velocity.reflected.bind(_model.used_normal(), _model.bounciness)
	_readout.show_vector("reflect", title, result, error, CallTimer.nanoseconds(method))
