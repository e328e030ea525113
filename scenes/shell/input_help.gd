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
	&"lab_copy_link": "copy link",
	&"lab_hide_answers": "hide answers",
	&"lab_motion": "motion",
	&"lab_next_step": "next step",
	&"lab_previous_step": "step back",
	&"lab_next_frame": "next frame",
	&"lab_previous_frame": "frame back",
	&"lab_pause": "play or pause",
	&"lab_slow": "slow",
	&"lab_next_impact": "next impact",
	&"lab_previous_impact": "previous impact",
	&"lab_gravity_left": "gravity",
	&"lab_gravity_up": "gravity",
	&"lab_gravity_right": "gravity",
	&"lab_gravity_down": "gravity",
	&"lab_gravity_none": "no gravity",
	&"lab_next_bounciness": "bounciness",
	&"lab_toggle_trails": "trails",
	&"lab_clear_trails": "clear trails",
	&"lab_fetch_balls": "fetch lost balls",
	&"lab_delete_line": "delete the line",
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
	&"ui_focus_next": "next part",
	&"ui_accept": "press",
}

# A space at which a line does not break.
const _NO_BREAK := "\u00a0"

# Arrow keys by their signs: shorter than their names, and the same in every language.
const _SIGNS: Dictionary[Key, String] = {
	KEY_LEFT: "\u2190", KEY_UP: "\u2191", KEY_RIGHT: "\u2192", KEY_DOWN: "\u2193"
}


## `R reset   Esc back`, for the keyboard or, with [param for_joypad], for a gamepad. Actions that
## follow each other with the same purpose share one entry: `0…9 scene`.
static func line(actions: Array[StringName], for_joypad: bool) -> String:
	var keys: Dictionary[String, PackedStringArray] = {}
	for action in actions:
		var key := _first_key(action, for_joypad)
		if key:
			var purpose := PURPOSES[action]
			keys[purpose] = keys.get(purpose, PackedStringArray()) + PackedStringArray([key])
	var parts: PackedStringArray = []
	for purpose in keys:
		var part := "%s %s" % [_together(keys[purpose]), TranslationServer.translate(purpose)]
		parts.append(part.replace(" ", _NO_BREAK))
	return "     ".join(parts)


static func _together(keys: PackedStringArray) -> String:
	return "".join(keys) if keys.size() <= 4 else "%s…%s" % [keys[0], keys[-1]]


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
	if _SIGNS.has(code):
		return _SIGNS[code]
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
