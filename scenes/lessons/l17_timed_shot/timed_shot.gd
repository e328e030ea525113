extends Lesson
## The lesson on the moment to fire: the barrel does not follow the target, so the moment is all
## that can be chosen. Muzzle, target, both velocities and the circle's centre at the start are in
## the scene: the handles there show them.

## At the opening the target goes so often along its way and back in 20 seconds, by the way of so
## many seconds.
const _SWINGS := 4.0
const _SWING := 2.0
# Velocities are dragged in steps of this, in px/s.
const _STEP := 10.0

var _model := TimedShotModel.new()

@onready var _transport: Transport = services.get(&"transport")
@onready var _options: LessonOptions = services.get(&"options")
@onready var _drawing: TimedShotDrawing = %Drawing
@onready var _timeline: ShotTimeline = %Timeline
@onready var _muzzle: Handle = %Muzzle
@onready var _leaving_head: Handle = %LeavingHead
@onready var _start: Handle = %Start
@onready var _velocity_head: Handle = %VelocityHead
@onready var _centre: Handle = %Centre


func start() -> void:
	_model.muzzle = _muzzle.at()
	_model.target = _start.at()
	_model.centre = _centre.at()
	_model.bullet = _velocity_to(_leaving_head.at(), _model.muzzle)
	_model.velocity = _velocity_to(_velocity_head.at(), _model.target)
	on_handle(_muzzle, _drag_muzzle)
	on_handle(_leaving_head, _drag_bullet)
	on_handle(_start, _drag_target)
	on_handle(_velocity_head, _drag_velocity)
	on_handle(_centre, _drag_centre)
	on_drag(_timeline.moment_wanted, _timeline.released, _take_moment)
	add_child(CardPlace.new(_timeline, board, services[&"formula"]))
	show_in_panel(TimedShotFormula.new(services[&"formula"] as Formula))
	show_in_panel(TimedShotReadout.new(services[&"readout"] as Readout))
	_options.add_choice("kind", tr("How target and barrel move"), TimedShotTexts.kinds())
	offer_presets(TimedShotModel.PRESETS)
	offer_mistakes(TimedShotMistakes.infos(), TimedShotTexts.step_of_mistake)
	offer_questions(TimedShotExercise)
	on_edit(
		_options.chosen,
		func(_key: String, place: int) -> String: return _model.take({kind = place})
	)
	_transport.advanced.connect(_fly)
	begin(_model, _show, _drawing.points_to_show.bind(_model))
	open_with(_swing.bind(_model.target.copy()))


# What moves by itself: the target goes along its way and back.
func _swing(seconds: float, first: Vec2) -> void:
	var share := OpeningMotion.to_and_fro(seconds, _SWINGS)
	var way := _model.velocity.scaled(_SWING * share)
	_model.target = Vec2.new(roundf(first.x + way.x), roundf(first.y + way.y))


# What the student does.


func _drag_muzzle(to: Vec2) -> String:
	return _model.take({"muzzle": _pair(to)})


func _drag_bullet(head: Vec2) -> String:
	return _model.take({"bullet": _pair(_velocity_to(head, _model.muzzle))})


func _drag_target(to: Vec2) -> String:
	return _model.take({"target": _pair(to)})


func _drag_velocity(head: Vec2) -> String:
	return _model.take({"velocity": _pair(_velocity_to(head, _model.target))})


func _drag_centre(to: Vec2) -> String:
	return _model.take({"centre": _pair(to)})


func _take_moment(seconds: float) -> void:
	_model.own_fire = clampf(seconds, 0.0, TimedShotCheck.LONGEST)


static func _velocity_to(head: Vec2, tail: Vec2) -> Vec2:
	var wanted := head.minus(tail).divided(TimedShotModel.ARROW_SECONDS)
	return Vec2.new(snappedf(wanted.x, _STEP), snappedf(wanted.y, _STEP))


static func _pair(vector: Vec2) -> PackedFloat64Array:
	return [vector.x, vector.y]


func _fly(seconds: float) -> void:
	_model.time = _transport.flown(_model.time, seconds, _model.end(_step()))
	_drawing.show_motion(_model, _step())


# What the student sees.


func _show() -> void:
	ask_before(
		TimedShotModel.Step.WAIT,
		TimedShotTexts.question_on_moment(),
		_model.place_at_fire,
		func() -> Vec2: return _model.target.copy()
	)
	ask_choice_before(
		TimedShotModel.Step.WINDOW,
		TimedShotTexts.question_on_window(),
		TimedShotTexts.choices(),
		TimedShotTexts.right_choice.bind(_model)
	)
	tell_steps(TimedShotTexts.sentences(_model))
	tell_code(TimedShotCode.lines(_model, _step()), TimedShotCode.inputs(_model))
	_drawing.show_model(_model, _step())
	_options.show_choice("kind", _model.kind)


func _step() -> TimedShotModel.Step:
	return step as TimedShotModel.Step
