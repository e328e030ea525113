class_name LeadTargetDrawing
extends Node2D
## The drawing of the lesson on leading a target: both velocities, the circle of reach, the shots,
## and the verdict. From the second step to the fourth it shows what the shooter sees: it stands
## still there, and the target moves with V.

# Pixels that a bullet, the barrel and the stem of the radius are drawn large, at every scale.
const _BULLET := 6.0
const _BARREL := 48.0
const _STEM := 40.0
# At most so many dots on a way.
const _MOST_TICKS := 12.0
# A radius that is dragged ends at whole steps of this many units.
const _RADIUS_STEP := 1.0
# Where on the circle after one second the handle for the speed is: beside the graph, or below.
const _SPEED_SIDE: PackedFloat64Array = [-0.6, 0.8]
const _SPEED_SIDE_ON_SMALL: PackedFloat64Array = [0.0, 1.0]
# Places farther away than this many times what can be dragged do not make the board smaller.
const _FARTHEST := 3.0

@onready var _graph: LeadGraph = %Graph
@onready var _one_second: ReachCircle = %OneSecond
@onready var _reach: ReachCircle = %Reach
@onready var _target_way: FlightPath = %TargetWay
@onready var _shooter_way: FlightPath = %ShooterWay
@onready var _right_way: FlightPath = %RightWay
@onready var _wrong_way: FlightPath = %WrongWay
@onready var _wrong_miss: DimensionLine = %WrongMiss
@onready var _way: Arrow = %Way
@onready var _minus_own: Arrow = %MinusOwn
@onready var _relative: Arrow = %Relative
@onready var _moved: Arrow = %Moved
@onready var _sum: Arrow = %Sum
@onready var _aimed: Arrow = %Aimed
@onready var _taken_along: Arrow = %TakenAlong
@onready var _velocity: DraggableVector = %Velocity
@onready var _own: DraggableVector = %Own
@onready var _barrel: GunBarrel = %Barrel
@onready var _wrong_barrel: GunBarrel = %WrongBarrel
@onready var _mark: TargetMark = %Mark
@onready var _meeting: TargetMark = %Meeting
@onready var _live: TargetMark = %Live
@onready var _bullet: BallView = %Bullet
@onready var _wrong_bullet: BallView = %WrongBullet
@onready var _stem: Arrow = %Stem
@onready var _radius_handle: Handle = %RadiusHandle
@onready var _speed_handle: Handle = %SpeedHandle
@onready var _verdict: VerdictCard = %Verdict


## Whether [param step] shows what the shooter sees.
static func is_seen_by_shooter(step: int) -> bool:
	return step > LeadTargetModel.Step.NOW and step < LeadTargetModel.Step.AIM


## Draws [param model] with its [param shots] as far as [param step] has got.
func show_model(model: LeadTargetModel, shots: LeadShots, step: int) -> void:
	_lay_given(model, step)
	_lay_handles(model, step)
	_lay_relative(model, step)
	_lay_hit(model, step)
	_lay_aim(model, step)
	_lay_ways(model, shots, step)
	_lay_wrong(model, shots, step)
	_graph.visible = step >= LeadTargetModel.Step.TIME and step < LeadTargetModel.Step.FIRE
	_graph.show_equation(model.equation(), model.aim().time if model.can_hit() else NAN)
	show_flight(model, shots, step)
	_show_verdict(model, shots, step)


## Shows what flies, where it is now.
func show_flight(model: LeadTargetModel, shots: LeadShots, step: int) -> void:
	var is_flying := model.time > 0.0
	var as_seen := is_seen_by_shooter(step)
	_live.lay(model.target_after(model.time, as_seen), model.radius)
	_live.visible = is_flying
	_live.label = "t = %s s" % NumberText.short(model.time, 3) if is_flying else ""
	var size := _BULLET / _bullet.board.pixels_per_unit
	_bullet.lay(shots.right.place_after(model.time), size)
	_bullet.visible = step == LeadTargetModel.Step.FIRE and shots.right.is_right
	var wrong := shots.shown_wrong(step)
	_wrong_bullet.lay(wrong.place_after(model.time), size)
	_wrong_bullet.visible = _wrong_way.visible
	_lay_reach(model, step)
	_graph.show_moment(model.time)


## The radius for a stem whose end is at [param knob]: a whole number, not below 0.
func radius_for(model: LeadTargetModel, knob: Vec2) -> float:
	var wanted := knob.x - model.target.x - _STEM / _mark.board.pixels_per_unit
	return maxf(0.0, snappedf(wanted, _RADIUS_STEP))


