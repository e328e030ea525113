class_name ViewOptions
extends Node
## What the student chooses for the whole lab's window, by keys on every screen: full screen, the
## size of text, high contrast, the language. What is chosen is kept for the next time.

## Something else was chosen; the screen shows it.
signal changed
## Another language is spoken now: what the screen says has to be said anew.
signal language_changed

## The conventions that can be chosen where angles or vectors are shown, by their actions.
const CONVENTIONS: Dictionary[StringName, Conventions.Choice] = {
	&"lab_radians": Conventions.Choice.RADIANS,
	&"lab_y_up": Conventions.Choice.Y_UP,
	&"lab_full_turn": Conventions.Choice.FULL_TURN,
}


## Makes [param screen] one of the lab's: its language, keys, signs and size are those that were
## chosen. To be called first, when the screen enters the tree.
static func begin(screen: Control) -> ViewOptions:
	LabText.choose_language()
	InputActions.load_packed()
	WindowFit.follow(screen.get_window())
	Signs.add_to_font()
	var options := ViewOptions.new()
	screen.add_child(options)
	return options


func _ready() -> void:
	HighContrast.show_chosen()


## Chooses the convention whose key [param event] is, if any: for screens that show angles or
## vectors.
static func choose_convention(event: InputEvent) -> void:
	for action in CONVENTIONS:
		if event.is_action_pressed(action, false, true):
			var choice := CONVENTIONS[action]
			Conventions.choose(choice, not Conventions.is_chosen(choice))


# Before anything else: Alt+Enter is no Enter for a button that has the focus.
func _input(event: InputEvent) -> void:
	if event is InputEventKey:
		Keyboard.is_there = true
	if event.is_action_pressed(&"lab_full_screen"):
		show_full_screen(not is_full_screen())
	elif event.is_action_pressed(&"lab_larger_text", true):
		enlarge_text(1)
	elif event.is_action_pressed(&"lab_smaller_text", true):
		enlarge_text(-1)
	else:
		return
	get_viewport().set_input_as_handled()


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"lab_high_contrast", false, true):
		heighten_contrast(not HighContrast.is_chosen())
	elif event.is_action_pressed(&"lab_language", false, true):
		speak_next_language()


## Whether the window fills the screen.
func is_full_screen() -> bool:
	return get_window().mode in [Window.MODE_FULLSCREEN, Window.MODE_EXCLUSIVE_FULLSCREEN]


## Fills the screen with the window, or makes it a window again.
func show_full_screen(wanted: bool) -> void:
	get_window().mode = Window.MODE_FULLSCREEN if wanted else Window.MODE_WINDOWED
	changed.emit()


## Draws everything larger, for [param by] = 1, or smaller, for -1.
func enlarge_text(by: int) -> void:
	WindowFit.enlarge_text(by)
	WindowFit.fit(get_window())
	changed.emit()


## Shows the lab in stronger colors, or in the usual ones.
func heighten_contrast(wanted: bool) -> void:
	HighContrast.choose(wanted)
	changed.emit()


## Speaks the language behind the one that is spoken now.
func speak_next_language() -> void:
	LabText.speak(LabText.next_language())
	language_changed.emit()
