@tool
class_name DraggableVector
extends Node2D
## An arrow whose head, tail and body can be dragged or nudged: the vector that a student plays
## with.

## Head or tail should be here now. Comes many times during a drag.
signal moved(tail: Vec2, head: Vec2)
## A drag or nudge has ended.
signal released

## Where it begins, in units of the plane. 32 bits; [method lay] keeps all digits.
@export var tail := Vector2.ZERO:
	get:
		return _tail_point.to_vector2()
	set(value):
		lay(Vec2.from_vector2(value), _head_point)
## Where it ends, in units of the plane.
@export var head := Vector2.ZERO:
	get:
		return _head_point.to_vector2()
	set(value):
		lay(_tail_point, Vec2.from_vector2(value))
## Its name, such as `a`: the label, and in the names of its handles.
@export var label := "a":
	set(value):
		label = value
		if is_node_ready():
			_arrow.label = value
## Its color, here and in formulas.
@export var role := Palette.Role.A:
	set(value):
		role = value
		if is_node_ready():
			_color_parts()
## False shows a line without a tip, as for a wall.
@export var has_tip := true
## The name of the handle that moves all of it: source text with a place for the label.
@export var whole_title := "Whole vector %s"
## The same for the handle at the tail.
@export var tail_title := "Tail of %s"
## The same for the handle at the head.
@export var head_title := "Head of %s"

var _tail_point := Vec2.new()
var _head_point := Vec2.new()

@onready var _arrow: Arrow = $Arrow
@onready var _body: ArrowBody = $Body
@onready var _tail: Handle = $Tail
@onready var _head: Handle = $Head


func _ready() -> void:
	_arrow.label = label
	_color_parts()
	_arrow.has_tip = has_tip
	_name(_body, tr(whole_title))
	_name(_tail, tr(tail_title))
	_name(_head, tr(head_title))
	_body.moved.connect(_move_body)
	_tail.moved.connect(func(point: Vec2) -> void: moved.emit(point, _head_point.copy()))
	_head.moved.connect(func(point: Vec2) -> void: moved.emit(_tail_point.copy(), point))
	for handle: Handle in [_body, _tail, _head]:
		handle.released.connect(released.emit)
	lay(_tail_point, _head_point)


## Shows the vector from one point to another, in units of the plane; emits nothing.
func lay(from: Vec2, to: Vec2) -> void:
	_tail_point = from.copy()
	_head_point = to.copy()
	if is_node_ready():
		_arrow.lay(from, to)
		_body.place_between(from, to)
		_tail.place(from)
		_head.place(to)


## Where it begins, in units of the plane.
func tail_point() -> Vec2:
	return _tail_point.copy()


## Where it ends, in units of the plane.
func head_point() -> Vec2:
	return _head_point.copy()


## Shows the label beside the head or leaves it to the names of the handles.
func show_label(on: bool) -> void:
	_arrow.label = label if on else ""


func _move_body(to: Vec2) -> void:
	moved.emit(to, _head_point.plus(to.minus(_tail_point)))


func _color_parts() -> void:
	for part: Node in [_arrow, _body, _tail, _head]:
		part.set(&"role", role)


func _name(handle: Handle, title: String) -> void:
	handle.title = (title % atr(label)).strip_edges()
