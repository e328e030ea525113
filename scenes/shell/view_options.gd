class_name ViewOptions
extends Node
## What the student chooses for the whole lab's window, by keys on every screen: full screen, the
## size of text, high contrast. What is chosen is kept for the next time.

## Something else was chosen; the screen shows it.
signal changed


func _ready() -> void:
	HighContrast.show_chosen()


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
