class_name PointOfImpactDrawing
extends Node2D
## The drawing of the lesson on the point of impact: one frame's motion, the position reset, a and b
## along the normal, the point of impact, what the mistake that is switched on makes of it, and the
## verdict.

# Where along the line its normal is drawn.
const _SHARE_OF_NORMAL := 0.12

# How steeply a name beside a ball that touches rises from the line.
const _SHARE_ABOVE := 0.35

# What the point of impact is called (source text), and where it is the old position.
const _POI := "POI"
const _OLD_IS_POI := "old = POI"

@onready var _endless: InfiniteLine = %Endless
@onready var _line: DraggableVector = %Line
@onready var _contact_line: InfiniteLine = %ContactLine
@onready var _normal: Arrow = %Normal
@onready var _motion: Arrow = %Motion
@onready var _old: BallView = %Old
@onready var _new: BallView = %New
@onready var _old_handle: BallHandle = %OldHandle
@onready var _new_handle: BallHandle = %NewHandle
@onready var _ghost: BallView = %Ghost
@onready var _ghost_handle: Handle = %GhostHandle
@onready var _ghost_name: BallName = %GhostName
@onready var _reset: BallView = %Reset
@onready var _reset_way: Arrow = %ResetWay
@onready var _impact: BallView = %Impact
@onready var _off: DimensionLine = %Off
@onready var _old_distance: DimensionLine = %OldDistance
@onready var _radius: DimensionLine = %Radius
@onready var _new_distance: DimensionLine = %NewDistance
@onready var _a: DimensionLine = %A
@onready var _b: DimensionLine = %B
@onready var _level: Arrow = %Level
@onready var _wrong: BallView = %Wrong
@onready var _old_name: BallName = %OldName
@onready var _new_name: BallName = %NewName
@onready var _motion_name: BallName = %MotionName
@onready var _reset_name: BallName = %ResetName
@onready var _impact_name: BallName = %ImpactName
@onready var _wrong_name: BallName = %WrongName
@onready var _verdict: VerdictCard = %Verdict


## Draws [param model] as far as [param step], counted from 0, has got.
func show_model(model: PointOfImpactModel, step: int) -> void:
	_lay_line(model, step)
	_lay_frame(model)
	_lay_ghost(model, step)
	_lay_reset(model, step)
	_lay_distances(model, step)
	_lay_ways(model, step)
	_lay_impact(model, step)
	_lay_mistake(model, step)
	_show_verdict(model, step)


func _lay_line(model: PointOfImpactModel, step: int) -> void:
	_endless.lay(model.line.start, model.line.along())
	_line.lay(model.line.start, model.line.end)
	# On a small board the distances need its place.
	_line.show_label(step < PointOfImpactTexts.Step.DISTANCES or not _endless.board.is_small())
	var normal := model.line.normal()
	var touching := model.line.start.plus(normal.scaled(model.radius))
	_contact_line.lay(touching, model.line.along())
	_contact_line.visible = step >= PointOfImpactTexts.Step.RESET
	var times := 2.0 * _endless.board.grid_step
	var foot := model.line.start.lerped(model.line.end, _SHARE_OF_NORMAL)
	_normal.label = NumberText.short(times) + " n̂"
	_normal.lay(foot, foot.plus(normal.scaled(times)))
	_normal.visible = step >= PointOfImpactTexts.Step.RESET


func _lay_frame(model: PointOfImpactModel) -> void:
	_motion.lay(model.old_position, model.new_position)
	_old.lay(model.old_position, model.radius)
	_new.lay(model.new_position, model.radius)
	_old_handle.place_ball(model.old_position, model.radius)
	_new_handle.place_ball(model.new_position, model.radius)
	var ahead := _side_of_new_name(model)
	_old_name.lay(model.old_position, model.radius, ahead.negated())
	_new_name.lay(model.new_position, model.radius, ahead)
	_name_motion(model)


# The name of the new position is ahead of it, or behind the line where the motion runs along it.
func _side_of_new_name(model: PointOfImpactModel) -> Vec2:
	var motion := model.motion()
	if absf(model.way_of_frame()) > 0.5 * motion.length():
		return motion
	return model.line.normal().negated()


# Beside the half of the path in which the point of impact is not.
func _name_motion(model: PointOfImpactModel) -> void:
	var share := 0.5
	if model.touches():
		share = 0.2 if model.fraction() > 0.5 else 0.8
	var beside := model.motion().normal()
	if beside.dot(_sideways(model)) > 0.0:
		beside = beside.negated()
	var place := model.old_position.lerped(model.new_position, share)
	_motion_name.lay(place, 0.0, beside)


# The ball at some moment of the frame.
func _lay_ghost(model: PointOfImpactModel, step: int) -> void:
	var place := model.position_at_moment()
	_ghost.lay(place, model.radius)
	_ghost_handle.place(place)
	_ghost_name.label = "t = " + NumberText.short(model.moment, 2)
	_ghost_name.lay(place, model.radius, _sideways(model))
	# The point of impact takes its place.
	var is_replaced := step >= PointOfImpactTexts.Step.IMPACT and model.touches()
	for part: CanvasItem in [_ghost, _ghost_handle, _ghost_name]:
		part.visible = model.motion().length() > 0.0 and not is_replaced


