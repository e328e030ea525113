class_name WorkshopScreen
extends PanelContainer
## The base of the workshop's own screens: a bar with a way back and a title, what a screen shows
## below it, and a line of help. A way back is offered only where something listens.

## The student wants to leave.
signal left

## A window of less height has no room for a line of help.
const LOW := 500.0

# Only where there is a way back: source text.
const _WAY_BACK: Dictionary[StringName, String] = {&"lab_back": "back"}
# What the keys do in a word: source text.
const _KEYS: Dictionary[StringName, String] = {&"ui_focus_next": "next part", &"ui_accept": "open"}

var _purposes: Dictionary[StringName, String] = _KEYS.duplicate()
var _is_told := not DisplayServer.is_touchscreen_available()

@onready var _help: Label = %Help
@onready var _back: Button = %Back


func _ready() -> void:
	ViewOptions.begin(self).language_changed.connect(_say_again)
	_back.visible = left.has_connections()
	_back.pressed.connect(left.emit)
	if _back.visible:
		_purposes = _WAY_BACK.merged(_purposes)
		_back.grab_focus()
	_purposes.merge(OwnCode.ACTIONS)
	resized.connect(_show_help)
	_tell_keys(false)
	PageText.tell_page(self, [self])
	PageFocus.tell_page(self)


# Whoever uses a finger has no keys to be told of, until one is pressed.
func _input(event: InputEvent) -> void:
	if event is InputEventScreenTouch:
		_is_told = false
		_show_help()
	elif event is InputEventKey or event is InputEventJoypadButton:
		_is_told = true
		_tell_keys(event is InputEventJoypadButton)


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"lab_back"):
		get_viewport().set_input_as_handled()
		left.emit()
	elif event.is_action_pressed(&"lab_check_code", false, true):
		WorkshopLabWatcher.of(get_tree()).check_now()


# In the language that is spoken now. What is in the scene, the engine says anew by itself.
func _say_again() -> void:
	_tell_keys(false)


func _tell_keys(for_joypad: bool) -> void:
	_help.text = InputHelp.line(_purposes, for_joypad)
	_show_help()


func _show_help() -> void:
	_help.visible = _is_told and size.y >= LOW
