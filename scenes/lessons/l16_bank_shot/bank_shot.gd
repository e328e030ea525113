extends Lesson
## The lesson on bank shots: aim at the mirror image of the target in the wall that is moved by the
## radius. Start, target, radius and walls at the start are in the scene.

## In the opening the target swings so far to both sides, in pixels.
const _SWING := 40.0
# As a share of the height of what is drawn.
const _ROOM_FOR_CARD := 0.5

## How many bounces there have to be at the start.
@export_range(1, 3) var bounces := 1
## The bounciness C at the start.
@export_range(0.05, 1.0, 0.01) var bounciness := 1.0

var _model := BankShotModel.new()
var _formula: BankShotFormula
# Seconds since the shot.
var _seconds := 0.0
var _readout: BankShotReadout
var _choices: BankShotChoices

@onready var _transport: Transport = services.get(&"transport")
@onready var _drawing: BankShotDrawing = %Drawing
@onready var _walls: Array[DraggableVector] = [%Wall1, %Wall2, %Wall3, %Wall4]
@onready var _ball: BallView = %Ball
@onready var _target: TargetMark = %Target


func start() -> void:
	_read_scene()
	_let_drag()
	_formula = BankShotFormula.new(services[&"formula"] as Formula)
	_readout = BankShotReadout.new(services[&"readout"] as Readout)
	_choices = BankShotChoices.new(services[&"options"] as LessonOptions)
	on_edit(_choices.options.chosen, _choose)
	offer_presets(BankShotModel.PRESETS)
	offer_mistakes(BankShotMistakes.infos(), BankShotModel.step_of_mistake)
	offer_questions(BankShotExercise)
	_transport.advanced.connect(_fly)
	about_to_show.connect(_measure)
	begin(_model, _show, _points)
	open_with_swing(_swing.bind(_model.board.target.copy()))


func _read_scene() -> void:
	_model.board.start = _ball.at()
	_model.board.radius = _ball.radius
	_model.board.target = _target.at()
	_model.board.bounces = bounces
	_model.board.bounciness = bounciness
	for wall in _walls:
		if wall.visible:
			_model.board.walls.append(LineSegment.new(wall.tail_point(), wall.head_point()))


func _let_drag() -> void:
	for place in _walls.size():
		var wall := _walls[place]
		on_drag(wall.moved, wall.released, _move_wall.bind(place))
	on_handle(%StartHandle as Handle, _model.move_start)
	on_handle(%TargetHandle as Handle, _model.move_target)
	on_handle(%RadiusHandle as Handle, _model.fit_radius)
	on_handle(%ImageHandle as Handle, _model.fit_bounciness)


# What moves by itself.


# To hundredths, so that the numbers beside it stay short.
func _swing(share: float, first: Vec2) -> void:
	_model.board.target.x = snappedf(first.x + _SWING * share, 0.01)


func _fly(seconds: float) -> void:
	_seconds = _transport.flown(_seconds, seconds, BankShotAnswer.LONGEST)
	_drawing.show_balls(_model, _step(), _seconds)


# What the student does.


func _move_wall(from: Vec2, to: Vec2, place: int) -> String:
	return _model.move_wall(place, from, to)


func _choose(key: String, place: int) -> String:
	return _choices.choose(_model, key, place)


# What the student sees.


# With room below for the card, where it stands on a small board.
func _points() -> Array[Vec2]:
	var found := _model.points_to_show(_step(), board.is_small())
	if board.is_small() and board.size.x >= Board.SMALL and _step() >= BankShotModel.Step.BOUNCE:
		var ys := found.map(func(point: Vec2) -> float: return point.y)
		var lowest: float = ys.max()
		var highest: float = ys.min()
		found.append(Vec2.new(found[0].x, lowest + _ROOM_FOR_CARD * (lowest - highest)))
	return found


# Not during a drag: it would slow it down.
func _measure() -> void:
	_seconds = 0.0
	if _step() == BankShotModel.Step.FIRE:
		_model.answer().measure_bound()
	if _step() >= BankShotModel.Step.BOUNCE:
		_readout.measure(_model)


func _show() -> void:
	ask_choice_before(
		BankShotModel.Step.IMAGE,
		BankShotTexts.question_on_image(),
		BankShotTexts.choices(),
		func() -> int: return 1 if _model.board.bounces == 1 and _model.answer().way.hit else -1
	)
	ask_before(
		BankShotModel.Step.BOUNCE,
		BankShotTexts.question_on_bounce(),
		_model.first_bounce,
		func() -> Vec2: return _model.board.start.lerped(_model.board.target, 0.5)
	)
	tell_steps(BankShotTexts.sentences(_model))
	tell_code(BankShotCode.lines(_model, _step()), BankShotCode.inputs(_model))
	_choices.show_model(_model, _step())
	_transport.visible = _step() == BankShotModel.Step.FIRE
	_drawing.show_model(_model, _step(), _seconds)
	_formula.show_model(_model, _step())
	_readout.show_model(_model, _step())


func _step() -> BankShotModel.Step:
	return step as BankShotModel.Step