func _lay_reset(model: PointOfImpactModel, step: int) -> void:
	var place := model.reset_position()
	_reset.lay(place, model.radius)
	_reset_way.lay(model.new_position, place)
	# In between, distances and ways need the room.
	_reset.visible = (
		step in [PointOfImpactTexts.Step.RESET, PointOfImpactTexts.Step.IMPACT]
		and model.is_reset()
		and not PointOfImpactTexts.is_compared(model, step)
	)
	_reset_way.visible = _reset.visible
	_reset_name.lay(place, model.radius, _above(model, _sideways(model)))
	_reset_name.visible = _reset.visible


# From the line to both centres, and the radius beside the first.
func _lay_distances(model: PointOfImpactModel, step: int) -> void:
	var normal := model.line.normal()
	var side := _sideways(model).negated()
	var foot := model.old_position.minus(normal.scaled(model.old_distance()))
	var new_foot := model.new_position.minus(normal.scaled(model.new_distance()))
	_old_distance.label = tr("old %s") % NumberText.short(model.old_distance())
	_new_distance.label = tr("new %s") % NumberText.short(model.new_distance())
	_radius.label = "r %s" % NumberText.short(model.radius)
	_old_distance.offset = model.radius * _endless.board.pixels_per_unit + 8.0
	_new_distance.offset = _old_distance.offset
	_old_distance.lay(foot, model.old_position, side)
	_new_distance.lay(new_foot, model.new_position, side)
	_radius.lay(foot, foot.plus(normal.scaled(model.radius)), side.negated())
	for part: CanvasItem in [_old_distance, _radius, _new_distance]:
		part.visible = step == PointOfImpactTexts.Step.DISTANCES


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
	_a.visible = step >= PointOfImpactTexts.Step.WAYS
	_b.visible = step >= PointOfImpactTexts.Step.WAYS
	_level.visible = step >= PointOfImpactTexts.Step.WAYS


func _lay_impact(model: PointOfImpactModel, step: int) -> void:
	_impact.visible = step >= PointOfImpactTexts.Step.IMPACT and model.touches()
	var is_on_the_way := model.frame_case() == PointOfImpactModel.Case.IN_FRAME
	_off.visible = _impact.visible and _reset.visible and is_on_the_way
	_off.visible = _off.visible and not model.is_reset_at_impact()
	_impact_name.visible = _impact.visible
	# At t = 0 both are the same place.
	var is_at_old := not is_on_the_way or model.fraction() == 0.0
	_old_name.visible = not _impact.visible or not is_at_old
	if not _impact.visible:
		return
	var place := model.impact_position()
	_impact.lay(place, model.radius)
	# A ball that is too close from the start touches where it is.
	_impact_name.label = _OLD_IS_POI if is_at_old else _POI
	var back := _above(model, _sideways(model).negated())
	_impact_name.lay(place, model.radius, model.motion().negated() if is_at_old else back)
	var off := place.distance_to(model.reset_position())
	_off.label = tr("%s px off") % NumberText.short(off, 3)
	_off.offset = model.radius * _endless.board.pixels_per_unit + 10.0
	_off.lay(place, model.reset_position(), model.line.normal())


func _lay_mistake(model: PointOfImpactModel, step: int) -> void:
	var place := model.position_with_mistake()
	_wrong.visible = PointOfImpactTexts.is_compared(model, step) and place.is_finite()
	_wrong_name.visible = _wrong.visible
	if _wrong.visible:
		_wrong.lay(place, model.radius)
		_wrong_name.lay(place, model.radius, _above(model, _sideways(model)))


# The card gives way to both positions of the ball, and to the way of the whole frame.
func _show_verdict(model: PointOfImpactModel, step: int) -> void:
	_verdict.visible = step >= PointOfImpactTexts.Step.FRACTION
	var hits := model.touches()
	_verdict.show_verdict(
		"!" if hits else "×",
		Palette.Role.PROJECTION if hits else Palette.Role.QUIET,
		PointOfImpactTexts.verdict(model)
	)
	var board := _endless.board
	var places: PackedVector2Array = [
		board.to_screen(model.old_position), board.to_screen(model.new_position), _b.label_pixel()
	]
	_verdict.keep_off(places, model.radius * board.pixels_per_unit)


# A direction that keeps a name off the line of contact, on which the ball's centre is.
func _above(model: PointOfImpactModel, along: Vec2) -> Vec2:
	return along.normalized().plus(model.line.normal().scaled(_SHARE_ABOVE))


# The direction along the line in which the ball moves.
func _sideways(model: PointOfImpactModel) -> Vec2:
	var along := model.line.along()
	return along if model.motion().dot(along) >= 0.0 else along.negated()
