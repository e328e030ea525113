class_name AimAtDrawing
extends Node2D
## The drawing of the lesson on aiming at a target: the hull, the barrel on it, their angles, the
## shots, and the verdict.

# How far the arcs are from the mount for a barrel of length 1, and in pixels at least and at most.
const _ARC_OF_HULL := 1.2
const _ARC_OF_BARREL := 1.75
const _ARC_OF_TARGET := 2.4
const _SMALLEST_ARC := 24.0
const _LARGEST_ARC := 200.0
# How long the hull is for a barrel of length 1, and how far before it the handle is that turns it.
const _HULL := 1.3
const _FRONT := 1.5
# The reference line of the angles is so long for a barrel of length 1.
const _REFERENCE := 2.6
# Seconds between two dots on a way.
const _TICK := 0.1
const _CURVE := 0.02
# Places farther away than this many times what can be dragged do not make the board smaller.
const _FARTHEST := 2.5

@onready var _reference: Arrow = %Reference
@onready var _hull: TankHull = %Hull
@onready var _hull_line: Arrow = %HullLine
@onready var _sight: Arrow = %Sight
@onready var _alpha: AngleArc = %Alpha
@onready var _beta: AngleArc = %Beta
@onready var _theta: AngleArc = %Theta
@onready var _own: AngleArc = %Own
@onready var _delta: AngleArc = %Delta
@onready var _barrel: GunBarrel = %Barrel
@onready var _aimed_barrel: GunBarrel = %AimedBarrel
@onready var _wrong_barrel: GunBarrel = %WrongBarrel
@onready var _current_way: FlightPath = %CurrentWay
@onready var _falling_way: FlightPath = %FallingWay
@onready var _right_way: FlightPath = %RightWay
@onready var _early_way: FlightPath = %EarlyWay
@onready var _wrong_way: FlightPath = %WrongWay
@onready var _early_miss: DimensionLine = %EarlyMiss
@onready var _wrong_miss: DimensionLine = %WrongMiss
@onready var _velocity: Arrow = %Velocity
@onready var _mark: TargetMark = %Mark
@onready var _bullet: ShotSprite = %Bullet
@onready var _wrong_bullet: ShotSprite = %WrongBullet
@onready var _poses: Array[ShotSprite] = [%FirstPose, %SecondPose, %ThirdPose]
@onready var _hull_handle: Handle = %HullHandle
@onready var _front_handle: Handle = %FrontHandle
@onready var _barrel_handle: Handle = %BarrelHandle
@onready var _target_handle: Handle = %TargetHandle
@onready var _verdict: VerdictCard = %Verdict


## Draws [param model] with its [param shots] as far as [param step] has got.
func show_model(model: AimAtModel, shots: AimShots, step: int) -> void:
	_lay_tank(model)
	_lay_arcs(model, step)
	_lay_current(shots, step)
	_lay_falling(model, shots, step)
	_lay_right(model, shots, step)
	_lay_early(model, shots, step)
	_lay_wrong(model, shots, step)
	show_flight(model, shots, step)
	_show_verdict(model, shots, step)


## Shows barrel and bullet where they are now.
func show_flight(model: AimAtModel, shots: AimShots, step: int) -> void:
	var degrees := _barrel_now(model, step)
	_barrel.lay(model.hull, model.nozzle_at(degrees))
	_barrel_handle.place(model.nozzle_at(degrees))
	if _wrong_barrel.visible and model.mistake == AimAtMistakes.LONG_WAY:
		var left := model.wrong_turn_degrees() * 0.5 ** (model.time / model.half_life)
		_wrong_barrel.lay(model.hull, model.nozzle_at(model.target_degrees() - left))
	_show_bullet(model, shots, step)
	_wrong_bullet.lay(shots.wrong.place_after(model.time), shots.wrong.degrees)
	_wrong_bullet.visible = _wrong_way.visible and model.time > 0.0


## The points that the board has to show: what can be dragged, and where the shots end unless that
## is far away.
func points_to_show(model: AimAtModel, shots: AimShots) -> Array[Vec2]:
	var rim := Vec2.new(model.radius, model.radius)
	var around := Vec2.new(model.length, model.length).scaled(_FRONT)
	var points: Array[Vec2] = [
		model.hull.plus(around),
		model.hull.minus(around),
		model.target.plus(rim),
		model.target.minus(rim),
	]
	var farthest := 0.0
	for point in points:
		farthest = maxf(farthest, point.length())
	for shot: AimShot in [shots.early, shots.wrong]:
		var end := shot.place_after(shot.moment)
		if end.length() <= _FARTHEST * farthest:
			points.append(end)
	return points


