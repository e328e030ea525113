extends Lesson
## The lesson on sliding and rolling: a ball on a slope, with friction. The line and the radius at
## the start are in the scene.

var _model := SlideAndRollModel.new()
var _race: BallRace
var _formula: SlideAndRollFormula
var _readout: SlideAndRollReadout
var _clock: FlightClock

@onready var _drawing: SlideAndRollDrawing = %Drawing
@onready var _line: DraggableVector = %Line
@onready var _ball: TurnedBall = %Ball
@onready var _speed_handle: Handle = %SpeedHandle
@onready var _card: FrictionCard = %Card
@onready var _engine: EngineRunner = %Engine


func start() -> void:
	_model.start = _line.tail_point()
	_model.end = _line.head_point()
	_model.radius = _ball.radius
	on_drag(_line.moved, _line.released, _move_line)
	on_drag(_speed_handle.moved, _speed_handle.released, _drag_speed)
	on_drag(_card.friction_pointed, _card.released, _point_friction)
	add_child(CardPlace.new(_card, board, services[&"formula"]))
	_formula = SlideAndRollFormula.new(services[&"formula"] as Formula)
	_readout = SlideAndRollReadout.new(services[&"readout"] as Readout)
	offer_presets(SlideAndRollModel.PRESETS)
	add_switch("has_engine", tr("Godot"))
	offer_mistakes(SlideAndRollMistakes.infos(), SlideAndRollTexts.step_of_mistake)
	offer_questions(RollExercise, RollExercise.of_the_lecture)
	# Not during a drag: measuring would slow it down.
	about_to_show.connect(func() -> void: _readout.measure(_model))
	about_to_show.connect(func() -> void: _engine.show_model(_model))
	_engine.measured.connect(_show_readout)
	begin(_model, _show, func() -> Array[Vec2]: return _drawing.points_to_show(_model, step))
	var end := func() -> float: return _race.end(step)
	_clock = FlightClock.new(services[&"transport"] as Transport, end, _show_moment)
	about_to_show.connect(_clock.go_to.bind(0.0))
	# The ball without friction, again and again.
	open_with(_clock.repeat)


# What the student does. After each change the balls start anew.


# An end that is dragged stays where the line falls, or is level.
func _move_line(tail: Vec2, head: Vec2) -> String:
	var start_point := tail.copy()
	var end_point := head.copy()
	var shortest := board.step_length()
	if head.distance_to(_model.end) == 0.0:
		start_point.x = minf(tail.x, head.x - shortest)
		start_point.y = minf(tail.y, head.y)
	elif tail.distance_to(_model.start) == 0.0:
		end_point.x = maxf(head.x, tail.x + shortest)
		end_point.y = maxf(head.y, tail.y)
	return _model.take({"start": [start_point.x, start_point.y], "end": [end_point.x, end_point.y]})


func _drag_speed(at: Vec2) -> String:
	return _model.take({"speed": _drawing.speed_for(_model, at)})


func _point_friction(friction: float) -> String:
	return _model.take({"friction": minf(friction, SlideAndRollModel.MOST_FRICTION)})


# What the student sees.


# While the balls run, nothing else has to be shown anew.
func _show_moment(seconds: float) -> void:
	_model.time = seconds
	_drawing.show_moment(_model, _race, step)


func _show_readout() -> void:
	_readout.show_model(_model, _race, _engine.roll, step)


func _show() -> void:
	ask_choice_before(
		SlideAndRollModel.Step.MARK,
		SlideAndRollTexts.question_on_mark(),
		SlideAndRollTexts.choices(),
		SlideAndRollTexts.right_choice.bind(_model)
	)
	ask_before(
		SlideAndRollModel.Step.RACE,
		SlideAndRollTexts.question_on_race(),
		_truth,
		func() -> Vec2: return _model.center_at(0.0)
	)
	_race = BallRace.new(_model)
	tell_steps(SlideAndRollTexts.sentences(_model, _race))
	tell_code(SlideAndRollCode.lines(_model, _race, step), SlideAndRollCode.inputs(_model, _race))
	_drawing.show_model(_model, _race, step)
	_formula.show_model(_model, _race, step)
	_show_readout()


# Where the ball is when the one without friction is at the end; null where that never is.
func _truth() -> Vec2:
	if _race.sliding.end_time == INF:
		return null
	return _model.center_at(_race.ball.after(_race.sliding.end_time).distance)
