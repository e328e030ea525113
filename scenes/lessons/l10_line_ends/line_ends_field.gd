class_name LineEndsField
extends VBoxContainer
## One of the five fields: a board of its own with one kind of line, the shot at it, and in words
## what happens there.

## The student moves the shot: the ball's centre is to be at the tail, its motion ends at the head.
signal shot_moved(tail: Vec2, head: Vec2)
## The student moves the line.
signal line_moved(from: Vec2, to: Vec2)
## A drag or nudge has ended.
signal released

## The kind of line in this field.
@export var kind := LineEndsModel.Field.ROUND_CAPS
## Handles answer to the keyboard here. One field is enough: the shot is the same in all.
@export var has_keyboard := false

var _outline: Array[Vec2] = []
var _tail := Vec2.new()
var _head := Vec2.new()

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
	_title.text = LineEndsWords.title(kind)
	_shot.moved.connect(shot_moved.emit)
	_line.moved.connect(line_moved.emit)
	_shot.released.connect(released.emit)
	_line.released.connect(released.emit)
	_board.pointed.connect(_point)
	_board.released.connect(released.emit)
	_board.resized.connect(func() -> void: _board.fit(_outline))
	if not has_keyboard:
		_leave_keyboard()


## Chooses the scale so that the whole shot of [param model] is seen.
func fit(model: LineEndsModel) -> void:
	_outline = model.outline(kind)
	if kind == LineEndsModel.Field.ROUND_CAPS:
		_outline.append_array(LineEndsMistakes.outline(model))
	_board.fit(_outline)


## Keeps room for so many lines of words below the board.
func reserve_lines(count: int) -> void:
	_words.custom_minimum_size.y = _words.get_line_height() * count


## Shows [param model] in this field, beside the flight [param wrong] of a mistake; null for none.
func show_model(model: LineEndsModel, wrong: BallFlight) -> void:
	_tail = model.start.copy()
	_head = model.new_position()
	var flight := model.flight_in(kind)
	_wall.show_model(model, kind)
	_line.lay(model.segment.start, model.segment.end)
	_shot.lay(_tail, _head)
	_flight.show_flight(flight, model.fraction)
	_start_ball.lay(model.start, model.radius)
	_ball.lay(flight.position_at(model.fraction), model.radius)
	_impact_ball.visible = flight.impact.hit
	if flight.impact.hit:
		_impact_ball.lay(flight.impact.position, model.radius)
	_show_wrong(model, wrong)
	_words.text = LineEndsWords.sentence(model, kind)
	if wrong:
		_words.text += "\n" + LineEndsWords.wrong_sentence(model, wrong)


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


# The left button aims the shot, the right one puts the ball elsewhere without turning the shot.
func _point(at: Vec2, button: MouseButton) -> void:
	var target := _board.snapped_to_step(at)
	if button == MOUSE_BUTTON_LEFT:
		shot_moved.emit(_tail, target)
	else:
		shot_moved.emit(target, target.plus(_head.minus(_tail)))
