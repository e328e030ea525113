class_name Transport
extends HBoxContainer
## Play, pause, one frame on or back, slow: drives what moves in a lesson. Starts paused.

## Time has passed in the lesson: this many seconds, negative for a step back.
signal advanced(seconds: float)
## Time stands still after it has run, or after a single step.
signal halted

## Actions that this service answers to, with what each does in a word for the help line: source
## text.
const ACTIONS: Dictionary[StringName, String] = {
	&"lab_pause": "play or pause",
	&"lab_slow": "slow",
	&"lab_next_frame": "next frame",
	&"lab_previous_frame": "frame back",
}
## A single step lasts a sixtieth of a second, as a frame of the course does.
const STEP_SECONDS := 1.0 / 60.0
## Slow motion runs at this share of real time.
const SLOW_SHARE := 0.2

## What the button shows while time runs: a press pauses it.
@export var pause_sign: Texture2D

## Time runs by itself.
var is_playing: bool:
	get:
		return _play.button_pressed
	set(value):
		_play.button_pressed = value

# A flight has come to its end.
var _is_at_end := false

@onready var _play: Button = %Play
@onready var _slow: Button = %Slow
@onready var _play_sign := _play.icon


## While [signal advanced] is emitted: the time of a flight [param seconds] after [param time], from
## [param begin] to [param end]. Time stops when the end was shown, and Play begins the flight anew.
func flown(time: float, seconds: float, end: float, begin: float = 0.0) -> float:
	var from := begin if is_playing and time >= end else time
	var now := clampf(from + seconds, begin, end)
	_is_at_end = now == end
	return now


func _ready() -> void:
	(%StepBack as Button).pressed.connect(_step.bind(-STEP_SECONDS))
	(%Step as Button).pressed.connect(_step.bind(STEP_SECONDS))
	_play.toggled.connect(_run)
	tree_exiting.connect(func() -> void: NumberField.keeps_room = false)
	set_process(false)


func _process(delta: float) -> void:
	_is_at_end = false
	advanced.emit(delta * (SLOW_SHARE if _slow.button_pressed else 1.0))
	# What listens has shown the end by now: undo keeps it.
	if _is_at_end:
		is_playing = false


func _unhandled_input(event: InputEvent) -> void:
	# What a lesson does not show yet answers to no key.
	if not visible:
		return
	if event.is_action_pressed(&"lab_pause"):
		_play.button_pressed = not _play.button_pressed
	elif event.is_action_pressed(&"lab_slow"):
		_slow.button_pressed = not _slow.button_pressed
	elif event.is_action_pressed(&"lab_next_frame", true, true):
		_step(STEP_SECONDS)
	elif event.is_action_pressed(&"lab_previous_frame", true, true):
		_step(-STEP_SECONDS)


func _run(is_playing_now: bool) -> void:
	set_process(is_playing_now)
	NumberField.keeps_room = is_playing_now
	get_tree().call_group(FormulaLine.LINES, &"queue_sort")
	_play.icon = pause_sign if is_playing_now else _play_sign
	if not is_playing_now:
		halted.emit()


func _step(seconds: float) -> void:
	_play.button_pressed = false
	advanced.emit(seconds)
	halted.emit()
