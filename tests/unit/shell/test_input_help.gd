extends LabTest
## The help line as it is made from the InputMap.

const _ACTION := &"lab_slow"

var _events: Array[InputEvent] = []


func before_each() -> void:
	_events = InputMap.action_get_events(_ACTION)
	InputMap.action_erase_events(_ACTION)


func after_each() -> void:
	InputMap.action_erase_events(_ACTION)
	for event: InputEvent in _events:
		InputMap.action_add_event(_ACTION, event)


func test_the_first_key_is_named_with_its_purpose() -> void:
	_bind_key(KEY_F5)
	_bind_key(KEY_F6)
	assert_eq(_line(false), "F5 slow")


func test_modifiers_are_named() -> void:
	_bind_key(KEY_Z, true)
	assert_eq(_line(false), "Ctrl+Shift+Z slow")


func test_escape_is_written_as_on_the_key() -> void:
	_bind_key(KEY_ESCAPE)
	assert_eq(_line(false), "Esc slow")


func test_a_gamepads_buttons_are_named_as_on_the_pad() -> void:
	var names: Dictionary[JoyButton, String] = {
		JOY_BUTTON_A: "A",
		JOY_BUTTON_B: "B",
		JOY_BUTTON_X: "X",
		JOY_BUTTON_Y: "Y",
		JOY_BUTTON_LEFT_SHOULDER: "LB",
		JOY_BUTTON_RIGHT_SHOULDER: "RB",
		JOY_BUTTON_START: "Start",
		JOY_BUTTON_BACK: "Select",
		JOY_BUTTON_LEFT_STICK: "button 7",
	}
	for button: JoyButton in names:
		InputMap.action_erase_events(_ACTION)
		_bind_button(button)
		assert_eq(_line(true), names[button] + " slow")


func test_an_action_without_a_key_or_button_is_left_out() -> void:
	_bind_button(JOY_BUTTON_A)
	assert_eq(_line(false), "")
	InputMap.action_erase_events(_ACTION)
	_bind_key(KEY_F5)
	assert_eq(_line(true), "")


func test_actions_are_named_in_the_order_given() -> void:
	_bind_key(KEY_F5)
	var purposes: Dictionary[StringName, String] = {&"lab_reset": "reset"}
	purposes.merge({_ACTION: "slow", &"lab_back": "back"})
	var line := InputHelp.line(purposes, false)
	assert_eq(line.replace("\u00a0", " "), "R reset     F5 slow     Esc back")


func test_a_line_breaks_only_between_actions() -> void:
	_bind_key(KEY_F5)
	assert_eq(InputHelp.line({_ACTION: "slow"}, false), "F5\u00a0slow")


func test_keys_with_the_same_purpose_share_an_entry() -> void:
	var purposes: Dictionary[StringName, String] = {&"lab_reset": "begin", &"lab_pause": "begin"}
	assert_eq(InputHelp.line(purposes, false), "RP\u00a0begin")


func test_every_action_that_a_script_announces_is_in_the_project_settings() -> void:
	var announced := 0
	for file: String in SourceCode.files_below("res://scenes", ["gd"]):
		var script: Script = load(file)
		var actions: Dictionary = script.get_script_constant_map().get("ACTIONS", {})
		announced += actions.size()
		for action: StringName in actions:
			var is_known := InputMap.has_action(action) or InputHelp.CLICKS.has(action)
			assert_true(is_known, "%s in %s" % [action, file])
	assert_gt(announced, 0)


func _line(for_joypad: bool) -> String:
	return InputHelp.line({_ACTION: "slow"}, for_joypad).replace("\u00a0", " ")


func _bind_key(key: Key, with_control_and_shift: bool = false) -> void:
	var event := InputEventKey.new()
	event.physical_keycode = key
	event.ctrl_pressed = with_control_and_shift
	event.shift_pressed = with_control_and_shift
	InputMap.action_add_event(_ACTION, event)


func _bind_button(button: JoyButton) -> void:
	var event := InputEventJoypadButton.new()
	event.button_index = button
	InputMap.action_add_event(_ACTION, event)
