class_name AngledLinesKeys
extends Node
## The keys of the lesson on angled lines, those that students know from the course.

## The student pressed the key of this action.
signal pressed(action: StringName)

## Those for the help line; a button on the screen names the others.
const ACTIONS: Array[StringName] = [
	&"lab_step",
	&"lab_step_back",
	&"lab_gravity_left",
	&"lab_gravity_up",
	&"lab_gravity_right",
	&"lab_gravity_down",
	&"lab_gravity_none",
	&"lab_next_bounciness",
	&"lab_toggle_trails",
	&"lab_clear_trails",
	&"lab_preset_0",
	&"lab_preset_1",
	&"lab_preset_2",
	&"lab_preset_3",
	&"lab_preset_4",
	&"lab_preset_5",
	&"lab_preset_6",
	&"lab_preset_7",
	&"lab_preset_8",
	&"lab_preset_9",
]

## Keys that a button names: of the line with the focus, and in the panel.
const ON_BUTTONS: Array[StringName] = [&"lab_fetch_balls", &"lab_delete_line"]

## These go on while the key is held.
const HELD: Array[StringName] = [&"lab_step", &"lab_step_back"]

const _PRESET := "lab_preset_"
const _DIRECTIONS: Dictionary[StringName, Vector2i] = {
	&"lab_gravity_left": Vector2i.LEFT,
	&"lab_gravity_right": Vector2i.RIGHT,
	&"lab_gravity_up": Vector2i.UP,
	&"lab_gravity_down": Vector2i.DOWN,
	&"lab_gravity_none": Vector2i.ZERO,
}


## Whether the action gives gravity a direction.
static func is_gravity(action: StringName) -> bool:
	return action in _DIRECTIONS


## The direction that it gives; zero for none.
static func direction(action: StringName) -> Vec2:
	return Vec2.new(_DIRECTIONS[action].x, _DIRECTIONS[action].y)


## The number of the situation that the action puts up; -1 for another action.
static func preset(action: StringName) -> int:
	return action.trim_prefix(_PRESET).to_int() if action.begins_with(_PRESET) else -1


func _unhandled_input(event: InputEvent) -> void:
	for action: StringName in ACTIONS + ON_BUTTONS:
		if event.is_action_pressed(action, action in HELD, true):
			pressed.emit(action)
			get_viewport().set_input_as_handled()
			return


# A button that was clicked keeps the focus, and would take Space and the arrows from the lesson.
func _input(event: InputEvent) -> void:
	var click := event as InputEventMouseButton
	if click and not click.pressed:
		_release_button.call_deferred()


func _release_button() -> void:
	if get_viewport().gui_get_focus_owner() is BaseButton:
		get_viewport().gui_release_focus()
