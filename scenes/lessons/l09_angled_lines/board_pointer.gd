class_name BoardPointer
extends Node2D
## What the pointer does on the empty board: takes hold of a ball, or draws a new line.

## The ball at this place was taken hold of.
signal ball_taken(index: int)
## The ball that was taken hold of should be at [param point].
signal ball_moved(point: Vec2)
## A new line was drawn.
signal line_drawn(line: LineSegment)
## The ball was let go.
signal ball_released

# A touch this close to a ball's edge counts, in pixels of the screen.
const _REACH := 14.0
# A line shorter than this, in pixels of the screen, was only a click.
const _SHORTEST := 16.0

var _board: Board
var _is_pressed := false
var _has_ball := false
var _start := Vec2.new()
var _grip := Vec2.new()
var _end := Vec2.new()

@onready var _arrow: Arrow = $Arrow


func _ready() -> void:
	_board = get_parent() as Board
	_arrow.visible = false


## The pointer is at [param at]: pressed there, or dragged so far.
func point(at: Vec2, model: AngledLinesModel) -> void:
	if _is_pressed:
		_drag_to(at)
		return
	_is_pressed = true
	# The course's keys work again after a click on the board.
	get_viewport().gui_release_focus()
	var index := model.world.ball_at(at, _REACH / _board.pixels_per_unit)
	_has_ball = index >= 0
	_start = _board.snapped_to_step(at)
	_end = _start.copy()
	if _has_ball:
		_grip = model.world.balls[index].position.minus(at)
		ball_taken.emit(index)


## The pointer was let go.
func release() -> void:
	_is_pressed = false
	_arrow.visible = false
	if _has_ball:
		ball_released.emit()
	elif _start.distance_to(_end) * _board.pixels_per_unit >= _SHORTEST:
		line_drawn.emit(LineSegment.new(_start, _end))


func _drag_to(at: Vec2) -> void:
	if _has_ball:
		ball_moved.emit(_board.snapped_to_step(at.plus(_grip)))
		return
	_end = _board.snapped_to_step(at)
	_arrow.visible = true
	_arrow.lay(_start, _end)