# The barrel turns while time runs, and is aligned at last.
func _barrel_now(model: AimAtModel, step: int) -> float:
	if model.shot_case() == AimAtModel.Case.NO_DIRECTION:
		return model.current_degrees()
	match step:
		AimAtModel.Step.TURN, AimAtModel.Step.EARLY:
			return model.degrees_after(model.time) if model.time > 0.0 else model.current_degrees()
		AimAtModel.Step.FIRE:
			return model.target_degrees()
	return model.current_degrees()


func _show_bullet(model: AimAtModel, shots: AimShots, step: int) -> void:
	_bullet.visible = model.time > 0.0 and step != AimAtModel.Step.TURN
	match step:
		AimAtModel.Step.SPRITE:
			var velocity := shots.falling_velocity(model.time)
			_bullet.lay(shots.falling_place(model.time), velocity.angle_degrees())
		AimAtModel.Step.EARLY:
			_bullet.visible = model.time > model.fire and _early_way.visible
			var flown := maxf(0.0, model.time - model.fire)
			_bullet.lay(shots.early.place_after(flown), shots.early.degrees)
		AimAtModel.Step.FIRE:
			_bullet.visible = _right_way.visible and model.time > 0.0
			var flown := minf(model.time, shots.right.moment)
			_bullet.lay(shots.right.place_after(flown), shots.right.degrees)
		AimAtModel.Step.CURRENT:
			_bullet.lay(shots.current.place_after(model.time), shots.current.degrees)
		_:
			_bullet.hide()


func _lay_tank(model: AimAtModel) -> void:
	_hull.length = _HULL * model.length
	_hull.lay(model.hull, model.hull_degrees)
	var front := Vec2.unit_degrees(model.hull_degrees).scaled(_FRONT * model.length)
	_hull_line.lay(model.hull, model.hull.plus(front))
	var along_x := Vec2.new(_REFERENCE * model.length, 0.0)
	_reference.lay(model.hull, model.hull.plus(along_x))
	_mark.lay(model.target, model.radius)
	_hull_handle.place(model.hull)
	_front_handle.place(model.hull.plus(front))
	_target_handle.place(model.target)


func _lay_arcs(model: AimAtModel, step: int) -> void:
	var x_axis := Vec2.new(1.0, 0.0)
	var hull := Vec2.unit_degrees(model.hull_degrees)
	var barrel := Vec2.unit_degrees(model.current_degrees())
	_alpha.radius = _pixels_of_arc(model, _ARC_OF_HULL)
	_theta.radius = _pixels_of_arc(model, _ARC_OF_TARGET)
	for arc: AngleArc in [_beta, _own, _delta]:
		arc.radius = _pixels_of_arc(model, _ARC_OF_BARREL)
	_alpha.measure(model.hull, x_axis, hull)
	_beta.measure(model.hull, hull, barrel)
	_theta.measure(model.hull, x_axis, model.way())
	_own.measure(model.hull, hull, model.way())
	_delta.measure(model.hull, barrel, model.way())
	_sight.lay(model.hull, model.target)
	var sees := model.shot_case() != AimAtModel.Case.NO_DIRECTION
	_sight.visible = sees and step >= AimAtModel.Step.LOOK
	_alpha.visible = step in [AimAtModel.Step.CURRENT, AimAtModel.Step.NESTED]
	_beta.visible = step == AimAtModel.Step.CURRENT and model.barrel_degrees != 0.0
	_theta.visible = sees and step in [AimAtModel.Step.LOOK, AimAtModel.Step.NESTED]
	_own.visible = sees and step == AimAtModel.Step.NESTED
	_delta.visible = sees and step == AimAtModel.Step.TURN
	_reference.visible = _alpha.visible or _theta.visible


func _pixels_of_arc(model: AimAtModel, lengths: float) -> float:
	var pixels := lengths * model.length * _mark.board.pixels_per_unit
	return clampf(pixels, _SMALLEST_ARC, _LARGEST_ARC)


