extends Lesson
## The lesson on leading a moving target: where to aim so that bullet and target meet. Where both
## are and how they move at the start is in the scene.

var _model := LeadTargetModel.new()
var _shots: LeadShots
var _formula: LeadTargetFormula
var _clock: FlightClock

@onready var _drawing: LeadTargetDrawing = %Drawing
@onready var _velocity: DraggableVector = %Velocity
@onready var _own: DraggableVector = %Own
@onready var _mark: TargetMark = %Mark
@onready var _one_second: ReachCircle = %OneSecond
@onready var _graph: LeadGraph = %Graph


func start() -> void:
	_model.target = _velocity.tail_point()
	_model.velocity = _velocity.head_point().minus(_velocity.tail_point())
	_model.shooter = _own.tail_point()
	_model.own = _own.head_point().minus(_own.tail_point())
	_model.speed = _one_second.radius
	_model.radius = _mark.radius
	on_drag(_velocity.moved, _velocity.released, _move_target)
	on_drag(_own.moved, _own.released, _move_shooter)
	on_handle(%RadiusHandle as Handle, _drag_radius)
	on_handle(%SpeedHandle as Handle, _drag_speed)
	on_point(MOUSE_BUTTON_LEFT, func(at: Vec2) -> String: return _move_places(_model.shooter, at))
	on_point(MOUSE_BUTTON_RIGHT, func(at: Vec2) -> String: return _move_places(at, _model.target))
	add_child(CardPlace.new(_graph, board, services[&"formula"]))
	_formula = LeadTargetFormula.new(services[&"formula"] as Formula)
	show_in_panel(LeadTargetReadout.new(services[&"readout"] as Readout))
	offer_presets(LeadTargetModel.PRESETS)
	offer_mistakes(LeadTargetMistakes.infos(), LeadTargetTexts.step_of_mistake)
	offer_questions(LeadExercise, LeadExercise.of_the_table)
	var points := func() -> Array[Vec2]:
		return _drawing.points_to_show(_model, LeadShots.new(_model))
	begin(_model, _show, points)
	var end := func() -> float: return _shots.end(step)
	_clock = FlightClock.new(services[&"transport"] as Transport, end, _show_moment)
	about_to_show.connect(_clock.go_to.bind(0.0))
	_graph.moment_pointed.connect(_clock.go_to)
	# The shot at where the target is now, again and again.
	open_with(_clock.repeat)


# What the student does. After each change the shot flies from the beginning.


func _move_target(tail: Vec2, head: Vec2) -> String:
	return _take_moved("target", _model.target, tail, "velocity", _model.velocity, head)


func _move_shooter(tail: Vec2, head: Vec2) -> String:
	return _take_moved("shooter", _model.shooter, tail, "own", _model.own, head)


# What is moved by its tail keeps its velocity.
func _take_moved(
	place: String, before: Vec2, tail: Vec2, moves: String, velocity: Vec2, head: Vec2
) -> String:
	var is_tail := head.distance_to(before.plus(velocity)) == 0.0
	var wanted := velocity if is_tail else head.minus(tail)
	return _model.take({place: [tail.x, tail.y], moves: [wanted.x, wanted.y]})


func _move_places(shooter: Vec2, target: Vec2) -> String:
	var from := board.snapped_to_step(shooter) if shooter != _model.shooter else shooter
	var to := board.snapped_to_step(target) if target != _model.target else target
	return _model.take({"shooter": [from.x, from.y], "target": [to.x, to.y]})


func _drag_radius(knob: Vec2) -> String:
	return _model.take({"radius": _drawing.radius_for(_model, knob)})


func _drag_speed(at: Vec2) -> String:
	var wanted := roundf(at.distance_to(_model.shooter))
	return _model.take({"speed": maxf(wanted, 1.0)})


# What the student sees.


# While the shot flies, nothing else has to be shown anew.
func _show_moment(seconds: float) -> void:
	_model.time = seconds
	_drawing.show_flight(_model, _shots, step)


func _show() -> void:
	ask_choice_before(
		LeadTargetModel.Step.REACH,
		LeadTargetTexts.question_on_reach(),
		LeadTargetTexts.choices(),
		LeadTargetTexts.right_choice.bind(_model)
	)
	ask_before(
		LeadTargetModel.Step.TIME,
		LeadTargetTexts.question_on_place(_model),
		_model.first_meeting,
		func() -> Vec2: return _model.target.copy()
	)
	_shots = LeadShots.new(_model)
	tell_steps(LeadTargetTexts.sentences(_model, _shots))
	tell_code(LeadTargetCode.lines(_model, step), LeadTargetCode.inputs(_model))
	_drawing.show_model(_model, _shots, step)
	_formula.show_model(_model, _shots, step)
