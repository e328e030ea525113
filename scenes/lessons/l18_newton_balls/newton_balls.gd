extends Lesson
## The lesson on balls that meet under Newton's laws. Both balls at the start are in the scene:
## their arrows tell place and velocity, the masses are below.

## The keys that this lesson answers to.
const ACTIONS := NewtonBallsKeys.ACTIONS
# In the opening the balls wait so long, in seconds, before they meet again.
const _PAUSE := 0.8

## The mass of ball 1 at the start, in any unit.
@export_range(0.01, 100.0, 0.01) var first_mass := 1.0
## The mass of ball 2 at the start.
@export_range(0.01, 100.0, 0.01) var second_mass := 2.0

var _model := NewtonBallsModel.new()
var _run: BallRun
# The state of which it is the run.
var _flown: Dictionary = {}
var _seconds := 0.0
# The ball that is dragged by its disc, -1 for none, and from the pointer to its centre.
var _held := -1
var _grip := Vec2.new()
var _formula: NewtonBallsFormula
var _readout: NewtonBallsReadout
var _clock: FlightClock

@onready var _drawing: NewtonBallsDrawing = %Drawing


func start() -> void:
	_put_start()
	_let_drag()
	_put_card_into_panel()
	_formula = NewtonBallsFormula.new(services[&"formula"] as Formula)
	_readout = NewtonBallsReadout.new(services[&"readout"] as Readout)
	var options := services[&"options"] as LessonOptions
	options.add_switch("has_newton", tr("Newton's laws (key A)"))
	options.offer_presets(NewtonBallsPresets.all())
	(services[&"mistakes"] as Mistakes).add_all(NewtonBallsMistakes.infos())
	var questions := services[&"question"] as Question
	var kinds := BounceOfBallsExercise.Kind.size()
	questions.offer(BounceOfBallsExercise.fresh, kinds, 0, BounceOfBallsExercise.of_the_course)
	on_enter(_enter)
	on_pick(_take)
	_follow_keys()
	_run = _model.run()
	var end := func() -> float: return _run.end
	_clock = FlightClock.new(services[&"transport"] as Transport, end, _show_moment)
	_clock.longest_shown = BallRun.LONGEST
	about_to_show.connect(_prepare)
	begin(_model, _show, _points)
	open_with(func(seconds: float) -> void: _clock.repeat(seconds, _PAUSE))


# On the board it would cover balls.
func _put_card_into_panel() -> void:
	var card := %MomentaCard as Control
	var formula := services[&"formula"]
	card.reparent(formula.get_parent(), false)
	card.get_parent().move_child(card, formula.get_index() + 1)


func _follow_keys() -> void:
	var keys := NewtonBallsKeys.new()
	add_child(keys)
	var switch := func() -> String: return _take({"has_newton": not _model.has_newton})
	on_edit(keys.newton_wanted, switch)
	on_edit(keys.bounciness_wanted, _model.take_next_bounciness)


func _put_start() -> void:
	_model.balls.clear()
	for number: int in 2:
		var vector := _drawing.vectors()[number]
		var tail := vector.tail_point()
		var velocity := vector.head_point().minus(tail)
		var mass := first_mass if number == 0 else second_mass
		_model.balls.append([tail.x, tail.y, velocity.x, velocity.y, mass])


func _let_drag() -> void:
	for place: int in _drawing.vectors().size():
		var vector := _drawing.vectors()[place]
		on_drag(vector.moved, vector.released, _drag_vector.bind(place))
	for number: int in 2:
		var handle := get_node("%%Mass%d" % (number + 1)) as Handle
		on_drag(handle.moved, handle.released, _drag_mass.bind(number))
	var bounciness := %Bounciness as Handle
	on_drag(bounciness.moved, bounciness.released, _drag_bounciness)
	on_point(MOUSE_BUTTON_LEFT, _drag_disc)
	board.released.connect(func() -> void: _held = -1)


# What the student does. The balls as they fly are the new start.


func _drag_vector(tail: Vec2, head: Vec2, place: int) -> String:
	_stop_balls()
	var index := _drawing.ball_of(place)
	var ball := _model.world_balls()[index]
	if tail.distance_to(ball.position) > 0.0:
		return _model.move_ball(index, tail)
	return _model.set_velocity(index, head.minus(tail))


