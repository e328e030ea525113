class_name PointOfImpactDrawing
extends Node2D
## The drawing of the lesson on the point of impact: one frame's motion, the position reset, a and b
## along the normal, the point of impact, and what the mistake that is switched on makes of it.

## Where along the line its normal is drawn.
const _SHARE_OF_NORMAL := 0.12

@onready var _endless: InfiniteLine = %Endless
@onready var _line: DraggableVector = %Line
@onready var _contact_line: InfiniteLine = %ContactLine
@onready var _normal: Arrow = %Normal
@onready var _motion: Arrow = %Motion
@onready var _old: BallView = %Old
@onready var _new: BallView = %New
@onready var _old_handle: BallHandle = %OldHandle
@onready var _new_handle: BallHandle = %NewHandle
@onready var _reset: BallView = %Reset
@onready var _reset_way: Arrow = %ResetWay
@onready var _impact: BallView = %Impact
@onready var _off: DimensionLine = %Off
@onready var _a: DimensionLine = %A
@onready var _b: DimensionLine = %B
@onready var _level: Arrow = %Level
@onready var _wrong: BallView = %Wrong
@onready var _labels: PointOfImpactLabels = %Labels


## Draws [param model] as far as [param step], counted from 0, has got.
func show_model(model: PointOfImpactModel, step: int) -> void:
	_labels.clear()
	_lay_line(model, step)
	_lay_frame(model)
	_lay_reset(model, step)
	_lay_ways(model, step)
	_lay_impact(model, step)
	_lay_mistake(model)


func _lay_line(model: PointOfImpactModel, step: int) -> void:
	_endless.lay(model.line.start, model.line.along())
	_line.lay(model.line.start, model.line.end)
	var normal := model.line.normal()
	var touching := model.line.start.plus(normal.scaled(model.radius))
	_contact_line.lay(touching, model.line.along())
	_contact_line.visible = step >= 1
	var times := 2.0 * _endless.board.grid_step
	var foot := model.line.start.lerped(model.line.end, _SHARE_OF_NORMAL)
	_normal.label = NumberText.short(times) + " n̂"
	_normal.lay(foot, foot.plus(normal.scaled(times)))
	_normal.visible = step >= 1


func _lay_frame(model: PointOfImpactModel) -> void:
	_motion.lay(model.old_position, model.new_position)
	_old.lay(model.old_position, model.radius)
	_new.lay(model.new_position, model.radius)
	_old_handle.place_ball(model.old_position, model.radius)
	_new_handle.place_ball(model.new_position, model.radius)
	var ahead := _names_ahead(model)
	var behind := ahead.negated()
	_labels.add_name(
		_name_of_old(model), Palette.Role.INK, model.old_position, behind, model.radius
	)
	_labels.add_name(tr("new"), Palette.Role.INK, model.new_position, ahead, model.radius)
	_name_motion(model)


# To where the name of the new position stands: along the motion, or behind the line where the
# motion runs along it.
func _names_ahead(model: PointOfImpactModel) -> Vec2:
	var motion := model.motion()
	if absf(model.way_of_frame()) > 0.5 * motion.length():
		return motion
	return model.line.normal().negated()


# A ball that overlaps from the start touches where it is.
func _name_of_old(model: PointOfImpactModel) -> String:
	var touches_at_once := model.frame_case() == PointOfImpactModel.Case.OVERLAPS_FROM_START
	return tr("old = POI") if touches_at_once else tr("old")


# Beside the half of the path in which the point of impact is not.
func _name_motion(model: PointOfImpactModel) -> void:
	var share := 0.5
	if model.impact().hit:
		share = 0.25 if model.fraction() > 0.5 else 0.75
	var beside := model.motion().normal()
	if beside.dot(_sideways(model)) > 0.0:
		beside = beside.negated()
	var place := model.old_position.lerped(model.new_position, share)
	_labels.add_name("v", Palette.Role.INK, place, beside, 0.0)


func _lay_reset(model: PointOfImpactModel, step: int) -> void:
	var place := model.reset_position()
	_reset.lay(place, model.radius)
	_reset_way.lay(model.new_position, place)
	_reset.visible = step >= 1 and model.is_reset() and model.mistake == 0
	_reset_way.visible = _reset.visible
	if _reset.visible:
		_labels.add_name(tr("reset"), Palette.Role.REST, place, _sideways(model), model.radius)


func _lay_ways(model: PointOfImpactModel, step: int) -> void:
	var normal := model.line.normal()
	var old := model.old_position
	var side := _sideways(model).negated()
	var level := old.minus(normal.scaled(model.way_of_frame()))
	var rim_pixels := model.radius * _endless.board.pixels_per_unit
	_a.offset = rim_pixels + 8.0
	_a.label = "a " + NumberText.short(model.way_to_contact())
	_b.label = "b " + NumberText.short(model.way_of_frame())
	_a.lay(old, old.minus(normal.scaled(model.way_to_contact())), side)
	_b.offset = _a.offset + _a.label_room()
	_b.lay(old, level, side)
	_level.lay(model.new_position, level)
	_a.visible = step >= 2
	_b.visible = step >= 2
	_level.visible = step >= 2


func _lay_impact(model: PointOfImpactModel, step: int) -> void:
	var impact := model.impact()
	_impact.visible = step >= 4 and impact.hit
	var is_on_the_way := model.frame_case() == PointOfImpactModel.Case.IN_FRAME
	_off.visible = _impact.visible and _reset.visible and is_on_the_way
	if not _impact.visible:
		return
	var place := impact.position
	_impact.lay(place, model.radius)
	if is_on_the_way:
		var side := _sideways(model).negated()
		_labels.add_name(tr("POI"), Palette.Role.PROJECTION, place, side, model.radius)
	var off := place.distance_to(model.reset_position())
	_off.label = tr("%s px off") % NumberText.short(off, 3)
	_off.offset = model.radius * _endless.board.pixels_per_unit + 10.0
	_off.lay(place, model.reset_position(), model.line.normal())


func _lay_mistake(model: PointOfImpactModel) -> void:
	var place := model.position_with_mistake()
	_wrong.visible = model.mistake != 0 and place.is_finite()
	if _wrong.visible:
		_wrong.lay(place, model.radius)
		_labels.add_name(tr("wrong"), Palette.Role.WRONG, place, _sideways(model), model.radius)


# The direction along the line in which the ball moves.
func _sideways(model: PointOfImpactModel) -> Vec2:
	var along := model.line.along()
	return along if model.motion().dot(along) >= 0.0 else along.negated()