## What the board has to show: all that can be dragged, and where the shots end unless that is far
## away.
func points_to_show(model: LeadTargetModel, shots: LeadShots) -> Array[Vec2]:
	var rim := Vec2.new(model.radius, model.radius)
	var points: Array[Vec2] = [
		model.shooter,
		model.target.plus(rim),
		model.target.minus(rim),
		model.target.plus(model.velocity),
		model.shooter.plus(model.own),
		_speed_point(model)
	]
	var farthest := 0.0
	for point in points:
		farthest = maxf(farthest, point.length())
	for place: Vec2 in _far_places(model, shots):
		if place.length() <= _FARTHEST * farthest:
			points.append(place)
	return points


func _far_places(model: LeadTargetModel, shots: LeadShots) -> Array[Vec2]:
	var found: Array[Vec2] = []
	if model.can_hit():
		found.append(model.aim().target)
		found.append(model.target_after(model.aim().time, true))
	for shot: LeadShot in [shots.at_present, shots.wrong]:
		if shot.is_fired():
			found.append(shot.place_after(shot.moment))
			found.append(model.target_after(shot.moment, false))
	return found


func _lay_given(model: LeadTargetModel, step: int) -> void:
	_velocity.lay(model.target, model.target.plus(model.velocity))
	_own.lay(model.shooter, model.shooter.plus(model.own))
	# A name at a velocity of 0 would lie on the barrel, or on the target.
	_own.show_label(model.own.length() > 0.0)
	_velocity.show_label(model.velocity.length() > 0.0)
	_mark.lay(model.target, model.radius)
	var is_aimed := step >= LeadTargetModel.Step.AIM and model.can_hit()
	_lay_barrel(_barrel, model, model.aim().direction if is_aimed else model.way())


func _lay_barrel(barrel: GunBarrel, model: LeadTargetModel, direction: Vec2) -> void:
	var length := _BARREL / barrel.board.pixels_per_unit
	barrel.lay(model.shooter, model.shooter.plus(direction.normalized().scaled(length)))


func _lay_handles(model: LeadTargetModel, step: int) -> void:
	var rim := model.target.plus(Vec2.new(model.radius, 0.0))
	var knob := rim.plus(Vec2.new(_STEM / _mark.board.pixels_per_unit, 0.0))
	_stem.lay(rim, knob)
	_radius_handle.place(knob)
	_one_second.lay(model.shooter, model.speed)
	_one_second.label = tr("s · 1 s")
	_speed_handle.place(_speed_point(model))
	# Later the room is needed.
	var is_shown := step == LeadTargetModel.Step.REACH
	_one_second.visible = is_shown
	_speed_handle.visible = is_shown


## Where the circle after one second can be taken hold of.
func _speed_point(model: LeadTargetModel) -> Vec2:
	var side := _SPEED_SIDE_ON_SMALL if _mark.board.is_small() else _SPEED_SIDE
	return model.shooter.plus(Vec2.new(side[0], side[1]).scaled(model.speed))


func _lay_relative(model: LeadTargetModel, step: int) -> void:
	var is_shown := step >= LeadTargetModel.Step.RELATIVE and step < LeadTargetModel.Step.FIRE
	var head := model.target.plus(model.velocity)
	var seen := model.target.plus(model.relative_velocity())
	_way.lay(model.shooter, model.target)
	_way.keep_label_from(seen)
	_minus_own.lay(head, seen)
	_minus_own.keep_label_from(model.target)
	_relative.lay(model.target, seen)
	_way.visible = is_shown and model.way().length() > 0.0
	var is_other := is_seen_by_shooter(step) and model.own.length() > 0.0
	_minus_own.visible = is_other
	_relative.visible = is_other


# What the shooter sees at the moment of the hit.
func _lay_hit(model: LeadTargetModel, step: int) -> void:
	var is_shown := model.can_hit() and step == LeadTargetModel.Step.TIME and model.aim().time > 0.0
	var as_seen := is_seen_by_shooter(step)
	var seconds := model.aim().time if model.can_hit() else 0.0
	var place := model.target_after(seconds, as_seen)
	_meeting.lay(place, model.radius)
	_meeting.visible = model.can_hit() and seconds > 0.0 and step >= LeadTargetModel.Step.TIME
	_moved.lay(model.target, place)
	_moved.keep_label_from(model.shooter)
	_sum.lay(model.shooter, place)
	_sum.keep_label_from(model.target)
	_moved.visible = is_shown and place.distance_to(model.target) > 0.0
	_sum.visible = is_shown


