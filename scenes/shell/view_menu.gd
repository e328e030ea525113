class_name ViewMenu
extends MenuButton
## The menu of the top bar for what is seldom needed: switches and actions, each with its key. An
## entry does what its key does.

## The menu is about to be seen: the time to show what is on.
signal opening

# The first key of an action stands behind its text.
const _WITH_KEY := "%s   %s"

# The texts of the entries, translated, by their input actions, in their order.
var _texts: Dictionary[StringName, String] = {}
# Of the switches among them, whether they are on.
var _is_on: Dictionary[StringName, bool] = {}


func _ready() -> void:
	about_to_popup.connect(_fill)
	get_popup().auto_translate_mode = AUTO_TRANSLATE_MODE_DISABLED
	get_popup().index_pressed.connect(_act)


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"lab_view", false, true):
		show_popup()
		get_popup().set_focused_item(0)
		get_viewport().set_input_as_handled()


## Adds a switch that presses the key of [param action]; [param words] are translated.
func add_switch(action: StringName, words: String) -> void:
	_texts[action] = words
	_is_on[action] = false


## Shows a switch on or off.
func show_switch(action: StringName, on: bool) -> void:
	_is_on[action] = on


## Gives an entry other words, translated.
func rename(action: StringName, words: String) -> void:
	_texts[action] = words


## Whether a switch is shown on.
func is_on(action: StringName) -> bool:
	return _is_on[action]


## Adds an entry that presses the key of [param action]; [param words] are translated.
func add_action(action: StringName, words: String) -> void:
	_texts[action] = words


# The keys as they are now; none where nobody has a keyboard.
func _fill() -> void:
	opening.emit()
	var popup := get_popup()
	popup.clear()
	for action in _texts:
		var key := InputHelp.key_of(action) if Keyboard.is_there else ""
		var words := _WITH_KEY % [_texts[action], key] if key else _texts[action]
		if _is_on.has(action):
			popup.add_check_item(words)
			popup.set_item_checked(popup.item_count - 1, _is_on[action])
		else:
			popup.add_item(words)


# When the menu has closed: until then it takes the input.
func _act(entry: int) -> void:
	_press.call_deferred(_texts.keys()[entry])


func _press(action: StringName) -> void:
	for is_down: bool in [true, false]:
		var event := InputEventAction.new()
		event.action = action
		event.pressed = is_down
		get_window().push_input(event)