func _lay_current(shots: AimShots, step: int) -> void:
	_show_way(_current_way, shots.current.place_after, shots.end(step))
	_current_way.visible = step == AimAtModel.Step.CURRENT


func _lay_falling(model: AimAtModel, shots: AimShots, step: int) -> void:
	var is_shown := step == AimAtModel.Step.SPRITE
	_falling_way.visible = is_shown
	_velocity.visible = is_shown
	for i: int in _poses.size():
		var moment := AimAtModel.POSES[i]
		var velocity := shots.falling_velocity(moment)
		_poses[i].lay(shots.falling_place(moment), velocity.angle_degrees())
		_poses[i].visible = is_shown
	if is_shown:
		var end := shots.end(step)
		var places := FlightPath.places_every(_CURVE, end, shots.falling_place)
		_falling_way.show_path(places)
	var place := shots.falling_place(AimAtModel.POSES[1])
	# A quarter of a second of its way is short enough.
	var velocity := shots.falling_velocity(AimAtModel.POSES[1]).scaled(0.25)
	_velocity.lay(place, place.plus(velocity))
	_velocity.keep_label_from(model.hull)


func _lay_right(model: AimAtModel, shots: AimShots, step: int) -> void:
	var is_shown := model.shot_case() == AimAtModel.Case.HITS and step == AimAtModel.Step.FIRE
	_right_way.visible = is_shown
	_show_way(_right_way, shots.right.place_after, shots.right.moment)
	var sees := model.shot_case() != AimAtModel.Case.NO_DIRECTION
	_aimed_barrel.visible = sees and step in [AimAtModel.Step.NESTED, AimAtModel.Step.TURN]
	_aimed_barrel.lay(model.hull, model.nozzle_at(model.target_degrees()))


func _lay_early(model: AimAtModel, shots: AimShots, step: int) -> void:
	var is_shown := model.shot_case() == AimAtModel.Case.HITS and step == AimAtModel.Step.EARLY
	_early_way.visible = is_shown
	_early_miss.visible = is_shown and not shots.early.hits()
	_show_way(_early_way, shots.early.place_after, shots.early.end())
	_lay_miss(_early_miss, model, shots.early)


func _lay_wrong(model: AimAtModel, shots: AimShots, step: int) -> void:
	var is_compared := AimAtTexts.is_compared(model, step) and model.shows_mistake()
	var is_long := model.mistake == AimAtMistakes.LONG_WAY
	_wrong_barrel.visible = is_compared
	_wrong_way.visible = is_compared and not is_long
	_wrong_miss.visible = _wrong_way.visible and not shots.wrong.hits()
	_wrong_barrel.lay(model.hull, model.nozzle_at(shots.wrong.degrees))
	_show_way(_wrong_way, shots.wrong.place_after, shots.wrong.end())
	_lay_miss(_wrong_miss, model, shots.wrong)


func _lay_miss(line: DimensionLine, model: AimAtModel, shot: AimShot) -> void:
	line.label = tr("%s px") % NumberText.short(shot.miss, 3)
	# The label is beyond the way of the bullet, off the target.
	var nearest := shot.place_after(shot.moment)
	line.lay(nearest, model.target, nearest.minus(model.target))


func _show_way(path: FlightPath, place: Callable, end: float) -> void:
	var ends: Array[Vec2] = [place.call(0.0), place.call(end)]
	path.show_path(ends, FlightPath.places_every(_TICK, end, place, 40))


func _show_verdict(model: AimAtModel, shots: AimShots, step: int) -> void:
	_verdict.visible = step >= AimAtModel.Step.NESTED
	if not _verdict.visible:
		return
	var hits := model.shot_case() == AimAtModel.Case.HITS
	hits = hits and (step != AimAtModel.Step.EARLY or shots.early.hits())
	var sign_text := "!" if hits else "×"
	var role := Palette.Role.PROJECTION if hits else Palette.Role.QUIET
	if AimAtTexts.is_compared(model, step) and model.shows_mistake():
		sign_text = "✗"
		role = Palette.Role.WRONG
	_verdict.show_verdict(sign_text, role, AimAtTexts.verdict(model, shots, step))
	var board := _mark.board
	var places: PackedVector2Array = []
	for place: Vec2 in [model.hull, model.target, model.hull.lerped(model.target, 0.5)]:
		places.append(board.to_screen(place))
	_verdict.keep_off(places, 30.0)
