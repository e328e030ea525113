class_name GravityArrow
extends Node2D
## Gravity as an arrow in the corner of the board, whose head can be dragged in any direction.

## Asks for this gravity, in pixels per second squared. Comes many times during a drag.
signal turned(gravity: Vec2)
## A drag or nudge has ended.
signal released

# Pixels of the plane per unit of gravity: the usual 300 are 30 long.
const _SCALE := 0.1
# From the corner of the board to the tail, in pixels of the screen.
const _PLACE := Vector2(56.0, 130.0)

var _board: Board
var _tail := Vec2.new()
var _gravity := Vec2.new()

@onready var _arrow: Arrow = $Arrow
@onready var _head: Handle = $Head


func _ready() -> void:
	_board = _arrow.board
	_board.view_changed.connect(_lay)
	_head.moved.connect(_turn_to)
	_head.released.connect(released.emit)
	_head.title = tr("Head of gravity g")


## Shows this gravity; emits nothing.
func show_gravity(gravity: Vec2) -> void:
	_gravity = gravity.copy()
	_lay()


# The tail lies where lines of the snapping grid cross, so that gravity can be straight.
func _lay() -> void:
	_tail = _board.snapped_to_step(_board.to_plane(_PLACE))
	var head := _tail.plus(_gravity.scaled(_SCALE))
	_arrow.lay(_tail, head)
	_head.place(head)


func _turn_to(head: Vec2) -> void:
	turned.emit(head.minus(_tail).divided(_SCALE))
