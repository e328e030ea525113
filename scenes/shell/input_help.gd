class_name InputHelp
extends RefCounted
## The help line at the foot of the screen, made from the InputMap: it cannot differ from what the
## keys do.

# A space at which a line does not break.
const _NO_BREAK := "\u00a0"

# Arrow keys by their signs: shorter than their names, and the same in every language.
const _SIGNS: Dictionary[Key, String] = {
	KEY_LEFT: "\u2190", KEY_UP: "\u2191", KEY_RIGHT: "\u2192", KEY_DOWN: "\u2193"
}
## What the mouse does needs no action in the InputMap: source text.
const CLICKS: Dictionary[StringName, String] = {
	&"left_click": "left click", &"right_click": "right click"
}


## `R reset   Esc back`, for the keyboard or, with [param for_joypad], for a gamepad.
## [param purposes] says of each action what it does, in a word, which is translated here. Actions
## that follow each other with the same purpose share one entry: `0…9 scene`.
static func line(purposes: Dictionary[StringName, String], for_joypad: bool) -> String:
	var keys: Dictionary[String, PackedStringArray] = {}
	for action in purposes:
		var key := _first_key(action, for_joypad)
		if key:
			var purpose := purposes[action]
			keys[purpose] = keys.get(purpose, PackedStringArray()) + PackedStringArray([key])
	var parts: PackedStringArray = []
	for purpose in keys:
		var part := "%s %s" % [_together(keys[purpose]), TranslationServer.translate(purpose)]
		parts.append(part.replace(" ", _NO_BREAK))
	return "     ".join(parts)


## The first key of an action, such as `Ctrl+Z`; "" where it has none.
static func key_of(action: StringName) -> String:
	return _first_key(action, false)


static func _together(keys: PackedStringArray) -> String:
	return "".join(keys) if keys.size() <= 4 else "%s…%s" % [keys[0], keys[-1]]


static func _first_key(action: StringName, for_joypad: bool) -> String:
	if CLICKS.has(action):
		return "" if for_joypad else str(TranslationServer.translate(CLICKS[action]))
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
