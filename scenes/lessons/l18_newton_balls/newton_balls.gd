extends Lesson
## The lesson on balls that meet under Newton's laws. Both balls at the start are in the scene:
## their arrows tell place and velocity, the masses are below.

## The keys that this lesson answers to.
const ACTIONS := NewtonBallsKeys.ACTIONS

## The mass of ball 1 at the start, in any unit.
@export_range(0.01, 100.0, 0.01) var first_mass := 1.0
## The mass of ball 2 at the start.
@export_range(0.01, 100.0, 0.01) var second_mass := 2.0

var _model := NewtonBallsModel.new()
var _run: BallRun
# The state of which it is the run.
var _flown: Dictionary = {}
var _formula: NewtonBallsFormula
var _readout: NewtonBallsReadout
var _clock: FlightClock
var _drags: NewtonBallsDrags

@onready var _drawing: NewtonBallsDrawing = %Drawing


func start() -> void:
	_put_start()
	_drags = NewtonBallsDrags.new(self, _model, _drawing)
	_put_card_into_panel()
	_formula = NewtonBallsFormula.new(services[&"formula"] as Formula)
	_readout = NewtonBallsReadout.new(services[&"readout"] as Readout)
	add_switch("has_newton", tr("Newton's laws (key A)"))
	offer_presets(NewtonBallsPresets.all())
	offer_mistakes(NewtonBallsMistakes.infos(), NewtonBallsTexts.step_of_mistake)
	offer_questions(BounceOfBallsExercise, BounceOfBallsExercise.of_the_course)
	on_enter(_enter)
	_follow_keys()
	_fly(_model.run())
	var end := func() -> float: return _run.end
	_clock = FlightClock.new(services[&"transport"] as Transport, end, _show_moment)
	_clock.longest_shown = BallRun.LONGEST
	about_to_show.connect(_prepare)
	begin(_model, _show, _points)
	open_with(_clock.repeat)


# On the board it would cover balls.
func _put_card_into_panel() -> void:
	var card := %MomentaCard as Control
	var formula := services[&"formula"]
	card.reparent(formula.get_parent(), false)
	card.get_parent().move_child(card, formula.get_index() + 1)


func _follow_keys() -> void:
	var keys := NewtonBallsKeys.new()
	add_child(keys)
	var switch := func() -> String: return _model.take({"has_newton": not _model.has_newton})
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


func _enter(name_in_line: String, value: float) -> String:
	var meeting := _run.meeting
	var first := meeting.first if meeting else 0
	var second := meeting.second if meeting else 1
	return _model.enter_of_pair(name_in_line, value, first, second)


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
		_fly(_model.run())
		_clock.go_to(0.0)


func _fly(run: BallRun) -> void:
	_run = run
	_drags.run = run


# While the balls fly, nothing else has to be shown anew.
func _show_moment(seconds: float) -> void:
	_drags.seconds = seconds
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
	_drawing.show_model(_model, _run, _drags.seconds, step)
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
		func() -> Vec2: return _drawing.head_after(_model, meeting) if meeting else null,
		func() -> Vec2: return _drawing.head_before(_model, meeting)
	)
	ask_choice_before(
		NewtonBallsModel.Step.ENERGY,
		NewtonBallsTexts.question_on_energy(),
		NewtonBallsTexts.choices_on_energy(),
		func() -> int: return NewtonBallsTexts.right_about_energy(meeting)
	)
