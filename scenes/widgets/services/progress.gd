class_name Progress
extends VBoxContainer
## Work that takes a while: how far it is, begin and stop.

## The student wants the work to begin, or to go on.
signal begun
## The student wants the work to stop where it is.
signal stopped

## Actions that this service answers to, with what each does in a word for the help line: source
## text.
const ACTIONS: Dictionary[StringName, String] = {&"lab_pause": "play or pause"}

var _is_running := false

@onready var _bar: ProgressBar = %Bar
@onready var _button: Button = %Button
@onready var _words: Label = %Words


func _ready() -> void:
	_button.pressed.connect(_toggle)
	show_progress(false, 0.0, "")


## Shows whether work is under way, which share of it, 0..1, is done, and [param words] on it,
## translated.
func show_progress(is_running: bool, share: float, words: String) -> void:
	_is_running = is_running
	_button.text = tr("Stop") if is_running else tr("Measure")
	_bar.value = share
	_words.text = words


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"lab_pause"):
		_toggle()


func _toggle() -> void:
	if _is_running:
		stopped.emit()
	else:
		begun.emit()
