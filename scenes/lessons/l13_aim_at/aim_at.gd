extends Lesson
## The lesson on aiming at a target: a barrel on a hull that turns. Where both stand and where the
## target is at the start is in the scene.

# In the opening the hull swings so far to both sides, in degrees, and so often in 20 seconds.
const _SWING := 40.0
const _SWINGS := 4.0

var _model := AimAtModel.new()
var _shots: AimShots
var _formula: AimAtFormula
var _readout: AimAtReadout
var _clock: FlightClock

@onready var _drawing: AimAtDrawing = %Drawing
@onready var _hull: TankHull = %Hull
@onready var _barrel: GunBarrel = %Barrel
@onready var _mark: TargetMark = %Mark


func start() -> void:
	_model.hull = _hull.at()
	_model.hull_degrees = _hull.degrees
	var nozzle := Vec2.from_vector2(_barrel.nozzle)
	_model.length = roundf(nozzle.distance_to(_model.hull))
	_model.barrel_degrees = _own_degrees_at(nozzle)
	_model.target = _mark.at()
	_model.radius = _mark.radius
	_let_drag(%HullHandle as Handle, _move_hull)
	_let_drag(%FrontHandle as Handle, _turn_hull)
	_let_drag(%BarrelHandle as Handle, _turn_barrel)
	_let_drag(%TargetHandle as Handle, _move_target)
	on_point(MOUSE_BUTTON_LEFT, func(at: Vec2) -> String: return _move_target(_snapped(at)))
	on_point(MOUSE_BUTTON_RIGHT, func(at: Vec2) -> String: return _move_hull(_snapped(at)))
	_formula = AimAtFormula.new(services[&"formula"] as Formula)
	_readout = AimAtReadout.new(services[&"readout"] as Readout)
	(services[&"options"] as LessonOptions).offer_presets(AimAtModel.PRESETS)
	(services[&"mistakes"] as Mistakes).add_all(AimAtMistakes.infos())
	var questions := services[&"question"] as Question
	questions.offer(AimExercise.fresh, AimExercise.Kind.size(), 0, AimExercise.of_the_table)
	on_enter(_model.enter)
	on_pick(_take)
	var end := func() -> float: return _shots.end(step)
	_clock = FlightClock.new(services[&"transport"] as Transport, end, _show_moment)
	# Not during a drag: measuring would slow it down.
	about_to_show.connect(func() -> void: _readout.measure(_model))
	begin(_model, _show, _points)
	about_to_show.connect(_clock.go_to.bind(0.0))
	open_with(_swing.bind(_model.hull_degrees))


# What moves by itself: the hull swings, and the barrel with it. To hundredths, so that the numbers
# beside it stay short.
func _swing(seconds: float, first: float) -> void:
	var share := sin(TAU * _SWINGS * seconds / OpeningMotion.LONGEST)
	_model.hull_degrees = AimAtModel.short(snappedf(first + _SWING * share, 0.01))


func _let_drag(handle: Handle, change: Callable) -> void:
	on_drag(handle.moved, handle.released, change)


# What the student does. After each change the shot flies from the beginning.


func _move_hull(to: Vec2) -> String:
	return _take({"hull": [to.x, to.y]})


func _turn_hull(to: Vec2) -> String:
	var way := to.minus(_model.hull)
	return _take({"hull_degrees": AimAtModel.short(roundf(way.angle_degrees()))})


func _turn_barrel(to: Vec2) -> String:
	return _take({"barrel_degrees": _own_degrees_at(to)})


# How far a barrel that points at a place is turned on the hull, to whole degrees.
func _own_degrees_at(place: Vec2) -> float:
	var degrees := place.minus(_model.hull).angle_degrees() - _model.hull_degrees
	return AimAtModel.short(roundf(degrees))


func _move_target(to: Vec2) -> String:
	return _take({"target": [to.x, to.y]})


func _snapped(at: Vec2) -> Vec2:
	return board.snapped_to_step(at)


func _take(changes: Dictionary) -> String:
	var problem := _model.take(changes)
	if changes.has("mistake") and not problem:
		_model.show_mistake(_model.mistake)
		_go_to_mistake()
	return problem


# A mistake is shown beside what is right: at the step of that.
func _go_to_mistake() -> void:
	var wanted := AimAtModel.Step.FIRE
	if _model.mistake == AimAtMistakes.LONG_WAY:
		wanted = AimAtModel.Step.TURN
	if _model.mistake != 0:
		(services[&"steps"] as Steps).go_to(wanted)


# What the student sees.


# While the barrel turns and the shot flies, nothing else has to be shown anew.
func _show_moment(seconds: float) -> void:
	_model.time = seconds
	_drawing.show_flight(_model, _shots, step)


func _points() -> Array[Vec2]:
	return _drawing.points_to_show(_model, AimShots.new(_model))


func _show() -> void:
	ask_choice_before(
		AimAtModel.Step.NESTED,
		AimAtTexts.question_on_angle(),
		AimAtTexts.choices_on_angle(_model),
		AimAtTexts.right_angle_choice.bind(_model)
	)
	ask_choice_before(
		AimAtModel.Step.TURN,
		AimAtTexts.question_on_turn(),
		AimAtTexts.choices_on_turn(),
		AimAtTexts.right_turn_choice.bind(_model)
	)
	_shots = AimShots.new(_model)
	tell_steps(AimAtTexts.sentences(_model, _shots))
	tell_code(AimAtCode.lines(_model, step), AimAtCode.inputs(_model))
	_drawing.show_model(_model, _shots, step)
	_formula.show_model(_model, _shots, step)
	_readout.show_model(_model, step)
