class_name Student
extends RefCounted
## A student at the lab: acts by real input events only, as mouse, keyboard, gamepad and finger send
## them, and reads what is visible.
##
## Places are given in pixels of the drawing, as [method Control.get_global_rect] has them; events
## carry pixels of the window.

## Frames after which layout, deferred calls and changes of scene are done.
const _FRAMES_TO_SETTLE := 3
const _STEPS_OF_A_DRAG := 4

## The window that the student sits at.
var window: Window

var _buttons_down := 0


func _init(its_window: Window) -> void:
	window = its_window


## Waits until the screen shows what was done.
func settle() -> void:
	for frame: int in _FRAMES_TO_SETTLE:
		await window.get_tree().process_frame


## Scrolls a control into view and clicks on its middle.
func click(control: Control, button: MouseButton = MOUSE_BUTTON_LEFT) -> void:
	await scroll_to(control)
	await click_at(control.get_global_rect().get_center(), button)


func click_at(place: Vector2, button: MouseButton = MOUSE_BUTTON_LEFT) -> void:
	move_to(place)
	hold(place, button)
	release(place, button)
	await settle()


## Presses at [param from], moves to [param to] and lets go there.
func drag(from: Vector2, to: Vector2, with_shift: bool = false) -> void:
	move_to(from)
	hold(from)
	for step: int in _STEPS_OF_A_DRAG:
		move_to(from.lerp(to, (step + 1.0) / _STEPS_OF_A_DRAG), with_shift)
	release(to)
	await settle()


func move_to(place: Vector2, with_shift: bool = false) -> void:
	var motion := InputEventMouseMotion.new()
	motion.position = _window_pixel(place)
	motion.button_mask = _buttons_down as MouseButtonMask
	motion.shift_pressed = with_shift
	_send(motion)


func hold(place: Vector2, button: MouseButton = MOUSE_BUTTON_LEFT) -> void:
	_buttons_down = 1 << (button - 1)
	_send_button(place, button, true)


func release(place: Vector2, button: MouseButton = MOUSE_BUTTON_LEFT) -> void:
	_buttons_down = 0
	_send_button(place, button, false)


## Releases all buttons where the window does not see it.
func release_unseen() -> void:
	_buttons_down = 0


## Touches with one finger and lifts it.
func touch(place: Vector2) -> void:
	for is_down: bool in [true, false]:
		put_finger(0, place, is_down)
	await settle()


## Puts a finger down, counted from 0, or lifts it.
func put_finger(index: int, place: Vector2, is_down: bool) -> void:
	var event := InputEventScreenTouch.new()
	event.index = index
	event.position = _window_pixel(place)
	event.pressed = is_down
	_send(event)


## Moves a finger that is down.
func slide_finger(index: int, place: Vector2) -> void:
	var event := InputEventScreenDrag.new()
	event.index = index
	event.position = _window_pixel(place)
	_send(event)


## Presses the first key that the InputMap has for an action.
func press(action: StringName) -> void:
	for event: InputEvent in InputMap.action_get_events(action):
		var bound := event as InputEventKey
		if bound:
			var key := bound.keycode if bound.keycode else bound.physical_keycode
			var has_control := bound.ctrl_pressed or bound.command_or_control_autoremap
			await press_key(key, bound.shift_pressed, has_control)
			return


func press_key(key: Key, with_shift: bool = false, with_control: bool = false) -> void:
	_send_key(key, 0, with_shift, with_control)
	await settle()


## Types into what has the focus, key by key; letters come with their real keys.
func type_text(text: String) -> void:
	for character: String in text:
		var key := OS.find_keycode_from_string(character.to_upper())
		_send_key(key, character.unicode_at(0), false, false)
	await settle()


## Types over all that is in a field, and presses Enter.
func enter(field: LineEdit, text: String) -> void:
	await click(field)
	await press_key(KEY_A, false, true)
	await type_text(text)
	await press_key(KEY_ENTER)


func press_pad(button: JoyButton) -> void:
	for is_down: bool in [true, false]:
		var event := InputEventJoypadButton.new()
		event.button_index = button
		event.pressed = is_down
		_send(event)
	await settle()


## Scrolls until a control that lies in something scrollable is in view.
func scroll_to(control: Control) -> void:
	var above := control.get_parent()
	while above:
		if above is ScrollContainer:
			(above as ScrollContainer).ensure_control_visible(control)
		above = above.get_parent()
	await settle()


func _send_key(key: Key, unicode: int, with_shift: bool, with_control: bool) -> void:
	for is_down: bool in [true, false]:
		var event := InputEventKey.new()
		event.keycode = key
		event.physical_keycode = key
		event.unicode = unicode if is_down else 0
		event.shift_pressed = with_shift
		event.ctrl_pressed = with_control
		event.pressed = is_down
		_send(event)


func _send_button(place: Vector2, button: MouseButton, is_down: bool) -> void:
	var event := InputEventMouseButton.new()
	event.position = _window_pixel(place)
	event.button_index = button
	event.button_mask = _buttons_down as MouseButtonMask
	event.pressed = is_down
	_send(event)


func _send(event: InputEvent) -> void:
	Input.parse_input_event(event)
	Input.flush_buffered_events()


func _window_pixel(place: Vector2) -> Vector2:
	return window.get_final_transform() * place
