class_name LineViews
extends Node2D
## The lines of the lesson: each can be dragged as a whole or by an end; one with the focus has a
## button that deletes it.

## These should be the lines. Comes many times during a drag.
signal changed(lines: Array[LineSegment])
## A drag or nudge has ended, or a line has come or gone.
signal released

const _SEGMENT := preload("res://scenes/widgets/board/draggable_segment.tscn")
# Both ends look the same, and small: there are many.
const _DOT_RADIUS := 5.0
# From the middle of a line to its button, in pixels of the screen.
const _BESIDE := 40.0

var _views: Array[DraggableVector] = []
var _lines: Array[LineSegment] = []
var _board: Board

@onready var _delete: Button = $Delete


func _ready() -> void:
	_board = get_parent() as Board
	_board.view_changed.connect(_place_button)
	_delete.pressed.connect(delete_focused)


func _process(_delta: float) -> void:
	if _delete.visible != (focused() >= 0):
		_place_button()


## Shows these lines; emits nothing.
func show_lines(lines: Array[LineSegment]) -> void:
	_lines = lines
	while _views.size() < lines.size():
		_add_view()
	while _views.size() > lines.size():
		_views[-1].queue_free()
		_views.resize(_views.size() - 1)
	for i in lines.size():
		_views[i].lay(lines[i].start, lines[i].end)
	_place_button()


## The line with the keyboard's focus, by its place; -1 for none.
func focused() -> int:
	var owner_of_focus := get_viewport().gui_get_focus_owner()
	if not owner_of_focus:
		return -1
	return _views.find(owner_of_focus.get_parent() as DraggableVector)


## Asks to delete the line with the focus; does nothing where none has it.
func delete_focused() -> void:
	var index := focused()
	if index < 0:
		return
	get_viewport().gui_release_focus()
	var lines := _lines.duplicate()
	lines.remove_at(index)
	changed.emit(lines)
	released.emit()


## Asks to add a line.
func add_line(line: LineSegment) -> void:
	changed.emit(_lines + ([line] as Array[LineSegment]))
	released.emit()


func _add_view() -> void:
	var view := _SEGMENT.instantiate() as DraggableVector
	var index := _views.size()
	view.label = str(index + 1)
	add_child(view)
	view.show_label(false)
	for child in view.get_children():
		if child is Handle:
			(child as Handle).dot_radius = _DOT_RADIUS
	view.moved.connect(_move.bind(index))
	view.released.connect(released.emit)
	_views.append(view)


func _move(start: Vec2, end: Vec2, index: int) -> void:
	var lines := _lines.duplicate()
	lines[index] = LineSegment.new(start, end)
	changed.emit(lines)


func _place_button() -> void:
	var index := focused()
	_delete.visible = index >= 0 and index < _lines.size()
	if not _delete.visible:
		return
	var start := _board.to_screen(_lines[index].start)
	var end := _board.to_screen(_lines[index].end)
	var beside := start.direction_to(end).orthogonal() * _BESIDE
	var room := _board.size - _delete.size
	var place := (start + end) / 2.0 + beside - _delete.size / 2.0
	_delete.position = place.clamp(Vector2.ZERO, room)
