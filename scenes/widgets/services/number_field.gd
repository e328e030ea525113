class_name NumberField
extends LineEdit
## A number that can be typed over. What is not a number is refused with a sentence; the old value
## stays.

## Enter was pressed, or the field left, with a new number in it.
signal number_entered(value: float)
## What was typed cannot be taken; [param message] says why. "" once it can.
signal refused(message: String)

var _value := 0.0
var _refused_text := ""


func _ready() -> void:
	expand_to_text_length = true
	select_all_on_focus = true
	add_theme_constant_override(&"minimum_character_width", 1)
	text_submitted.connect(_enter)
	focus_exited.connect(_leave)


## Shows [param value]. What the student is just typing here stays until the value changes.
func show_number(value: float) -> void:
	if has_focus() and value == _value:
		return
	_value = value
	text = NumberText.typed(value)


func _enter(typed: String) -> void:
	if typed == NumberText.typed(_value):
		return
	var problem := NumberText.problem(typed)
	refused.emit(problem)
	if problem:
		_refused_text = typed
		return
	_value = NumberText.parse(typed)
	number_entered.emit(_value)


# Refused text stays while the field has the focus, so that the student can correct it.
func _leave() -> void:
	if text == _refused_text:
		text = NumberText.typed(_value)
	_refused_text = ""
	_enter(text)


func _gui_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"ui_cancel"):
		text = NumberText.typed(_value)
		refused.emit("")
		release_focus()
		accept_event()
