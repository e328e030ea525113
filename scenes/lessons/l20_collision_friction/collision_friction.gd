extends Lesson
## The lesson on friction at a bounce. Velocity, spin, line and radius at the start are in the
## scene; friction and bounciness are below.

## The friction µ at the start.
@export_range(0.0, 10.0, 0.005) var friction := 0.25
## The bounciness C at the start.
@export_range(0.0, 1.0, 0.01) var bounciness := 1.0

var _model := CollisionFrictionModel.new()
var _player: ContactPlayer
var _formula: CollisionFrictionFormula
var _readout: CollisionFrictionReadout

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
	add_switch("has_friction", tr("Friction"))
	offer_presets(CollisionFrictionPresets.all())
	offer_mistakes(CollisionFrictionMistakes.infos(), CollisionFrictionTexts.step_of_mistake)
	offer_questions(GripExercise, GripExercise.of_the_lecture)
	_player = ContactPlayer.new(services[&"transport"] as Transport, _drawing.show_moment)
	_player.prepare(_model, 0)
	# Not during a drag: measuring would slow it down.
	about_to_show.connect(func() -> void: _readout.measure(_player.contact))
	begin(_model, _show, _points)
	about_to_show.connect(_player.rewind)
	open_with(_player.repeat)


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
	var wanted := CollisionFrictionDrawing.velocity_for(_player.contact, tail)
	return _model.take({"velocity": PackedFloat64Array([wanted.x, wanted.y])})


func _drag_spin(knob: Vec2) -> String:
	var wanted := CollisionFrictionDrawing.spin_for(_player.contact, knob)
	var most := CollisionFrictionModel.FASTEST_SPIN
	return _model.take({"spin": clampf(wanted, -most, most)})


func _drag_line(to: Vec2) -> String:
	return _model.take({"along": PackedFloat64Array([to.x, to.y])})


func _drag_cone(knob: Vec2) -> String:
	var wanted := CollisionFrictionDrawing.friction_for(_player.contact, knob)
	return _model.take({"friction": wanted, "has_friction": true})


# What the student sees.


func _points() -> Array[Vec2]:
	_player.prepare(_model, step)
	return _drawing.points_to_show(_player.contact, _player.flight, _model.along, step)


func _show() -> void:
	_player.prepare(_model, step)
	var contact := _player.contact
	var flight := _player.flight
	_ask(contact)
	tell_steps(CollisionFrictionTexts.sentences(_model, contact))
	tell_code(
		CollisionFrictionCode.lines(contact, step), CollisionFrictionCode.inputs(contact, flight)
	)
	_drawing.show_model(_model, contact, flight, step)
	_player.show_balls()
	_formula.show_model(_model, contact, flight, step)
	_readout.show_model(contact, flight, step)


func _ask(contact: FrictionContact) -> void:
	ask_choice_before(
		CollisionFrictionModel.Step.CONE,
		CollisionFrictionTexts.question_on_cone(),
		CollisionFrictionTexts.choices_on_cone(),
		func() -> int: return CollisionFrictionTexts.right_about_cone(contact)
	)
	ask_before(
		CollisionFrictionModel.Step.AFTER,
		CollisionFrictionTexts.question_on_velocity(_model),
		func() -> Vec2: return CollisionFrictionDrawing.head_after(contact),
		func() -> Vec2: return CollisionFrictionDrawing.head_without_friction(contact)
	)
	ask_choice_before(
		CollisionFrictionModel.Step.LEDGER,
		CollisionFrictionTexts.question_on_ledger(),
		CollisionFrictionTexts.choices_on_ledger(),
		func() -> int: return CollisionFrictionTexts.right_about_ledger(contact)
	)