# The circle of reach now; at rest the one of the hit.
func _lay_reach(model: LeadTargetModel, step: int) -> void:
	var seconds := model.time
	var shows_hit := seconds == 0.0 and step == LeadTargetModel.Step.TIME
	if shows_hit and model.can_hit():
		seconds = model.aim().time
	_reach.lay(model.shooter, model.speed * seconds)
	var is_step := step in [LeadTargetModel.Step.REACH, LeadTargetModel.Step.TIME]
	_reach.visible = is_step and seconds > 0.0
	_reach.label = "s t" if model.time > 0.0 else ""


func _lay_aim(model: LeadTargetModel, step: int) -> void:
	var aim := model.aim()
	var is_shown := aim.hit and step == LeadTargetModel.Step.AIM and aim.direction.length() > 0.0
	_aimed.visible = is_shown
	_taken_along.visible = is_shown and model.own.length() > 0.0
	if not is_shown:
		return
	var head := model.shooter.plus(aim.direction.scaled(model.speed))
	_aimed.lay(model.shooter, head)
	_aimed.keep_label_from(model.target)
	_taken_along.lay(head, head.plus(model.own))


func _lay_ways(model: LeadTargetModel, shots: LeadShots, step: int) -> void:
	var is_on_ground := not is_seen_by_shooter(step)
	var end := shots.end(step)
	var tick := _tick_of(end)
	var target_after := func(seconds: float) -> Vec2: return model.target_after(seconds, false)
	var shooter_after := func(seconds: float) -> Vec2: return model.shooter_after(seconds, false)
	_show_way(_target_way, target_after, end, tick)
	_target_way.visible = is_on_ground and model.velocity.length() > 0.0
	_show_way(_shooter_way, shooter_after, end, tick)
	_shooter_way.visible = is_on_ground and model.own.length() > 0.0
	_show_way(_right_way, shots.right.place_after, shots.right.moment, tick)
	_right_way.visible = step >= LeadTargetModel.Step.AIM and shots.right.is_right


func _show_way(path: FlightPath, place: Callable, end: float, tick: float) -> void:
	var ends: Array[Vec2] = [place.call(0.0), place.call(end)]
	path.show_path(ends, FlightPath.places_every(tick, end, place))


# 1, 2 or 5 times a power of ten seconds between two dots.
static func _tick_of(end: float) -> float:
	var least := end / _MOST_TICKS
	var power := 10.0 ** floorf(log(least) / log(10.0))
	for factor: float in [1.0, 2.0, 5.0]:
		if factor * power >= least:
			return factor * power
	return 10.0 * power


func _lay_wrong(model: LeadTargetModel, shots: LeadShots, step: int) -> void:
	var wrong := shots.shown_wrong(step)
	var is_step := step == LeadTargetModel.Step.NOW or LeadTargetTexts.is_compared(model, step)
	var is_shown := is_step and wrong.is_fired()
	# What changes nothing would lie on the right way.
	is_shown = is_shown and (step == LeadTargetModel.Step.NOW or model.shows_mistake())
	_wrong_way.visible = is_shown
	_wrong_miss.visible = is_shown and not wrong.touches()
	_wrong_barrel.visible = is_shown and step > LeadTargetModel.Step.NOW
	if not is_shown:
		return
	_lay_barrel(_wrong_barrel, model, wrong.direction)
	_show_way(_wrong_way, wrong.place_after, wrong.end(), _tick_of(shots.end(step)))
	var target_then := model.target_after(wrong.moment, false)
	_wrong_miss.label = tr("%s px") % NumberText.short(wrong.miss, 3)
	var side := model.way().normal()
	_wrong_miss.lay(wrong.place_after(wrong.moment), target_then, side)


func _show_verdict(model: LeadTargetModel, shots: LeadShots, step: int) -> void:
	_verdict.visible = step >= LeadTargetModel.Step.TIME
	var sign_text := "!" if model.can_hit() else "×"
	var role := Palette.Role.PROJECTION if model.can_hit() else Palette.Role.QUIET
	if LeadTargetTexts.is_compared(model, step) and model.shows_mistake():
		sign_text = "✗"
		role = Palette.Role.WRONG
	_verdict.show_verdict(sign_text, role, LeadTargetTexts.verdict(model, shots, step))
	var board := _mark.board
	var places: PackedVector2Array = []
	for place: Vec2 in [model.shooter, model.target]:
		places.append(board.to_screen(place))
	if model.can_hit():
		places.append(board.to_screen(model.target_after(model.aim().time, false)))
	if _graph.get_parent() == board and _graph.visible:
		for share: float in [0.1, 0.5, 0.9]:
			places.append(_graph.position + _graph.size * Vector2(0.5, share))
	_verdict.keep_off(places, 24.0)
