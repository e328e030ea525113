class_name NormalsDrawing
extends Node2D
## The drawing of the lesson on normals: the line, its vector and its normals, step by step.

# Seconds in which v turns into n before one's eyes.
const _TURN_TIME := 2.5

var _model: NormalsModel
var _step := 0
var _turned_degrees := 90.0
var _tween: Tween

@onready var _v: DraggableVector = %V
@onready var _old_v: Arrow = %OldV
@onready var _old_normal: Arrow = %OldNormal
@onready var _triangle: ComponentTriangle = %Triangle
@onready var _turned: ComponentTriangle = %Turned
@onready var _turn: QuarterTurn = %Turn
@onready var _right_angle: AngleArc = %RightAngle
@onready var _normal: Arrow = %Normal
@onready var _opposite: Arrow = %Opposite
@onready var _unit: Arrow = %Unit
@onready var _unit_v: Arrow = %UnitV
@onready var _scaled: Arrow = %Scaled
@onready var _swapped: Arrow = %Swapped
@onready var _wrong_sign: Arrow = %WrongSign
@onready var _wrong_unit: Arrow = %WrongUnit


## Draws [param model] as far as [param step] of [NormalsTexts] has got.
func show_model(model: NormalsModel, step: int) -> void:
	_model = model
	if step != _step:
		_step = step
		_turn_by_itself()
	_show()


## Shows where the line of [param before] and its normal were; null hides both.
func show_before(before: NormalsModel) -> void:
	_old_v.visible = before != null
	_old_normal.visible = before != null and _shows(NormalsTexts.Step.NORMAL)
	if before:
		_old_v.lay(before.start, before.start.plus(before.v()))
		_old_normal.lay(before.start, before.start.plus(before.normal()))


# v turns into n when its step is reached; where motion is reduced, it has turned already.
func _turn_by_itself() -> void:
	if _tween:
		_tween.kill()
	_turned_degrees = 90.0
	var is_still := Motion.is_reduced() or not OpeningMotion.is_allowed
	if _step != NormalsTexts.Step.NORMAL or is_still:
		return
	_turned_degrees = 0.0
	_tween = create_tween().set_trans(Tween.TRANS_SINE)
	_tween.tween_method(_show_turned, 0.0, 90.0, _TURN_TIME)


func _show_turned(degrees: float) -> void:
	_turned_degrees = degrees
	_show()


# Whether what `step` introduces is shown; a mistake is shown without the steps.
func _shows(step: int) -> bool:
	return _model.mistake == 0 and _step >= step and _model.has_direction()


func _show() -> void:
	_v.lay(_model.start, _model.end)
	_triangle.visible = _model.mistake == 0 and _step <= NormalsTexts.Step.NORMAL
	_triangle.lay(_model.start, _model.v(), 0.0)
	var is_turning := _shows(NormalsTexts.Step.NORMAL) and _step == NormalsTexts.Step.NORMAL
	_turned.visible = is_turning
	_turned.lay(_model.start, _model.v(), _turned_degrees)
	_turn.visible = is_turning
	_turn.lay(_model.start, _model.v())
	_show_normal()
	_lay(_opposite, _model.start, _model.opposite(), _shows(NormalsTexts.Step.OPPOSITE))
	_show_unit()
	_show_mistake()


func _show_normal() -> void:
	var has_normal := _model.has_direction() and (_model.mistake != 0 or _step >= 1)
	var is_turned := _turned_degrees == 90.0
	var normal := _model.normal()
	if not is_turned:
		normal = _model.v()
		normal.rotate_degrees(_turned_degrees)
	_right_angle.measure(_model.start, _model.v(), _model.normal())
	_right_angle.visible = has_normal and is_turned
	_normal.label = "n" if is_turned else ""
	_lay(_normal, _model.start, normal, has_normal)


# The unit normal begins at the start of the line, the one drawn longer in its middle.
func _show_unit() -> void:
	var is_about_unit := _model.mistake not in [0, NormalsMistakes.WRONG_NORMAL]
	var has_unit := is_about_unit and _model.has_direction() or _shows(NormalsTexts.Step.UNIT)
	_lay(_unit, _model.start, _model.unit(), has_unit)
	_unit.keep_label_from(_model.end)
	var has_unit_v := _shows(NormalsTexts.Step.UNIT) and _step == NormalsTexts.Step.UNIT
	_lay(_unit_v, _model.start, _model.v().normalized(), has_unit_v)
	_unit_v.keep_label_from(_model.start.plus(_model.normal()))
	# Where n is shorter than the unit normal on the same line, n is on top and its name beside
	# both.
	var is_short := _model.v().length() < 1.0
	_normal.z_index = 1 if is_short else 0
	_normal.label_place = Arrow.LabelPlace.MIDDLE if is_short else Arrow.LabelPlace.HEAD
	_normal.keep_label_from(_model.start.minus(_model.v()))
	_scaled.label = tr("%s n̂") % NumberText.short(_model.times)
	_lay(_scaled, _model.middle(), _model.scaled(), _shows(NormalsTexts.Step.SCALED))


# A wrong vector is drawn where it is wrong and can be drawn.
func _show_mistake() -> void:
	var v := _model.v()
	var is_wrong_normal := _model.mistake == NormalsMistakes.WRONG_NORMAL and _model.is_mistaken()
	_lay(_swapped, _model.start, NormalsMistakes.swapped(v), is_wrong_normal)
	_lay(_wrong_sign, _model.start, NormalsMistakes.wrong_sign(v), is_wrong_normal)
	var wrong_unit := NormalsMistakes.wrong_unit(_model.mistake, v)
	var has_wrong_unit := _model.is_mistaken() and not is_wrong_normal and wrong_unit.is_finite()
	_wrong_unit.label = "✗ " + NumberText.pair(wrong_unit.x, wrong_unit.y)
	_lay(_wrong_unit, _model.start, wrong_unit, has_wrong_unit)


func _lay(arrow: Arrow, tail: Vec2, vector: Vec2, is_shown: bool) -> void:
	arrow.visible = is_shown
	if is_shown:
		arrow.lay(tail, tail.plus(vector))
