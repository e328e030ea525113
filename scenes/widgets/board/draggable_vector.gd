class_name DraggableVector
extends Node2D
## An arrow whose head, tail and body can be dragged or nudged: the vector that a student plays
## with.

## Head or tail should be here now. Comes many times during a drag.
signal moved(tail: Vec2, head: Vec2)
## A drag or nudge has ended.
signal released

## Its name, such as `a`: the label, and in the names of its handles.
@export var label := "a"
## Which colour it has, here and in formulas.
@export var role := Palette.Role.A
## False shows a line without a tip, as for a wall.
@export var has_tip := true
## What its handles are called: source text with a place for the label.
@export var whole_title := "Whole vector %s"
@export var tail_title := "Tail of %s"
@export var head_title := "Head of %s"

var _tail_point := Vec2.new()
var _head_point := Vec2.new()

@onready var _arrow: Arrow = $Arrow
@onready var _body: ArrowBody = $Body
@onready var _tail: Handle = $Tail
@onready var _head: Handle = $Head


func _ready() -> void:
	_arrow.label = label
	_arrow.role = role
	_arrow.has_tip = has_tip
	_name(_body, tr(whole_title))
	_name(_tail, tr(tail_title))
	_name(_head, tr(head_title))
	_body.moved.connect(_move_body)
	_tail.moved.connect(func(point: Vec2) -> void: moved.emit(point, _head_point.copy()))
	_head.moved.connect(func(point: Vec2) -> void: moved.emit(_tail_point.copy(), point))
	for handle: Handle in [_body, _tail, _head]:
		handle.released.connect(released.emit)


## Shows the vector from [param tail] to [param head], in units of the plane; emits nothing.
func lay(tail: Vec2, head: Vec2) -> void:
	_tail_point = tail.copy()
	_head_point = head.copy()
	_arrow.lay(tail, head)
	_body.place_between(tail, head)
	_tail.place(tail)
	_head.place(head)


## Shows the label beside the head or leaves it to the names of the handles.
func show_label(on: bool) -> void:
	_arrow.label = label if on else ""


## Lights the arrow up, as when its symbol in a formula is pointed at.
func light(on: bool) -> void:
	_arrow.lit = on


func _move_body(tail: Vec2) -> void:
	moved.emit(tail, _head_point.plus(tail.minus(_tail_point)))


func _name(handle: Handle, title: String) -> void:
	handle.role = role
	handle.title = (title % tr(label)).strip_edges()
