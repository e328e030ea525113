extends Lesson
## The lesson on friction at a bounce. Velocity, spin, line and radius at the start are in the
## scene; friction and bounciness are below.

# In the opening the ball waits so long, in seconds, before it comes again.
const _PAUSE := 0.8

## The friction µ at the start.
@export_range(0.0, 10.0, 0.005) var friction := 0.25
## The bounciness C at the start.
@export_range(0.0, 1.0, 0.01) var bounciness := 1.0

var _model := CollisionFrictionModel.new()
var _contact: FrictionContact
var _flight: ContactFlight
var _formula: CollisionFrictionFormula
var _readout: CollisionFrictionReadout
var _clock: FlightClock
var _seconds := 0.0

@onready var _drawing: CollisionFrictionDrawing = %Drawing
@onready var _ledger: ContactLedger = %Ledger


func start() -> void:
	_put_start()
	on_handle(%VelocityHandle as Handle, _drag_velocity)
	on_handle(%SpinHandle as Handle, _drag_spin)
	on_handle(%LineHandle as Handle, _drag_line)
	on_handle(%ConeHandle as Handle, _drag_cone)
	add_child(CardPlace.new(_ledger, board, services[&"formula"]))
	_formula = CollisionFrictionFormula.new(services[&"formula"] as Formula)
	_readout = CollisionFrictionReadout.new(services[&"readout"] as Readout)
	var options := services[&"options"] as LessonOptions
	options.add_switch("has_friction", tr("Friction"))
	options.offer_presets(CollisionFrictionPresets.all())
	(services[&"mistakes"] as Mistakes).add_all(CollisionFrictionMistakes.infos())
	var questions := services[&"question"] as Question
	var kinds := GripExercise.Kind.size()
	questions.offer(GripExercise.fresh, kinds, 0, GripExercise.of_the_lecture)
	on_enter(_model.enter)
	on_pick(_model.take, _reveal)
	_prepare()
	var end := func() -> float: return CollisionFrictionDrawing.end(_flight, step)
	_clock = FlightClock.new(services[&"transport"] as Transport, end, _show_moment)
	# Not during a drag: measuring would slow it down.
	about_to_show.connect(func() -> void: _readout.measure(_model.contact()))
	begin(_model, _show, _points)
	about_to_show.connect(_clock.go_to.bind(0.0))
	open_with(func(seconds: float) -> void: _clock.repeat(seconds, _PAUSE))


func _put_start() -> void:
	_model.along = (%LineHandle as Handle).at()
	_model.radius = (%Ghost as BallView).radius
	_model.friction = friction
	_model.bounciness = bounciness
	var contact := _model.contact()
	var tail := (%VelocityHandle as Handle).at()
	_model.velocity = CollisionFrictionDrawing.velocity_for(contact, tail)
	_model.spin = CollisionFrictionDrawing.spin_for(contact, (%SpinHandle as Handle).at())


# What the student drags. After each change the ball comes anew.


func _drag_velocity(tail: Vec2) -> String:
	var wanted := CollisionFrictionDrawing.velocity_for(_contact, tail)
	return _model.take({"velocity": PackedFloat64Array([wanted.x, wanted.y])})


func _drag_spin(knob: Vec2) -> String:
	var wanted := CollisionFrictionDrawing.spin_for(_contact, knob)
	var most := CollisionFrictionModel.FASTEST_SPIN
	return _model.take({"spin": clampf(wanted, -most, most)})


func _drag_line(to: Vec2) -> String:
	return _model.take({"along": PackedFloat64Array([to.x, to.y])})


func _drag_cone(knob: Vec2) -> String:
	var wanted := CollisionFrictionDrawing.friction_for(_contact, knob)
	return _model.take({"friction": wanted, "has_friction": true})


func _reveal(changes: Dictionary) -> void:
	if changes.get("mistake", 0) != 0 and step < CollisionFrictionModel.Step.AFTER:
		(services[&"steps"] as Steps).go_to(CollisionFrictionModel.Step.AFTER)


# What the student sees.


# At the first step it flies as if there were no friction.
func _prepare() -> void:
	_contact = _model.contact()
	_flight = _model.flight(_contact, step != CollisionFrictionModel.Step.MEET)


func _points() -> Array[Vec2]:
	_prepare()
	return _drawing.points_to_show(_contact, _flight, _model.along, step)


# While the balls fly, nothing else has to be shown anew.
func _show_moment(seconds: float) -> void:
	_seconds = seconds
	_drawing.show_moment(_contact, _flight, seconds)


func _show() -> void:
	_prepare()
	_ask()
	tell_steps(CollisionFrictionTexts.sentences(_model, _contact))
	tell_code(
		CollisionFrictionCode.lines(_contact, step), CollisionFrictionCode.inputs(_contact, _flight)
	)
	_drawing.show_model(_model, _contact, _flight, step)
	_formula.show_model(_model, _contact, _flight, step)
	_readout.show_model(_contact, _flight, step)
	_show_moment(_seconds)


func _ask() -> void:
	ask_choice_before(
		CollisionFrictionModel.Step.CONE,
		CollisionFrictionTexts.question_on_cone(),
		CollisionFrictionTexts.choices_on_cone(),
		func() -> int: return CollisionFrictionTexts.right_about_cone(_contact)
	)
	ask_before(
		CollisionFrictionModel.Step.AFTER,
		CollisionFrictionTexts.question_on_velocity(_model),
		func() -> Vec2: return CollisionFrictionDrawing.head_after(_contact),
		func() -> Vec2: return CollisionFrictionDrawing.head_without_friction(_contact)
	)
	ask_choice_before(
		CollisionFrictionModel.Step.LEDGER,
		CollisionFrictionTexts.question_on_ledger(),
		CollisionFrictionTexts.choices_on_ledger(),
		func() -> int: return CollisionFrictionTexts.right_about_ledger(_contact)
	)
