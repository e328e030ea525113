@tool
class_name GravityArrow
extends Arrow
## Gravity as an arrow in the corner of the board, whose head can be dragged in any direction.

## Asks for this gravity, in pixels per second squared. Comes many times during a drag.
signal turned(gravity: Vec2)
## A drag or nudge has ended.
signal released

# Pixels of the plane per unit of gravity: the usual 300 are 30 long.
const _SCALE := 0.1
# From the corner of the board to the tail, in pixels of the screen.
const _PLACE := Vector2(56.0, 130.0)

## Gravity, in pixels per second squared, y downwards. 32 bits; [method show_gravity] keeps all
## digits.
@export var gravity := Vector2.ZERO:
	get:
		return _gravity.to_vector2()
	set(value):
		show_gravity(Vec2.from_vector2(value))

var _gravity := Vec2.new()

@onready var _handle: Handle = $Head


func _ready() -> void:
	if not board:
		return
	board.view_changed.connect(_place)
	_handle.moved.connect(_turn_to)
	_handle.released.connect(released.emit)
	_handle.title = tr("Head of gravity g")
	_place()


## Shows this gravity; emits nothing.
func show_gravity(pull_wanted: Vec2) -> void:
	_gravity = pull_wanted.copy()
	if is_node_ready() and board:
		_place()


## The gravity that is shown, in pixels per second squared.
func pull() -> Vec2:
	return _gravity.copy()


# The view says where this arrow is, and so the arrow must not change the view.
func show_change() -> void:
	queue_redraw()


func spanned_points() -> Array[Vec2]:
	return []


# Tail and head come from the view and from gravity.
func _validate_property(property: Dictionary) -> void:
	if property["name"] in [&"tail", &"head"]:
		property["usage"] = PROPERTY_USAGE_NONE


# The tail is at a point to which handles snap, so that gravity can be straight.
func _place() -> void:
	var corner := board.snapped_to_step(board.to_plane(_PLACE))
	var tip := corner.plus(_gravity.scaled(_SCALE))
	lay(corner, tip)
	_handle.place(tip)


func _turn_to(to: Vec2) -> void:
	turned.emit(to.minus(_tail).divided(_SCALE))
