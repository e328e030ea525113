extends Lesson
## The lesson on surfaces that move: a wall, a belt, a platform, a paddle, a press. The wall, the
## ball and both velocities at the start are in the scene: the handles there show them.

# In the opening ball and wall wait so long where they meet, in seconds, before they start again.
const _PAUSE := 0.8

var _model := MovingPlatformsModel.new()
var _flight: PlatformFlight
var _handles: MovingPlatformsHandles
var _formula: MovingPlatformsFormula
var _readout: MovingPlatformsReadout
var _clock: FlightClock
# The moment that is shown, in seconds.
var _now := 0.0

@onready var _options: LessonOptions = services.get(&"options")
@onready var _drawing: MovingPlatformsDrawing = %Drawing


func start() -> void:
	_handles = MovingPlatformsHandles.new(self, _model)
	_handles.read_scene()
	_formula = MovingPlatformsFormula.new(services[&"formula"] as Formula)
	_readout = MovingPlatformsReadout.new(services[&"readout"] as Readout)
	_flight = PlatformFlight.new(_model)
	_fill_panel()
	var end := func() -> float: return _flight.end(_step())
	_clock = FlightClock.new(services[&"transport"] as Transport, end, _show_moment)
	# Not during a drag: measuring would slow it down.
	about_to_show.connect(func() -> void: _readout.measure(_model))
	begin(_model, _show, _points)
	about_to_show.connect(_clock.go_to.bind(0.0))
	open_with(func(seconds: float) -> void: _clock.repeat(seconds, _PAUSE))


func _fill_panel() -> void:
	_options.add_choice("kind", tr("What moves"), MovingPlatformsTexts.kinds())
	_options.add_switch("from_surface", tr("Ride along"))
	_options.offer_presets(MovingPlatformsPresets.ALL)
	(services[&"mistakes"] as Mistakes).add_all(MovingPlatformsMistakes.infos())
	var questions := services[&"question"] as Question
	var kinds := MovingPlatformsExercise.Kind.size()
	questions.offer(MovingPlatformsExercise.fresh, kinds, 0, MovingPlatformsExercise.of_the_lecture)
	on_enter(_model.enter)
	on_pick(_model.take, _reveal)
	on_edit(_options.chosen, _choose_kind)


# Each kind begins with numbers of its own.
func _choose_kind(_key: String, place: int) -> String:
	return _model.take(MovingPlatformsPresets.OF_KIND[place])


# A mistake is seen where the answer is.
func _reveal(changes: Dictionary) -> void:
	if changes.get("mistake", 0) != 0 and step < MovingPlatformsModel.Step.BACK:
		(services[&"steps"] as Steps).go_to(MovingPlatformsModel.Step.BACK)


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
	_formula.show_model(_model, _step())
	_readout.show_model(_model, _step())
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
