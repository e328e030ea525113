class_name Handle
extends Control
## A point on the board that can be dragged: by mouse, touch, or with the arrow keys when it has
## the focus.
##
## It only asks to be moved: the lesson changes its model and then calls [method place]. Snaps to
## the grid; Shift frees it. Large enough for a finger.

## Asks to be at [param point] of the plane. Comes many times during a drag.
signal moved(point: Vec2)
## A drag or nudge has ended.
signal released

## Every handle in the tree is in this group.
const GROUP := &"handles"

## Side of the square that takes the touch, in pixels of the drawing: 45 of the window at 800x600.
const TOUCH_SIZE := 54.0

const _NUDGES: Dictionary[StringName, Vector2] = {
	&"ui_left": Vector2.LEFT,
	&"ui_right": Vector2.RIGHT,
	&"ui_up": Vector2.UP,
	&"ui_down": Vector2.DOWN,
}

## What a screen reader and the tooltip call it, such as `Head of a`.
@export var title := "":
	set(value):
		title = value
		accessibility_name = value
		tooltip_text = value
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


func _ready() -> void:
	size = Vector2(TOUCH_SIZE, TOUCH_SIZE)
	focus_mode = Control.FOCUS_ALL
	# Other buttons than the left one are for the board.
	mouse_filter = Control.MOUSE_FILTER_PASS
	mouse_default_cursor_shape = Control.CURSOR_MOVE
	_board = _board_above(self)
	_board.view_changed.connect(_follow_view)
	_outermost_board = _board
	while _board_above(_outermost_board):
		_outermost_board = _board_above(_outermost_board)
	_outermost_board.focus_mode = Control.FOCUS_ALL
	add_to_group(GROUP)
	focus_entered.connect(_tie_focus)
	focus_entered.connect(queue_redraw)
	focus_exited.connect(queue_redraw)
	mouse_entered.connect(_hover.bind(true))
	mouse_exited.connect(_hover.bind(false))


## Puts the handle at [param point] of the plane; emits nothing.
func place(point: Vec2) -> void:
	_point = point.copy()
	_follow_view()


## Whether the handle lies on this board, or on one that lies on the outermost board [param board].
func is_on(board: Board) -> bool:
	return board == _board or board == _outermost_board


## Whether the handle takes what is at [param pixel] of the whole screen.
func covers(pixel: Vector2) -> bool:
	return get_global_rect().has_point(pixel)


func _draw() -> void:
	var middle := size / 2.0
	var color := Palette.color(role)
	if has_focus():
		draw_arc(middle, dot_radius + 9.0, 0.0, TAU, 32, Palette.FOCUS, 3.0, true)
	elif _is_hovered or _is_dragged:
		draw_circle(middle, dot_radius + 9.0, Color(color, 0.2), true, -1.0, true)
	var dot := DotTexture.of(Palette.PAPER, color, dot_radius)
	draw_texture(dot, middle - dot.get_size() / 2.0)


func _gui_input(event: InputEvent) -> void:
	var click := event as InputEventMouseButton
	if click and click.button_index == MOUSE_BUTTON_LEFT:
		_press(click)
		accept_event()
	elif event is InputEventMouseMotion and _is_dragged:
		_drag_to(event as InputEventMouseMotion)
		accept_event()
	else:
		_nudge(event)


func _press(click: InputEventMouseButton) -> void:
	if click.pressed:
		_grip = _point.minus(_plane_point(click.position))
	elif _is_dragged:
		released.emit()
	_is_dragged = click.pressed


func _drag_to(motion: InputEventMouseMotion) -> void:
	var point := _plane_point(motion.position).plus(_grip)
	moved.emit(point if motion.shift_pressed else _board.snapped_to_step(point))


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
	while next is Handle and (next as Handle).is_on(_outermost_board):
		next.focus_next = NodePath()
		next = next.find_next_valid_focus()
	return next


func _follow_view() -> void:
	position = _board.to_screen(_point) - size / 2.0
	queue_redraw()


# The nearest board above a node; null where there is none.
static func _board_above(node: Node) -> Board:
	var above := node.get_parent()
	while above and not above is Board:
		above = above.get_parent()
	return above as Board
