class_name LessonOptions
extends VBoxContainer
## The switches of a lesson, and its presets.

## A switch was thrown by the student.
signal switched(key: String, on: bool)
## One of several ways was chosen by the student, by its place in the list.
signal chosen(key: String, place: int)
## The student picked the preset with this key.
signal preset_picked(key: String)
## A switch or a preset as a change of the lesson's state: its values by their names.
signal picked(changes: Dictionary)

# A switch needs no more.
const _WIDEST_SWITCH := 200.0
# The text of a list wraps where there is little room.
const _SMALLEST_LIST := Vector2(150.0, 44.0)
# What a finger can hit: the text may be one word of two letters.
const _SMALLEST_PRESET := Vector2(44.0, 44.0)

var _buttons: Dictionary[String, CheckButton] = {}
var _lists: Dictionary[String, OptionButton] = {}
# The texts of the presets, in which angles are in degrees.
var _preset_texts: Dictionary[Button, String] = {}

@onready var _switches: HFlowContainer = %Switches
@onready var _presets: HFlowContainer = %Presets


## Adds a switch with the text, translated.
func add_switch(key: String, text: String) -> void:
	var button := CheckButton.new()
	button.text = text
	button.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	button.toggled.connect(func(on: bool) -> void: switched.emit(key, on))
	button.toggled.connect(func(on: bool) -> void: picked.emit({key: on}))
	button.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_buttons[key] = button
	_switches.add_child(button)
	# A long text wraps.
	var width := minf(button.get_combined_minimum_size().x, _WIDEST_SWITCH)
	button.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	button.custom_minimum_size.x = width


## Shows the switches whose keys a lesson's state has as it has them, and angles in the unit that is
## chosen; emits nothing.
func show_picked(state: Dictionary) -> void:
	for key in _buttons:
		if state.has(key):
			var on: bool = state[key]
			show_switch(key, on)
	for preset in _preset_texts:
		preset.text = Conventions.in_unit(_preset_texts[preset])


## Shows a switch on or off; emits nothing.
func show_switch(key: String, on: bool) -> void:
	_buttons[key].set_pressed_no_signal(on)


## Adds a list of which one is chosen; [param title] and [param texts] are translated. The title is
## read by a pointer that waits, and above the list where it [param has_heading].
func add_choice(
	key: String, title: String, texts: PackedStringArray, has_heading: bool = false
) -> void:
	var list := OptionButton.new()
	list.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	list.accessibility_name = title
	list.tooltip_text = title
	list.custom_minimum_size = _SMALLEST_LIST
	list.fit_to_longest_item = false
	list.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	list.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	list.item_selected.connect(func(place: int) -> void: chosen.emit(key, place))
	_lists[key] = list
	fill_choice(key, texts)
	var part: Control = list
	if has_heading:
		part = _below_heading(list)
	_switches.add_child(part)


func _below_heading(list: OptionButton) -> VBoxContainer:
	var heading := Label.new()
	heading.text = list.tooltip_text
	heading.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	heading.theme_type_variation = &"LabelQuiet"
	var column := VBoxContainer.new()
	column.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	column.add_child(heading)
	column.add_child(list)
	return column


## Puts other texts, translated, into a list that was added.
func fill_choice(key: String, texts: PackedStringArray) -> void:
	_lists[key].clear()
	for text in texts:
		_lists[key].add_item(text)


## Shows which one is chosen; emits nothing.
func show_choice(key: String, place: int) -> void:
	_lists[key].select(place)


## Shows or hides a list that was added.
func reveal_choice(key: String, is_shown: bool) -> void:
	_lists[key].visible = is_shown


## Adds a button for each preset; its title, source text, is its key.
func add_presets(titles: Array[String]) -> void:
	for title in titles:
		add_preset(title, tr(title))


## Adds a button for each preset; its title, source text, is its key. What the preset changes in the
## lesson's state comes with [signal picked].
func offer_presets(presets: Dictionary[String, Dictionary]) -> void:
	add_presets(presets.keys())
	preset_picked.connect(func(title: String) -> void: picked.emit(presets[title]))


## Adds a button that sets up a preset; the text is translated.
func add_preset(key: String, text: String) -> void:
	var button := Button.new()
	button.text = Conventions.in_unit(text)
	_preset_texts[button] = text
	button.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	button.theme_type_variation = &"ButtonSmall"
	button.custom_minimum_size = _SMALLEST_PRESET
	button.pressed.connect(preset_picked.emit.bind(key))
	button.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_presets.add_child(button)
