extends Lesson
## The lesson on aiming under gravity: a flat arc, a high arc, and the least speed that does.
## Target, speed, gravity and the target's velocity at the start are in the scene: the handles there
## show them.

## At the opening the target goes up and down so often in 20 seconds, by this share of its distance.
const _SWINGS := 4.0
const _SWING := 0.5
# Between two shots of the opening, in seconds.
const _PAUSE := 0.4
# Speeds and gravity are dragged in steps of this, in px/s and px/s².
const _STEP := 10.0

var _model := BallisticAimModel.new()
# What the list of aims holds.
var _arcs: PackedStringArray = []

@onready var _transport: Transport = services.get(&"transport")
@onready var _options: LessonOptions = services.get(&"options")
@onready var _drawing: BallisticAimDrawing = %Drawing
@onready var _target: Handle = %TargetHandle
@onready var _speed_head: Handle = %SpeedHead
@onready var _gravity_head: Handle = %GravityHead
@onready var _velocity_head: Handle = %VelocityHead


func start() -> void:
	_drag_target(_target.at())
	_drag_speed(_speed_head.at())
	_drag_gravity(_gravity_head.at())
	_drag_velocity(_velocity_head.at())
	on_handle(_target, _drag_target)
	on_handle(_speed_head, _drag_speed)
	on_handle(_gravity_head, _drag_gravity)
	on_handle(_velocity_head, _drag_velocity)
	show_in_panel(BallisticAimFormula.new(services[&"formula"] as Formula))
	show_in_panel(BallisticAimReadout.new(services[&"readout"] as Readout))
	add_switch("moves", tr("The target moves"))
	add_switch("falls", tr("The target falls"))
	_options.add_choice("arc", tr("Which aim is flown"), [])
	offer_presets(BallisticAimModel.PRESETS)
	offer_mistakes(BallisticAimMistakes.infos(), BallisticAimModel.step_of_mistake)
	offer_questions(BallisticAimExercise)
	on_edit(_options.chosen, func(_key: String, place: int) -> void: _model.arc = place)
	_transport.advanced.connect(_fly)
	begin(_model, _show, func() -> Array[Vec2]: return _drawing.points_to_show(_model, _step()))
	open_with(_swing.bind(_model.target.copy()))


# What moves by itself: the target goes up and down, and one straight shot after another comes too
# low.
func _swing(seconds: float, first: Vec2) -> void:
	var share := OpeningMotion.to_and_fro(seconds, _SWINGS)
	_model.target = Vec2.new(first.x, roundf(first.y - _SWING * first.length() * share))
	_model.time = fmod(seconds, _model.end(_step()) + _PAUSE)


# What the student does.


func _drag_target(to: Vec2) -> void:
	_model.target = _within(to)


func _drag_speed(to: Vec2) -> void:
	var wanted := snappedf(to.length() / BallisticAimModel.ARROW_SECONDS, _STEP)
	_model.speed = clampf(wanted, _STEP, BallisticAimModel.LARGEST)


func _drag_gravity(to: Vec2) -> void:
	var wanted := snappedf(to.y / BallisticAimModel.ARROW_SECONDS, _STEP)
	_model.gravity = clampf(wanted, 0.0, BallisticAimModel.LARGEST)


func _drag_velocity(to: Vec2) -> void:
	_model.velocity = _within(to.minus(_model.target).divided(BallisticAimModel.ARROW_SECONDS))


static func _within(vector: Vec2) -> Vec2:
	var most := BallisticAimModel.LARGEST
	return Vec2.new(clampf(vector.x, -most, most), clampf(vector.y, -most, most))


func _fly(seconds: float) -> void:
	_model.time = _transport.flown(_model.time, seconds, _model.end(_step()))
	_drawing.show_flight(_model, _step())


# What the student sees.


func _show() -> void:
	ask_choice_before(
		BallisticAimModel.Step.TIMES,
		BallisticAimTexts.question_on_count(),
		BallisticAimTexts.choices(),
		BallisticAimTexts.right_choice.bind(_model)
	)
	ask_before(
		BallisticAimModel.Step.ARCS,
		BallisticAimTexts.question_on_aim(),
		_model.first_aim_point,
		func() -> Vec2: return _model.target.copy()
	)
	tell_steps(BallisticAimTexts.sentences(_model))
	tell_code(BallisticAimCode.lines(_model, _step()), BallisticAimCode.inputs(_model))
	_drawing.show_model(_model, _step())
	_show_arcs()


func _show_arcs() -> void:
	var texts := BallisticAimTexts.arcs(_model).slice(0, _model.shots().size())
	if texts != _arcs:
		_arcs = texts
		_options.fill_choice("arc", texts)
	if texts:
		_options.show_choice("arc", _model.arc_flown())
	_options.reveal_choice("arc", _step() >= BallisticAimModel.Step.ARCS and texts.size() > 1)


func _step() -> BallisticAimModel.Step:
	return step as BallisticAimModel.Step
