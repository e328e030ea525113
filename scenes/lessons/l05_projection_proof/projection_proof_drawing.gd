class_name ProjectionProofDrawing
extends Node2D
## The drawing of the proof: both vectors before the turn, and where it has brought them.

## Pixels from the origin to the arc of beta; less where b is short.
const _LARGEST_ARC := 60.0

@onready var _paths: TurnArcs = %Paths
@onready var _beta: AngleArc = %Beta
@onready var _a: Arrow = %A
@onready var _b: Arrow = %B
@onready var _p: Arrow = %P
@onready var _turned_a: Arrow = %TurnedA
@onready var _turned_b: Arrow = %TurnedB
@onready var _turned_p: Arrow = %TurnedP
@onready var _rejection: Arrow = %Rejection
@onready var _right_angle: AngleArc = %RightAngle
@onready var _x_of_a: Arrow = %XOfA
@onready var _y_of_a: Arrow = %YOfA
@onready var _shadow_of_x: Arrow = %ShadowOfX
@onready var _x_of_b: Arrow = %XOfB
@onready var _y_of_b: Arrow = %YOfB
@onready var _head_a: Handle = %HeadA
@onready var _head_b: Handle = %HeadB
@onready var _head_turned_a: Handle = %HeadTurnedA
@onready var _head_turned_b: Handle = %HeadTurnedB


## Draws [param model] at [param step] of [ProjectionProofTexts], after the share of the turn.
func show_model(model: ProjectionProofModel, step: int) -> void:
	_lay_originals(model)
	_lay_turned(model)
	_lay_components(model)
	var has_direction := model.has_direction()
	_beta.visible = _beta.visible and step <= ProjectionProofTexts.Step.TRIANGLE
	_x_of_a.visible = has_direction and step == ProjectionProofTexts.Step.EXPAND
	_y_of_a.visible = _x_of_a.visible
	_shadow_of_x.visible = _x_of_a.visible
	_x_of_b.visible = has_direction and step == ProjectionProofTexts.Step.TRIANGLE
	_y_of_b.visible = _x_of_b.visible


func _lay_originals(model: ProjectionProofModel) -> void:
	var origin := Vec2.new()
	var is_turned := model.turned_share > 0.0 and model.has_direction()
	_a.lay(origin, model.a)
	_b.lay(origin, model.b)
	_p.lay(origin, model.projection())
	for ghost: CanvasItem in [_a, _b, _p, _paths, _head_turned_a, _head_turned_b]:
		ghost.visible = is_turned
	_head_a.place(model.a)
	_head_b.place(model.b)
	_beta.radius = minf(_LARGEST_ARC, 0.6 * model.b.length() * _beta.board.pixels_per_unit)
	_beta.measure(origin, Vec2.new(1.0, 0.0), model.b)
	_paths.lay([model.a, model.b, model.projection()], model.turned_by())


func _lay_turned(model: ProjectionProofModel) -> void:
	var origin := Vec2.new()
	var a := model.turned(model.a)
	var b := model.turned(model.b)
	var p := model.turned(model.projection())
	_turned_a.label = _label(model, "a")
	_turned_b.label = _label(model, "b")
	_turned_a.lay(origin, a)
	_turned_b.lay(origin, b)
	_turned_p.lay(origin, p)
	_turned_p.keep_label_from(a)
	_rejection.lay(p, a)
	_right_angle.measure(p, b.negated(), a.minus(p))
	_turned_p.visible = model.has_direction()
	_rejection.visible = model.has_direction() and a.distance_to(p) > 1e-9 * a.length()
	_right_angle.visible = _right_angle.visible and _rejection.visible
	_head_turned_a.place(a)
	_head_turned_b.place(b)


# a before the turn, a′ after it; on the way only the dashed arrow has a name.
static func _label(model: ProjectionProofModel, letter: String) -> String:
	if model.turned_share == 0.0 or not model.has_direction():
		return letter
	return letter + "′" if model.turned_share == 1.0 else ""


func _lay_components(model: ProjectionProofModel) -> void:
	var origin := Vec2.new()
	var a := model.turned(model.a)
	var corner := model.turned(Vec2.new(model.a.x, 0.0))
	_x_of_a.lay(origin, corner)
	_x_of_a.keep_label_from(a)
	_y_of_a.lay(a, corner)
	_shadow_of_x.lay(corner, Vec2.new(corner.x, 0.0))
	var height := Vec2.new(0.0, model.b.y)
	_y_of_b.label = "by = %s" % NumberText.short(model.b.y)
	_y_of_b.lay(origin, height)
	_y_of_b.keep_label_from(model.b)
	_x_of_b.label = "bx = %s" % NumberText.short(model.b.x)
	_x_of_b.lay(height, model.b)
	_x_of_b.keep_label_from(origin)
