class_name FrameView
extends Node
## How the lesson frame shows its lesson: its layout, what is hidden or folded, and the menu and the
## keys for all of it.

## What is in this group can be hidden for a class, and keeps its place.
const ANSWERS := &"answers"

# The key of a Readout's choice; a lesson without one does not load it.
const _NUMBERS := "numbers"

## The menu in the top bar.
var menu: ViewMenu
## Where the parts of the frame are.
var layout: FrameLayout
## What is chosen for the whole window.
var options: ViewOptions

## Whether all answers are shown.
var shows_answers := true:
	set(on):
		shows_answers = on
		_show_answers(on)

## The lesson that is shown; null until it has been started, and where it could not be.
var lesson: Lesson:
	set(started):
		lesson = started
		if lesson and lesson.keeps_y_down:
			menu.rename(&"lab_y_up", tr("y points up (not in this lesson)"))

var _frame: Control


## Of this lesson frame, with what is chosen for its window.
func _init(frame: Control, chosen: ViewOptions) -> void:
	_frame = frame
	options = chosen
	layout = FrameLayout.new(frame)


func _ready() -> void:
	menu = _frame.get_node("%View")
	menu.add_switch(&"lab_hide_answers", tr("Answers"))
	menu.add_switch(&"lab_motion", tr("Motion"))
	menu.add_switch(&"lab_numbers", tr("Error and run time"))
	menu.add_switch(&"lab_radians", tr("Radians"))
	menu.add_switch(&"lab_y_up", tr("y points up"))
	menu.add_switch(&"lab_full_turn", tr("Angles 0 to 360°"))
	menu.add_switch(&"lab_panel", tr("Panel"))
	menu.add_switch(&"lab_full_screen", tr("Full screen"))
	menu.add_action(&"lab_larger_text", tr("Larger text"))
	menu.add_action(&"lab_smaller_text", tr("Smaller text"))
	menu.add_switch(&"lab_high_contrast", tr("High contrast"))
	menu.add_action(&"lab_language", LabText.name_of(LabText.next_language()))
	menu.opening.connect(_show_in_menu)
	layout.changed.connect(_show_in_menu)
	options.changed.connect(_show_again)
	Conventions.changed().connect(_show_again)
	add_child(layout)
	_show_in_menu()
	set_process(false)


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"lab_hide_answers", false, true):
		shows_answers = not shows_answers
	elif event.is_action_pressed(&"lab_motion", false, true):
		allow_motion(Motion.is_reduced())
	elif event.is_action_pressed(&"lab_panel", false, true):
		layout.keep_panel(not layout.has_panel())
	elif event.is_action_pressed(&"lab_numbers", false, true):
		show_numbers(not _has_numbers())
	ViewOptions.choose_convention(event)


# Answers that come while all are hidden are hidden, too.
func _process(_delta: float) -> void:
	get_tree().set_group(ANSWERS, "modulate", Color.TRANSPARENT)


# The modulation is not the lesson's, as the visibility is.
func _show_answers(on: bool) -> void:
	set_process(not on)
	get_tree().set_group(ANSWERS, "modulate", Color.WHITE if on else Color.TRANSPARENT)
	# A still picture is drawn again when something in it is.
	get_tree().call_group(ANSWERS, &"queue_redraw")
	for service in _services():
		if &"hides_numbers" in service:
			service.set(&"hides_numbers", not on)
	_show_in_menu()


## Lets things move by themselves, or stops them. The choice is kept.
func allow_motion(on: bool) -> void:
	Motion.reduce(not on)
	if lesson and not on:
		lesson.pause()
	_show_in_menu()


## Opens error and run time in every lesson, or folds them. The choice is kept.
func show_numbers(on: bool) -> void:
	KeptChoices.keep(_NUMBERS, on)
	for service in _services():
		if service.has_method(&"show_chosen"):
			service.call(&"show_chosen")
	_show_in_menu()


static func _has_numbers() -> bool:
	return KeptChoices.value(_NUMBERS, false)


func _show_in_menu() -> void:
	for action in ViewOptions.CONVENTIONS:
		menu.show_switch(action, Conventions.is_chosen(ViewOptions.CONVENTIONS[action]))
	menu.show_switch(&"lab_hide_answers", shows_answers)
	menu.show_switch(&"lab_motion", not Motion.is_reduced())
	menu.show_switch(&"lab_numbers", _has_numbers())
	menu.show_switch(&"lab_panel", layout.has_panel())
	menu.show_switch(&"lab_full_screen", options.is_full_screen())
	menu.show_switch(&"lab_high_contrast", HighContrast.is_chosen())


# In other colors, another size or other conventions.
func _show_again() -> void:
	_show_in_menu()
	if lesson:
		lesson.show_all()


func _services() -> Array[Node]:
	return _frame.get_node("%Services").get_children()
