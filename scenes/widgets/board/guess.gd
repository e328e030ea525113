@tool
class_name Guess
extends Handle
## Where the student expects a point to be: a dashed ring with a question mark. When the point is
## shown, a dashed line leads from the ring to it.

const _DASHES := 9

# Null until it is shown.
var _truth: Vec2
var _was_moved := false


func _ready() -> void:
	super()
	moved.connect(_go)


## Appears at the point that [param first] returns. Returns false, and stays away, where
## [param truth], which returns the true point, returns null.
func ask(truth: Callable, first: Callable) -> bool:
	if truth.call() == null:
		return false
	_truth = null
	_was_moved = false
	focus_mode = Control.FOCUS_ALL
	mouse_filter = Control.MOUSE_FILTER_PASS
	var start: Vec2 = first.call()
	place(start)
	show()
	# The arrow keys move it where nothing else would take them.
	if not get_viewport().gui_get_focus_owner():
		grab_focus()
	return true


## Shows the true point. Returns one translated sentence on how far off the guess was; "" where the
## student has not guessed.
func judge(truth: Callable) -> String:
	_truth = truth.call()
	if not _was_moved or not _truth:
		return ""
	focus_mode = Control.FOCUS_NONE
	mouse_filter = Control.MOUSE_FILTER_IGNORE
	queue_redraw()
	var off := at().distance_to(_truth)
	if off < 1e-9 * _board.step_length():
		return tr("Exactly.")
	return tr("Your guess was %s off.") % NumberText.size(off)


## What is below it can be taken once its point is shown.
func covers(pixel: Vector2) -> bool:
	return not _truth and super(pixel)


func _go(to: Vec2) -> void:
	_was_moved = true
	place(to)


func _draw() -> void:
	var middle := _middle_in_editor() if Engine.is_editor_hint() else size / 2.0
	var color := Palette.color(role)
	if _truth:
		var end := _board.to_screen(_truth) - position
		draw_dashed_line(middle, end, color, 2.0, 7.0, true, true)
		draw_circle(end, 4.0, color, true, -1.0, true)
	draw_circle(middle, dot_radius, Color(Palette.drawn(Palette.PAPER), 0.8), true, -1.0, true)
	if has_focus():
		draw_arc(middle, dot_radius + 8.0, 0.0, TAU, 32, Palette.drawn(Palette.FOCUS), 3.0, true)
	elif _is_hovered or _is_dragged:
		draw_circle(middle, dot_radius + 8.0, Color(color, 0.2), true, -1.0, true)
	for i in _DASHES:
		var from := i * TAU / _DASHES
		draw_arc(middle, dot_radius, from, from + 0.6 * TAU / _DASHES, 5, color, 3.0, true)
	var start := middle + Vector2(-dot_radius, 7.0)
	var font := get_theme_default_font()
	draw_string(font, start, "?", HORIZONTAL_ALIGNMENT_CENTER, 2.0 * dot_radius, 20, color)
