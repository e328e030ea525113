extends Lesson
## The smallest complete lesson: a vector that can be dragged or typed, and its length.
##
## `./lab new_lesson` begins a lesson of your own as a copy of this one.
## Undo, reset and links need no line here, because the model can be stored.

var _model := LengthModel.new()

# Where v lies at the start is in the scene: select V in the editor and change its head.
@onready var _v: DraggableVector = %V
@onready var _formula: Formula = services.get(&"formula")
@onready var _readout: Readout = services.get(&"readout")


## What is kept, and what is computed from it.
class LengthModel:
	extends LessonModel
	var v := Vec2.new()

	func to_dictionary() -> Dictionary:
		return {"v": PackedFloat64Array([v.x, v.y])}

	func from_dictionary(stored: Dictionary) -> void:
		var numbers: PackedFloat64Array = stored["v"]
		v.set_xy(numbers[0], numbers[1])

	func enter(name_in_line: String, value: float) -> String:
		v.set(name_in_line, value)
		return ""


func start() -> void:
	_drag(_v.tail_point(), _v.head_point())
	on_drag(_v.moved, _v.released, _drag)
	begin(_model, _show, func() -> Array[Vec2]: return [_model.v])


# What the student does.


func _drag(tail: Vec2, head: Vec2) -> void:
	_model.v = head.minus(tail)


# What the student sees.


func _show() -> void:
	var v := _model.v
	_v.lay(Vec2.new(), v)
	_formula.put_symbol("v", "v", Palette.Role.A)
	_formula.put_number("x", v.x, Palette.Role.A, tr("x of v"))
	_formula.put_number("y", v.y, Palette.Role.A, tr("y of v"))
	_formula.put_number("square", v.dot(v), Palette.Role.INK)
	_formula.put_number("length", v.length(), Palette.Role.INK)
	_formula.show_lines(["{v} = ( {x} , {y} )", "|{v}| = √({v} · {v}) = √{square} = {length}"])
	# |v| is the scalar projection of v on itself.
	var error := ExactProjection.error_of_scalar_projection(v.length(), v, v)
	_readout.show_result("length", "|v|", v.length(), error, CallTimer.nanoseconds(v.length))