func _drag_mass(knob: Vec2, number: int) -> String:
	_stop_balls()
	return _model.set_mass(number, _drawing.mass_for(_model.world_balls()[number].position, knob))


func _drag_bounciness(knob: Vec2) -> void:
	_stop_balls()
	_model.bounciness = _drawing.bounciness_for(knob)


# A ball is dragged by any point of its disc.
func _drag_disc(at: Vec2) -> String:
	if _held < 0:
		_held = _ball_at(at)
		if _held < 0:
			return ""
		_grip = _run.balls()[_held].position.minus(at)
	_stop_balls()
	return _model.move_ball(_held, board.snapped_to_step(at.plus(_grip)))


func _ball_at(at: Vec2) -> int:
	var balls := _run.balls()
	for index: int in balls.size():
		if at.distance_to(balls[index].position) <= balls[index].radius:
			return index
	return -1


func _stop_balls() -> void:
	if _seconds > 0.0:
		_model.start_from(_run.balls())
		_seconds = 0.0


func _enter(name_in_line: String, value: float) -> String:
	var meeting := _run.meeting
	var first := meeting.first if meeting else 0
	var second := meeting.second if meeting else 1
	return _model.enter(name_in_line, value, first, second)


func _take(changes: Dictionary) -> String:
	var problem := _model.take(changes)
	if changes.has("mistake") and not problem:
		_model.show_mistake(_model.mistake)
		if _model.mistake != 0 and step < NewtonBallsModel.Step.AFTER:
			(services[&"steps"] as Steps).go_to(NewtonBallsModel.Step.MOMENTUM)
	return problem


# What the student sees.


func _prepare() -> void:
	_fly_anew()
	_drawing.choose_arrows(_model, _run.meeting)
	# Not during a drag: measuring would slow it down.
	_readout.measure(_run.meeting)


# After each change the balls fly from the beginning.
func _fly_anew() -> void:
	var wanted := _model.to_dictionary()
	wanted.erase("mistake")
	if wanted != _flown:
		_flown = wanted
		_run = _model.run()
		_clock.go_to(0.0)


# While the balls fly, nothing else has to be shown anew.
func _show_moment(seconds: float) -> void:
	_seconds = seconds
	_run.go_to(seconds)
	if _run.refusal:
		noticed.emit(_run.refusal)
	_drawing.show_moment(_model, _run, seconds, step)


func _points() -> Array[Vec2]:
	_fly_anew()
	return _drawing.points_to_show(_model, _run.meeting)


func _show() -> void:
	_fly_anew()
	var meeting := _run.meeting
	_ask(meeting)
	tell_steps(NewtonBallsTexts.sentences(_model, meeting))
	tell_code(NewtonBallsCode.lines(meeting, step), NewtonBallsCode.inputs(meeting))
	_drawing.show_model(_model, _run, _seconds, step)
	_formula.show_model(_model, meeting, step)
	_readout.show_model(meeting, step)


func _ask(meeting: BallMeeting) -> void:
	ask_choice_before(
		NewtonBallsModel.Step.CENTER,
		NewtonBallsTexts.question_on_center(),
		NewtonBallsTexts.choices_on_center(),
		func() -> int: return 0 if meeting else -1
	)
	ask_before(
		NewtonBallsModel.Step.AFTER,
		NewtonBallsTexts.question_on_velocity(),
		func() -> Vec2: return _head_after(meeting) if meeting else null,
		func() -> Vec2: return _head_before(meeting)
	)
	ask_choice_before(
		NewtonBallsModel.Step.ENERGY,
		NewtonBallsTexts.question_on_energy(),
		NewtonBallsTexts.choices_on_energy(),
		func() -> int: return NewtonBallsTexts.right_about_energy(meeting)
	)


func _head_before(meeting: BallMeeting) -> Vec2:
	return _head_of(meeting, meeting.one.velocity)


func _head_after(meeting: BallMeeting) -> Vec2:
	return _head_of(meeting, meeting.velocities_after()[0])


# Where a velocity of ball 1 ends, in the picture of the meeting.
func _head_of(meeting: BallMeeting, velocity: Vec2) -> Vec2:
	return meeting.one.position.plus(_drawing.drop(_model, meeting)).plus(velocity)
