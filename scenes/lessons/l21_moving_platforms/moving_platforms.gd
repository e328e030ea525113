extends Lesson
## The lesson on surfaces that move: a wall, a belt, a platform, a paddle, a press. The wall, the
## ball and both velocities at the start are in the scene: the handles there show them.

var _model := MovingPlatformsModel.new()
var _flight: PlatformFlight
var _handles: MovingPlatformsHandles
var _clock: FlightClock
# The moment that is shown, in seconds.
var _now := 0.0

@onready var _options: LessonOptions = services.get(&"options")
@onready var _drawing: MovingPlatformsDrawing = %Drawing


func start() -> void:
	_handles = MovingPlatformsHandles.new(self, _model)
	_handles.read_scene()
	show_in_panel(MovingPlatformsFormula.new(services[&"formula"] as Formula))
	show_in_panel(MovingPlatformsReadout.new(services[&"readout"] as Readout))
	_flight = PlatformFlight.new(_model)
	_options.add_choice("kind", tr("What moves"), MovingPlatformsTexts.kinds())
	on_edit(_options.chosen, _choose_kind)
	add_switch("from_surface", tr("Ride along"))
	offer_presets(MovingPlatformsPresets.ALL)
	offer_mistakes(MovingPlatformsMistakes.infos(), MovingPlatformsTexts.step_of_mistake)
	offer_questions(MovingPlatformsExercise, MovingPlatformsExercise.of_the_lecture)
	var end := func() -> float: return _flight.end(_step())
	_clock = FlightClock.new(services[&"transport"] as Transport, end, _show_moment)
	begin(_model, _show, _points)
	about_to_show.connect(_clock.go_to.bind(0.0))
	open_with(_clock.repeat)


# Each kind begins with numbers of its own.
func _choose_kind(_key: String, place: int) -> String:
	return _model.take(MovingPlatformsPresets.OF_KIND[place])


func _points() -> Array[Vec2]:
	return _drawing.points_to_show(_model, _handles)


# While everything moves, nothing else has to be shown anew.
func _show_moment(seconds: float) -> void:
	_now = seconds
	_drawing.show_moment(_model, _flight, seconds, _step())


func _show() -> void:
	_ask()
	_flight = PlatformFlight.new(_model)
	tell_steps(MovingPlatformsTexts.sentences(_model))
	tell_code(MovingPlatformsCode.lines(_model, _step()), MovingPlatformsCode.inputs(_model))
	_handles.place()
	_drawing.show_model(_model, _flight, _handles, _step())
	_show_moment(_now)
	_options.show_choice("kind", _model.kind)


func _ask() -> void:
	ask_choice_before(
		MovingPlatformsModel.Step.LAW,
		MovingPlatformsTexts.question(_model),
		MovingPlatformsTexts.choices(_model),
		MovingPlatformsTexts.right_choice.bind(_model)
	)
	ask_before(
		MovingPlatformsModel.Step.BACK,
		MovingPlatformsTexts.question_on_velocity(),
		func() -> Vec2: return _drawing.head_after(_model, _flight),
		func() -> Vec2: return _drawing.head_before(_model, _flight)
	)


func _step() -> MovingPlatformsModel.Step:
	return step as MovingPlatformsModel.Step
