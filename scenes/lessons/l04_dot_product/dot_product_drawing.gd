class_name DotProductDrawing
extends Node2D
## The drawing of the lesson on the dot product: both vectors, the shadow and the rest, step by
## step.

@onready var _a: DraggableVector = %A
@onready var _b: DraggableVector = %B
@onready var _unit: Arrow = %Unit
@onready var _projection: Arrow = %Projection
@onready var _rejection: Arrow = %Rejection
@onready var _tail_drop: Arrow = %TailDrop
@onready var _head_drop: Arrow = %HeadDrop
@onready var _other_projection: Arrow = %OtherProjection
@onready var _other_drop: Arrow = %OtherDrop
@onready var _ruler: DimensionLine = %Ruler
@onready var _light: LightRays = %Light
@onready var _angle: AngleArc = %Angle
@onready var _right_angle: AngleArc = %RightAngle
@onready var _alpha: AngleArc = %Alpha
@onready var _beta: AngleArc = %Beta


## Draws [param model] as far as [param step], counted from 0, has got.
func show_model(model: DotProductModel, step: int) -> void:
	_a.lay(model.a_tail, model.a_head)
	_b.lay(model.b_tail, model.b_head)
	_lay_shadow(model)
	_lay_rejection(model)
	_lay_angles(model)
	_lay_ruler(model)
	_lay_other_shadow(model)
	var has_shadow := model.onto().length() > 0.0
	var is_rest_shown := step == DotProductTexts.Step.REJECTION and model.normalizes
	var has_unit := step >= DotProductTexts.Step.UNIT and step != DotProductTexts.Step.SURE
	_unit.visible = has_shadow and has_unit and model.normalizes
	_tail_drop.visible = has_shadow and step >= DotProductTexts.Step.SCALAR
	_head_drop.visible = _tail_drop.visible
	_projection.visible = has_shadow and step >= DotProductTexts.Step.PROJECTION
	_rejection.visible = is_rest_shown and has_shadow and not model.leaves_nothing()
	_right_angle.visible = _right_angle.visible and _rejection.visible
	_light.visible = has_shadow and _has_light(step) and model.shadowed().length() > 0.0
	_ruler.visible = has_shadow and step == DotProductTexts.Step.SURE
	var has_other := has_shadow and model.shadowed().length() > 0.0 and model.normalizes
	_other_projection.visible = has_other and step == DotProductTexts.Step.BOTH
	_other_drop.visible = _other_projection.visible
	# What has no direction has no arc.
	_angle.visible = _angle.visible and step >= DotProductTexts.Step.SCALAR
	for arc: AngleArc in [_alpha, _beta]:
		arc.visible = _angle.visible and arc.visible and step == DotProductTexts.Step.PRIMITIVE


func _lay_angles(model: DotProductModel) -> void:
	_angle.measure(model.onto_tail(), model.onto(), model.shadowed())
	_alpha.measure(model.a_tail, Vec2.new(1.0, 0.0), model.a())
	_beta.measure(model.b_tail, Vec2.new(1.0, 0.0), model.b())


func _has_light(step: int) -> bool:
	return step == DotProductTexts.Step.SCALAR or step == DotProductTexts.Step.PROJECTION


# On the side away from the vector whose shadow is measured.
func _lay_ruler(model: DotProductModel) -> void:
	var p := model.vector_projection() if not model.is_dot_zero() else Vec2.new()
	var tail := model.foot(model.shadowed_tail())
	var across := model.shadowed_head().minus(model.foot(model.shadowed_head()))
	if not across.length():
		across = model.onto().normal()
	_ruler.label = "|p| = %s" % NumberText.short(p.length())
	_ruler.lay(tail, tail.plus(p), across.negated())


func _lay_other_shadow(model: DotProductModel) -> void:
	var tail := model.shadowed_tail()
	var q := model.other_vector_projection()
	_other_projection.lay(tail, tail.plus(q))
	_other_projection.keep_label_from(model.onto_tail().plus(model.onto()))
	_other_drop.lay(tail.plus(model.onto()), tail.plus(q))


func _lay_shadow(model: DotProductModel) -> void:
	var tail := model.shadowed_tail()
	var head := model.shadowed_head()
	var onto_tail := model.onto_tail()
	var tail_foot := model.foot(tail)
	_unit.label = DotProductTexts.unit_symbol(model)
	_unit.lay(onto_tail, onto_tail.plus(model.unit()))
	_unit.keep_label_from(head)
	_projection.lay(tail_foot, tail_foot.plus(model.vector_projection()))
	_projection.keep_label_from(head)
	_tail_drop.lay(tail, tail_foot)
	_head_drop.lay(head, model.foot(head))
	_light.lay(tail, head, onto_tail, model.onto())


func _lay_rejection(model: DotProductModel) -> void:
	var tail := model.shadowed_tail()
	var corner := tail.plus(model.vector_projection())
	_rejection.label = "%s − p" % DotProductTexts.shadowed_symbol(model)
	_rejection.lay(corner, model.shadowed_head())
	_rejection.keep_label_from(tail)
	_right_angle.measure(corner, model.onto().negated(), model.rejection())
