@tool
class_name LineViews
extends Node2D
## The lines of the lesson: each can be dragged as a whole or by an end. Beside the one with the
## focus is a button that deletes it.

## These should be the lines. Comes many times during a drag.
signal changed(lines: Array[LineSegment])
## A drag or nudge has ended, or a line has come or gone.
signal released

const _SEGMENT := preload("res://scenes/widgets/board/draggable_segment.tscn")
# Both ends look the same and are small: there are many, in pixels.
const _DOT_RADIUS := 5.0
# So few lines are named beside them, A, B and so on; more names would only be in the way.
const _MOST_NAMED := 3
# From the middle of a line to its button, in pixels of the screen.
const _BESIDE := 40.0

## The lines at the start: both ends of the first one, of the second one, and so on, in units of the
## plane.
@export var ends: PackedVector2Array:
	set(value):
		ends = value
		if is_node_ready():
			show_lines(_pairs_of_ends())

var _views: Array[DraggableVector] = []
var _lines: Array[LineSegment] = []
var _board: Board

@onready var _delete: Button = $Delete


func _ready() -> void:
	_board = get_parent() as Board
	show_lines(_pairs_of_ends())
	if Engine.is_editor_hint():
		set_process(false)
		return
	_board.view_changed.connect(_place_button)
	_delete.pressed.connect(delete_focused)


func _process(_delta: float) -> void:
	if _delete.visible != (focused() >= 0):
		_place_button()


## The lines of [member ends]; an end without a partner is pushed as an error.
func lines_at_start() -> Array[LineSegment]:
	if ends.size() % 2 == 1:
		push_error("Lines have two ends each: there cannot be %d ends." % ends.size())
	return _pairs_of_ends()


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
		_views[i].show_label(lines.size() <= _MOST_NAMED)
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


func _pairs_of_ends() -> Array[LineSegment]:
	var found: Array[LineSegment] = []
	for i in range(0, ends.size() - 1, 2):
		var start := Vec2.from_vector2(ends[i])
		found.append(LineSegment.new(start, Vec2.from_vector2(ends[i + 1])))
	return found


func _add_view() -> void:
	var view := _SEGMENT.instantiate() as DraggableVector
	var index := _views.size()
	view.label = char("A".unicode_at(0) + index) if index < 26 else str(index + 1)
	# Without an owner: the editor does not save what it shows of the start.
	add_child(view)
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
	# The editor would save what is set below.
	if Engine.is_editor_hint():
		return
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
