class_name NumberField
extends LineEdit
## A number that can be typed over. What is not a number is refused with a sentence; the old value
## stays. While the field has the focus, it shows all digits of a long number.

## Enter was pressed, or the field left, with a new number in it.
signal number_entered(value: float)
## What was typed cannot be taken; [param message] says why. "" once it can.
signal refused(message: String)

## Large enough for a finger, and for the numbers that run through it while a lesson plays.
const SMALLEST := Vector2(62.0, 44.0)

# So many digits can be read while they run.
const _RUNNING_DIGITS := 3

## While numbers run, a field shows few digits of its own, and one that has grown stays as large:
## what is beside it does not move.
static var keeps_room := false

var _value := 0.0
var _short_text := ""
var _refused_text := ""


func _ready() -> void:
	custom_minimum_size = SMALLEST
	expand_to_text_length = true
	select_all_on_focus = true
	add_theme_constant_override(&"minimum_character_width", 1)
	focus_entered.connect(_show_all_digits)
	text_submitted.connect(_enter)
	focus_exited.connect(_leave)


## Shows [param value], written as [param short_text] until the field gets the focus. What the
## student is just typing here stays until the value changes.
func show_number(value: float, short_text: String) -> void:
	if has_focus() and value == _value:
		return
	_value = value
	_short_text = short_text.replace(NumberText.MINUS, "-")
	text = NumberText.typed(value) if has_focus() else _short_text
	if keeps_room and not has_focus():
		text = NumberText.short(value, _RUNNING_DIGITS).replace(NumberText.MINUS, "-")
	custom_minimum_size.x = maxf(SMALLEST.x, size.x) if keeps_room else SMALLEST.x


# The engine selects all before this is called.
func _show_all_digits() -> void:
	text = NumberText.typed(_value)
	select_all.call_deferred()


func _enter(typed: String) -> void:
	if typed == NumberText.typed(_value):
		return
	var problem := NumberText.problem(typed)
	refused.emit(problem)
	if problem:
		_refused_text = typed
		return
	_value = NumberText.parse(typed)
	_short_text = typed
	number_entered.emit(_value)


# Refused text stays while the field has the focus, so that the student can correct it.
func _leave() -> void:
	if text == _refused_text:
		text = NumberText.typed(_value)
	_refused_text = ""
	_enter(text)
	if text == NumberText.typed(_value):
		text = _short_text


func _gui_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"ui_cancel"):
		text = NumberText.typed(_value)
		refused.emit("")
		release_focus()
		accept_event()
