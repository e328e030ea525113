extends Lesson
## The lesson on aiming at a target: a barrel on a hull that turns. Where both stand and where the
## target is at the start is in the scene.

# In the opening the hull swings so far to both sides, in degrees.
const _SWING := 40.0

var _model := AimAtModel.new()
var _shots: AimShots
var _formula: AimAtFormula
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
	on_handle(%HullHandle as Handle, _move_hull)
	on_handle(%FrontHandle as Handle, _turn_hull)
	on_handle(%BarrelHandle as Handle, _turn_barrel)
	on_handle(%TargetHandle as Handle, _move_target)
	on_point(MOUSE_BUTTON_LEFT, func(at: Vec2) -> String: return _move_target(_snapped(at)))
	on_point(MOUSE_BUTTON_RIGHT, func(at: Vec2) -> String: return _move_hull(_snapped(at)))
	_formula = AimAtFormula.new(services[&"formula"] as Formula)
	show_in_panel(AimAtReadout.new(services[&"readout"] as Readout))
	offer_presets(AimAtModel.PRESETS)
	offer_mistakes(AimAtMistakes.infos(), AimAtTexts.step_of_mistake)
	offer_questions(AimExercise, AimExercise.of_the_table)
	var points := func() -> Array[Vec2]:
		return _drawing.points_to_show(_model, AimShots.new(_model))
	begin(_model, _show, points)
	var end := func() -> float: return _shots.end(step)
	_clock = FlightClock.new(services[&"transport"] as Transport, end, _show_moment)
	about_to_show.connect(_clock.go_to.bind(0.0))
	open_with_swing(_swing.bind(_model.hull_degrees))


# What moves by itself: the hull swings, and the barrel with it. To hundredths, so that the numbers
# beside it stay short.
func _swing(share: float, first: float) -> void:
	_model.hull_degrees = AimAtModel.short(snappedf(first + _SWING * share, 0.01))


# What the student does. After each change the shot flies from the beginning.


func _move_hull(to: Vec2) -> String:
	return _model.take({"hull": [to.x, to.y]})


func _turn_hull(to: Vec2) -> String:
	var way := to.minus(_model.hull)
	return _model.take({"hull_degrees": AimAtModel.short(roundf(way.angle_degrees()))})


func _turn_barrel(to: Vec2) -> String:
	return _model.take({"barrel_degrees": _own_degrees_at(to)})


# How far a barrel that points at a place is turned on the hull, to whole degrees.
func _own_degrees_at(place: Vec2) -> float:
	var degrees := place.minus(_model.hull).angle_degrees() - _model.hull_degrees
	return AimAtModel.short(roundf(degrees))


func _move_target(to: Vec2) -> String:
	return _model.take({"target": [to.x, to.y]})


func _snapped(at: Vec2) -> Vec2:
	return board.snapped_to_step(at)


# What the student sees.


# While the barrel turns and the shot flies, nothing else has to be shown anew.
func _show_moment(seconds: float) -> void:
	_model.time = seconds
	_drawing.show_flight(_model, _shots, step)


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
