@tool
class_name Handle
extends Control
## A point on the board that can be dragged: by mouse, touch, or with the arrow keys when it has
## the focus.
##
## It only asks to be moved: the lesson changes its model and then calls [method place]. Snaps to
## the grid; Shift frees it. Large enough for a finger.

## Asks to be moved to a point of the plane. Comes many times during a drag.
signal moved(to: Vec2)
## A drag or nudge has ended.
signal released

## Side of the square that takes the touch, in pixels of the drawing: 45 of the window at 800x600.
const TOUCH_SIZE := 54.0

const _NUDGES: Dictionary[StringName, Vector2] = {
	&"ui_left": Vector2.LEFT,
	&"ui_right": Vector2.RIGHT,
	&"ui_up": Vector2.UP,
	&"ui_down": Vector2.DOWN,
}

## Where it lies, in units of the plane. 32 bits; [method place] keeps all digits.
@export var point := Vector2.ZERO:
	get:
		return _point.to_vector2()
	set(value):
		place(Vec2.from_vector2(value))
## Its name for screen readers and in the tooltip, such as `Head of a`.
@export var title := "":
	set(value):
		title = value
		_tell_title()
## Colour of the dot.
@export var role := Palette.Role.INK
## Radius of the dot that is seen, in pixels.
@export_range(3.0, 20.0, 0.5, "suffix:px") var dot_radius := 8.0

var _board: Board
# The lesson's own board, on which others may lie.
var _outermost_board: Board
var _point := Vec2.new()
var _is_dragged := false
var _is_hovered := false
# From where the pointer took hold to the point itself, so that nothing jumps at the first touch.
var _grip := Vec2.new()


# Not in _ready: the engine may ask one handle what it covers while another gets ready. Without a
# board, as when its scene runs alone, the handle is hidden.
func _enter_tree() -> void:
	_board = _board_above(self)
	if _board:
		_board.view_changed.connect(_follow_view)
	elif not Engine.is_editor_hint():
		hide()


func _exit_tree() -> void:
	if _board:
		_board.view_changed.disconnect(_follow_view)


func _ready() -> void:
	# The editor would save what is set below.
	if Engine.is_editor_hint() or not _board:
		return
	size = Vector2(TOUCH_SIZE, TOUCH_SIZE)
	focus_mode = Control.FOCUS_ALL
	# Other buttons than the left one are for the board.
	mouse_filter = Control.MOUSE_FILTER_PASS
	mouse_default_cursor_shape = Control.CURSOR_MOVE
	_outermost_board = _board
	while _board_above(_outermost_board):
		_outermost_board = _board_above(_outermost_board)
	_outermost_board.focus_mode = Control.FOCUS_ALL
	add_to_group(Board.HANDLES)
	focus_entered.connect(_tie_focus)
	focus_entered.connect(queue_redraw)
	focus_exited.connect(queue_redraw)
	mouse_entered.connect(_hover.bind(true))
	mouse_exited.connect(_hover.bind(false))
	_tell_title()
	_follow_view()


## Puts the handle at a point of the plane; emits nothing.
func place(to: Vec2) -> void:
	_point = to.copy()
	if _board:
		_follow_view()


## Where it lies, in units of the plane.
func at() -> Vec2:
	return _point.copy()


## Whether the handle takes what is at [param pixel] of the whole screen.
func covers(pixel: Vector2) -> bool:
	return get_global_rect().has_point(pixel)


func _draw() -> void:
	var middle := size / 2.0
	if Engine.is_editor_hint():
		middle = _middle_in_editor()
	var color := Palette.color(role)
	if has_focus():
		draw_arc(middle, dot_radius + 9.0, 0.0, TAU, 32, Palette.drawn(Palette.FOCUS), 3.0, true)
	elif _is_hovered or _is_dragged:
		draw_circle(middle, dot_radius + 9.0, Color(color, 0.2), true, -1.0, true)
	var dot := DotTexture.of(Palette.drawn(Palette.PAPER), color, dot_radius)
	draw_texture(dot, middle - dot.get_size() / 2.0)


func _gui_input(event: InputEvent) -> void:
	var click := event as InputEventMouseButton
	var motion := event as InputEventMouseMotion
	if click and click.button_index == MOUSE_BUTTON_LEFT:
		end_drag()
		if click.pressed:
			_grip = _point.minus(_plane_point(click.position))
			_is_dragged = true
		accept_event()
	elif motion and _is_dragged:
		_drag_to(motion)
		accept_event()
	else:
		_nudge(event)


## Lets go of the handle where it is; does nothing where it is not dragged.
func end_drag() -> void:
	if _is_dragged:
		_is_dragged = false
		queue_redraw()
		released.emit()


func _drag_to(motion: InputEventMouseMotion) -> void:
	# The button was released where nobody saw it, as outside of the window.
	if not motion.button_mask & MOUSE_BUTTON_MASK_LEFT:
		end_drag()
		return
	var wanted := _plane_point(motion.position).plus(_grip)
	moved.emit(wanted if motion.shift_pressed else _board.snapped_to_step(wanted))


# Not in the editor, which would save both.
func _tell_title() -> void:
	if is_node_ready() and not Engine.is_editor_hint():
		accessibility_name = title
		tooltip_text = title


# The point of the plane below `pixel` of this control.
func _plane_point(pixel: Vector2) -> Vec2:
	var to_board := _board.get_global_transform().affine_inverse() * get_global_transform()
	return _board.to_plane(to_board * pixel)


func _nudge(event: InputEvent) -> void:
	for action in _NUDGES:
		if event.is_action_pressed(action, true):
			var step := Vec2.from_vector2(_NUDGES[action])
			var modified := event as InputEventWithModifiers
			step.y *= _board.y_sign()
			step.scale(_board.step_length() * (0.1 if modified and modified.shift_pressed else 1.0))
			moved.emit(_point.plus(step))
			released.emit()
			accept_event()


func _hover(is_hovered: bool) -> void:
	_is_hovered = is_hovered
	queue_redraw()


# The engine's own order of the Tab key loses its way below Node2D parts.
func _tie_focus() -> void:
	var all := _outermost_board.focusable_handles()
	var here := all.find(self)
	var is_last := here == all.size() - 1
	var next: Control = _after_board() if is_last else all[here + 1]
	var previous: Control = all[here - 1] if here > 0 else _outermost_board.find_prev_valid_focus()
	focus_next = get_path_to(next)
	focus_previous = get_path_to(previous)


# The handles themselves come first in the engine's order, unless a Node2D lies between.
func _after_board() -> Control:
	var next := _outermost_board.find_next_valid_focus()
	while next is Handle and _outermost_board.is_ancestor_of(next):
		next.focus_next = NodePath()
		next = next.find_next_valid_focus()
	return next


func _follow_view() -> void:
	if Engine.is_editor_hint():
		queue_redraw()
		return
	position = _board.to_screen(_point) - size / 2.0
	queue_redraw()


# In the editor the node itself stays where it is: its place would be saved.
func _middle_in_editor() -> Vector2:
	if not _board:
		return Vector2.ZERO
	var from_board := get_global_transform().affine_inverse() * _board.get_global_transform()
	return from_board * _board.to_screen(_point)


# The nearest board above a node; null where there is none.
static func _board_above(node: Node) -> Board:
	var above := node.get_parent()
	while above and not above is Board:
		above = above.get_parent()
	return above as Board
