class_name InputHelp
extends RefCounted
## The help line at the foot of the screen, made from the InputMap: it cannot differ from what the
## keys do.

## What an action does, in a word: source text, translated where it is shown.
const PURPOSES: Dictionary[StringName, String] = {
	&"lab_back": "back",
	&"lab_reset": "reset",
	&"lab_undo": "undo",
	&"lab_redo": "redo",
	&"lab_step": "step",
	&"lab_step_back": "step back",
	&"lab_pause": "play or pause",
	&"lab_slow": "slow",
	&"ui_focus_next": "next part",
	&"ui_accept": "press",
}

# A space at which a line does not break.
const _NO_BREAK := "\u00a0"


## `R reset   Esc back`, for the keyboard or, with [param for_joypad], for a gamepad.
static func line(actions: Array[StringName], for_joypad: bool) -> String:
	var parts: PackedStringArray = []
	for action in actions:
		var key := _first_key(action, for_joypad)
		if key:
			var part := "%s %s" % [key, TranslationServer.translate(PURPOSES[action])]
			parts.append(part.replace(" ", _NO_BREAK))
	return "     ".join(parts)


static func _first_key(action: StringName, for_joypad: bool) -> String:
	for event in InputMap.action_get_events(action):
		if for_joypad and event is InputEventJoypadButton:
			return _button_name((event as InputEventJoypadButton).button_index)
		if not for_joypad and event is InputEventKey:
			return _key_name(event as InputEventKey)
	return ""


static func _key_name(event: InputEventKey) -> String:
	var code := event.get_physical_keycode_with_modifiers()
	if not event.physical_keycode:
		code = event.get_keycode_with_modifiers()
	return OS.get_keycode_string(code).replace("Escape", "Esc")


static func _button_name(button: JoyButton) -> String:
	match button:
		JOY_BUTTON_A:
			return "A"
		JOY_BUTTON_B:
			return "B"
		JOY_BUTTON_X:
			return "X"
		JOY_BUTTON_Y:
			return "Y"
		JOY_BUTTON_LEFT_SHOULDER:
			return "LB"
		JOY_BUTTON_RIGHT_SHOULDER:
			return "RB"
		JOY_BUTTON_START:
			return "Start"
		JOY_BUTTON_BACK:
			return "Select"
	return TranslationServer.translate("button %d") % button
