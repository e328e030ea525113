extends Lesson
## The game: turn the barrel by hand or let helpers turn it, fire, and go on to the next level.

## What a key does, in a word for the help line: source text.
const ACTIONS: Dictionary[StringName, String] = {&"left_click": "turn", &"ui_accept": "fire"}

## In the opening the barrel swings so far to both sides, in degrees, and so often in 20 seconds.
const _SWING := 25.0
const _SWINGS := 5.0
# In the panel the news have so many lines, the most that they need on a phone.
const _NEWS_LINES := 3

var _model := AimingGameModel.new()
var _card_place: CardPlace

@onready var _options: LessonOptions = services.get(&"options")
@onready var _drawing: AimingGameDrawing = %Drawing
@onready var _sight: Handle = %Sight
@onready var _above: Control = %Above
@onready var _below: Control = %Below
@onready var _button: Button = %Fire
@onready var _task: Label = %Task
@onready var _score: Label = %Score
@onready var _news: Label = %News


func start() -> void:
	_options.add_switch("aims", tr("Aim"))
	_options.add_switch("leads", tr("Lead"))
	_options.add_switch("falls", tr("Gravity"))
	_options.add_switch("bounces", tr("Bounce"))
	for number in range(1, _model.level_count() + 1):
		_options.add_preset(str(number), str(number))
	on_edit(_options.preset_picked, _pick_level)
	on_drag(_sight.moved, _sight.released, _model.aim_at)
	on_point(MOUSE_BUTTON_LEFT, _model.aim_at)
	on_pick(_model.take)
	_button.pressed.connect(_press)
	_card_place = CardPlace.new(_below, board, _options)
	add_child(_card_place)
	_card_place.changed.connect(_keep_free)
	board.resized.connect(_keep_free)
	begin(_model, _show, _corners)
	_keep_free()
	if Keyboard.is_there:
		_sight.grab_focus()
	open_with(_swing.bind(_model.hand_degrees))


func _process(delta: float) -> void:
	_model.advance(delta)
	_drawing.show_moment(_model)
	_tell()


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"ui_accept"):
		_press()


# What moves by itself: the barrel swings until somebody does anything.
func _swing(seconds: float, first: float) -> void:
	var share := sin(TAU * _SWINGS * seconds / OpeningMotion.LONGEST)
	_model.turn_to(roundf(first + _SWING * share))


# What the student does.


func _pick_level(number: String) -> String:
	return _model.take({"level": number.to_int()})


# The large button fires; after a hit it goes on.
func _press() -> void:
	if not _model.is_won():
		_model.fire()
		return
	_model.go_on()
	finish_edit()


# What the student sees.


func _show() -> void:
	_drawing.show_model(_model)
	_tell()


func _tell() -> void:
	_write(_task, _model.level().task)
	_write(_score, AimingGameTexts.score(_model))
	_write(_news, AimingGameTexts.news(_model))
	_button.text = AimingGameTexts.button(_model)
	_button.disabled = _model.shot != null


func _write(label: Label, words: String) -> void:
	if label.text != words:
		label.text = words


func _corners() -> Array[Vec2]:
	return [Vec2.zero(), Vec2.new(GameLevel.FIELD_SIZE[0], GameLevel.FIELD_SIZE[1])]


# The strips above and below the field. On a phone the lower one is the first part of the panel, and
# keeps its height: whoever is about to touch a switch below it must not touch another one.
func _keep_free() -> void:
	var is_in_panel := _below.get_parent() != board
	if is_in_panel:
		_below.get_parent().move_child(_below, 0)
	var spacing := _news.get_theme_constant(&"line_spacing")
	var high := _NEWS_LINES * (_news.get_line_height() + spacing) - spacing
	_news.custom_minimum_size.y = high if is_in_panel else 0
	board.keep_free(_above.size.y, 0.0 if is_in_panel else _below.size.y)
