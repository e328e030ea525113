@tool
class_name LineEndsField
extends VBoxContainer
## One of the five fields: a board with one kind of line, the shot at it, and a sentence on what
## happens there.

## The student moves the shot: the ball's centre should be at the tail, its motion end at the head.
signal shot_moved(tail: Vec2, head: Vec2)
## A drag or nudge of the shot has ended.
signal shot_released
## The student moves the line.
signal line_moved(from: Vec2, to: Vec2)
## A drag or nudge of the line has ended.
signal line_released

## The kind of line in this field.
@export var kind := LineEndsModel.Field.ROUND_CAPS
## Whether the handles take the keyboard's focus. One field is enough: all show the same shot.
@export var has_keyboard := false

var _outline: Array[Vec2] = []

@onready var _title: Label = %Title
@onready var _words: Label = %Words
@onready var _board: Board = %Board
@onready var _wall: LineEndsWall = %Wall
@onready var _line: DraggableVector = %Line
@onready var _flight: FlightLine = %Flight
@onready var _wrong_flight: FlightLine = %WrongFlight
@onready var _shot: DraggableVector = %Shot
@onready var _start_ball: BallView = %StartBall
@onready var _impact_ball: BallView = %ImpactBall
@onready var _wrong_impact_ball: BallView = %WrongImpactBall
@onready var _wrong_ball: BallView = %WrongBall
@onready var _ball: BallView = %Ball


func _ready() -> void:
	_shot.moved.connect(shot_moved.emit)
	_shot.released.connect(shot_released.emit)
	_line.moved.connect(line_moved.emit)
	_line.released.connect(line_released.emit)
	_board.pointed.connect(_point)
	_board.released.connect(shot_released.emit)
	_board.resized.connect(func() -> void: _board.fit(_outline))
	# The editor would save what that changes.
	if not has_keyboard and not Engine.is_editor_hint():
		_leave_keyboard()


## Puts the shot and the line that the scene has at the start into [param model].
func put_start(model: LineEndsModel) -> void:
	model.radius = _start_ball.radius
	model.start = _shot.tail_point()
	model.motion = _shot.head_point().minus(model.start)
	model.segment = LineSegment.new(_line.tail_point(), _line.head_point())


## Chooses the scale so that the whole shot of [param model] is seen.
func fit(model: LineEndsModel) -> void:
	_outline = model.outline(kind)
	if kind == LineEndsModel.Field.ROUND_CAPS:
		_outline.append_array(LineEndsMistakes.outline(model))
	_board.fit(_outline)


## Keeps room for this many lines of words below the board.
func reserve_lines(count: int) -> void:
	_words.custom_minimum_size.y = _words.get_line_height() * count


## Shows the name of the motion, or leaves it out: a small field has no room for it.
func show_name(on: bool) -> void:
	_shot.show_label(on)


## Shows [param model] in this field as far as [param step] has got, counted from 0, and the flight
## [param wrong] of a mistake; null for none.
func show_model(model: LineEndsModel, wrong: BallFlight, step: int) -> void:
	var flight := model.flight_in(kind)
	# The student is asked for the normal first.
	var is_on_end := kind == LineEndsModel.Field.ROUND_CAPS and model.bounces_on_the_end()
	flight.stops_at_touch = is_on_end and step < LineEndsTexts.Step.BOUNCE
	_wall.show_model(model, kind)
	_line.lay(model.segment.start, model.segment.end)
	_shot.lay(model.start, model.new_position())
	_flight.show_flight(flight, model.fraction)
	_start_ball.lay(model.start, model.radius)
	_ball.lay(flight.position_at(model.fraction), model.radius)
	_impact_ball.visible = flight.impact.hit
	if flight.impact.hit:
		_impact_ball.lay(flight.impact.position, model.radius)
	_show_wrong(model, wrong)
	_title.text = LineEndsTexts.title(kind)
	_words.text = LineEndsTexts.event_in(kind, model, step)
	if wrong:
		_words.text += "\n" + LineEndsTexts.wrong_event(model, wrong)


func _leave_keyboard() -> void:
	for handle in _board.handles():
		handle.focus_mode = Control.FOCUS_NONE
	_board.focus_mode = Control.FOCUS_CLICK


func _show_wrong(model: LineEndsModel, wrong: BallFlight) -> void:
	var is_seen := wrong != null and wrong.is_finite()
	_wrong_flight.visible = is_seen
	_wrong_ball.visible = is_seen
	_wrong_impact_ball.visible = is_seen and wrong.impact.hit
	if _wrong_impact_ball.visible:
		_wrong_impact_ball.lay(wrong.impact.position, model.radius)
	if is_seen:
		_wrong_flight.show_flight(wrong, model.fraction)
		_wrong_ball.lay(wrong.position_at(model.fraction), model.radius)


# The left button aims the shot. The right one moves the ball; the motion stays the same.
func _point(at: Vec2, button: MouseButton) -> void:
	var target := _board.snapped_to_step(at)
	var tail := _shot.tail_point()
	if button == MOUSE_BUTTON_LEFT:
		shot_moved.emit(tail, target)
	else:
		shot_moved.emit(target, target.plus(_shot.head_point().minus(tail)))
