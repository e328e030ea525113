class_name NormalsDrawing
extends Node2D
## The drawing of the lesson on normals: the line, its vector and its normals, step by step.

@onready var _v: DraggableVector = %V
@onready var _old_v: Arrow = %OldV
@onready var _old_normal: Arrow = %OldNormal
@onready var _turn: QuarterTurn = %Turn
@onready var _right_angle: AngleArc = %RightAngle
@onready var _normal: Arrow = %Normal
@onready var _opposite: Arrow = %Opposite
@onready var _unit: Arrow = %Unit
@onready var _scaled: Arrow = %Scaled
@onready var _swapped: Arrow = %Swapped
@onready var _wrong_sign: Arrow = %WrongSign
@onready var _wrong_unit: Arrow = %WrongUnit


## Draws [param model] as far as [param step], counted from 0, has got.
func show_model(model: NormalsModel, step: int) -> void:
	var start := model.start
	var has_normal := model.v().length() > 0.0
	_v.lay(start, model.end)
	_turn.lay(start, model.v())
	_turn.visible = step == 1
	_right_angle.measure(start, model.v(), model.normal())
	_right_angle.visible = step >= 1 and has_normal
	_lay(_normal, start, model.normal(), step >= 1 and has_normal)
	_lay(_opposite, start, model.opposite(), step >= 2 and has_normal and model.mistake == 0)
	_lay_unit(model, step)
	_lay_mistake(model)


## Shows where the line of [param before] and its normal were; null hides both.
func show_before(before: NormalsModel) -> void:
	_old_v.visible = before != null
	_old_normal.visible = before != null
	if before:
		_lay(_old_v, before.start, before.v(), true)
		_lay(_old_normal, before.start, before.normal(), true)


# The unit normal begins at the start of the line, the one drawn longer in its middle.
func _lay_unit(model: NormalsModel, step: int) -> void:
	var has_normal := model.v().length() > 0.0
	var is_wrong_normal := model.mistake == NormalsMistakes.WRONG_NORMAL
	_lay(_unit, model.start, model.unit(), step >= 3 and has_normal and not is_wrong_normal)
	_unit.keep_label_from(model.end)
	# Where n is shorter than the unit normal on the same line, n is on top and its name beside both.
	var is_short := model.v().length() < 1.0
	_normal.z_index = 1 if is_short else 0
	_normal.label_place = Arrow.LabelPlace.MIDDLE if is_short else Arrow.LabelPlace.HEAD
	_normal.keep_label_from(model.start.minus(model.v()))
	_scaled.label = tr("%s n̂") % NumberText.short(model.times)
	_lay(_scaled, model.middle(), model.scaled(), step >= 4 and has_normal and model.mistake == 0)


func _lay_mistake(model: NormalsModel) -> void:
	var v := model.v()
	var is_wrong_normal := model.mistake == NormalsMistakes.WRONG_NORMAL
	var wrong_unit := NormalsMistakes.wrong_unit(model.mistake, v)
	_lay(_swapped, model.start, NormalsMistakes.swapped(v), is_wrong_normal)
	_lay(_wrong_sign, model.start, NormalsMistakes.wrong_sign(v), is_wrong_normal)
	var has_wrong_unit := model.mistake != 0 and not is_wrong_normal and wrong_unit.is_finite()
	_wrong_unit.label = "✗ " + NumberText.pair(wrong_unit.x, wrong_unit.y)
	_lay(_wrong_unit, model.start, wrong_unit, has_wrong_unit)


func _lay(arrow: Arrow, tail: Vec2, vector: Vec2, is_shown: bool) -> void:
	arrow.visible = is_shown
	if is_shown:
		arrow.lay(tail, tail.plus(vector))
