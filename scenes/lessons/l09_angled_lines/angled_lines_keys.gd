class_name AngledLinesKeys
extends Node
## The keys of the lesson on angled lines, those that students know from the course.

## Gravity should point there; zero for none.
signal gravity_pointed(direction: Vec2)
## Another of the usual bouncinesses should be taken.
signal bounciness_wanted
## The preset with this number should be put up.
signal preset_picked(number: int)
## Lost balls should be brought back.
signal fetch_wanted
## Time should go to the next impact (1) or to the one before (-1).
signal impact_wanted(direction: int)
## The line with the focus should be deleted.
signal line_deleted
## Trails should be shown, or hidden if they are shown.
signal trails_switched
## Trails should begin anew.
signal trails_cleared

## The actions for the help line, with what each does in a word: source text. Buttons on the screen
## name the others.
const ACTIONS: Dictionary[StringName, String] = {
	&"lab_gravity_left": "gravity",
	&"lab_gravity_up": "gravity",
	&"lab_gravity_right": "gravity",
	&"lab_gravity_down": "gravity",
	&"lab_gravity_none": "no gravity",
	&"lab_next_bounciness": "bounciness",
	&"lab_toggle_trails": "trails",
	&"lab_clear_trails": "clear trails",
	&"lab_preset_0": "scene",
	&"lab_preset_1": "scene",
	&"lab_preset_2": "scene",
	&"lab_preset_3": "scene",
	&"lab_preset_4": "scene",
	&"lab_preset_5": "scene",
	&"lab_preset_6": "scene",
	&"lab_preset_7": "scene",
	&"lab_preset_8": "scene",
	&"lab_preset_9": "scene",
}

## Actions that a button names: beside the line with the focus, on the timeline, in the panel.
const ON_BUTTONS: Array[StringName] = [
	&"lab_fetch_balls", &"lab_delete_line", &"lab_next_impact", &"lab_previous_impact"
]

## Actions that go on while their key is held.
const HELD: Array[StringName] = [&"lab_next_impact", &"lab_previous_impact"]

const _PRESET := "lab_preset_"
const _IMPACTS: Dictionary[StringName, int] = {&"lab_next_impact": 1, &"lab_previous_impact": -1}
const _DIRECTIONS: Dictionary[StringName, Vector2i] = {
	&"lab_gravity_left": Vector2i.LEFT,
	&"lab_gravity_right": Vector2i.RIGHT,
	&"lab_gravity_up": Vector2i.UP,
	&"lab_gravity_down": Vector2i.DOWN,
	&"lab_gravity_none": Vector2i.ZERO,
}


func _unhandled_input(event: InputEvent) -> void:
	for action: StringName in ACTIONS.keys() + ON_BUTTONS:
		if event.is_action_pressed(action, action in HELD, true):
			act(action)
			get_viewport().set_input_as_handled()
			return


## Does what the key of [param action] does.
func act(action: StringName) -> void:
	if action in _DIRECTIONS:
		gravity_pointed.emit(Vec2.new(_DIRECTIONS[action].x, _DIRECTIONS[action].y))
	elif action.begins_with(_PRESET):
		preset_picked.emit(action.trim_prefix(_PRESET).to_int())
	elif action in _IMPACTS:
		impact_wanted.emit(_IMPACTS[action])
	else:
		_act_alone(action)


# The actions that have a signal of their own.
func _act_alone(action: StringName) -> void:
	match action:
		&"lab_next_bounciness":
			bounciness_wanted.emit()
		&"lab_toggle_trails":
			trails_switched.emit()
		&"lab_clear_trails":
			trails_cleared.emit()
		&"lab_delete_line":
			line_deleted.emit()
		&"lab_fetch_balls":
			fetch_wanted.emit()
