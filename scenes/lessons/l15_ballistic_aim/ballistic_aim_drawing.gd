class_name BallisticAimDrawing
extends Node2D
## The drawing of the lesson on aiming under gravity: the straight way, all arcs that hit, what is
## aimed at, the edge of what can be reached, and the shot that flies.

## The colors of the aims that hit, the earliest first.
const ROLES: Array[Palette.Role] = [
	Palette.Role.PROJECTION, Palette.Role.REST, Palette.Role.INK, Palette.Role.QUIET
]
## Between two dots on a way, in seconds.
const TICK := 0.25

# A way is drawn with so many pieces.
const _PIECES := 40
# The barrel, bullet and target are drawn so large, in pixels, at every scale.
const _BARREL := 34.0
const _BULLET := 6.0
const _TARGET := 11.0
# Of the parabola so much is drawn, in reaches on the level.
const _ENVELOPE_REACH := 1.6
# What is farther away than so many times the target, or this many pixels, is not kept in view.
const _FARTHEST := 1.6
const _NEAREST := 60.0

@onready var _arcs: Array[FlightPath] = [%Arc1, %Arc2, %Arc3, %Arc4]
@onready var _straight: FlightPath = %Straight
@onready var _envelope: FlightPath = %Envelope
@onready var _wrong_path: FlightPath = %WrongPath
@onready var _target_path: FlightPath = %TargetPath
@onready var _drop: Arrow = %Drop
@onready var _aim: Arrow = %Aim
@onready var _least: Arrow = %Least
@onready var _from_p: AngleArc = %FromP
@onready var _from_up: AngleArc = %FromUp
@onready var _gravity: Arrow = %Gravity
@onready var _speed: Arrow = %Speed
@onready var _velocity: Arrow = %Velocity
@onready var _barrel: GunBarrel = %Barrel
@onready var _bullet: BallView = %Bullet
@onready var _wrong_bullet: BallView = %WrongBullet
@onready var _target: TargetMark = %Target
@onready var _met: TargetMark = %Met
@onready var _miss: DimensionLine = %Miss
@onready var _verdict: VerdictCard = %Verdict


## Draws [param model] as far as [param step] has got.
func show_model(model: BallisticAimModel, step: BallisticAimModel.Step) -> void:
	_lay_shooter(model, step)
	_lay_ways(model, step)
	_lay_aim(model, step)
	_lay_least(model, step)
	_lay_wrong(model, step)
	show_flight(model, step)
	_show_verdict(model, step)


## What the board must hold, in units of the plane.
func points_to_show(model: BallisticAimModel, step: BallisticAimModel.Step) -> Array[Vec2]:
	var seconds := BallisticAimModel.ARROW_SECONDS
	var points: Array[Vec2] = [model.target]
	var others: Array[Vec2] = [
		model.pull().scaled(seconds),
		model.target.plus(Vec2.new(0.0, model.fall_after(model.straight_time()))),
	]
	if model.moves:
		others.append(model.target.plus(model.velocity.scaled(seconds)))
	if model.has_shot() and step >= BallisticAimModel.Step.ARCS:
		others.append(model.aim_point(model.shot()))
		others.append_array(model.shots().map(func(shot: Aim) -> Vec2: return shot.target))
	var most := maxf(_NEAREST, _FARTHEST * model.target.length())
	for other in others:
		other.limit_length(most)
		points.append(other)
	return points


## Shows bullet and target where they are now.
func show_flight(model: BallisticAimModel, step: BallisticAimModel.Step) -> void:
	var now := clampf(model.time, 0.0, model.end(step))
	var pixel := 1.0 / _bullet.board.pixels_per_unit
	var towards := model.direction(step)
	var has_hit := step >= BallisticAimModel.Step.ARCS and model.has_shot()
	var flown := minf(now, model.shot().time) if has_hit else now
	_bullet.visible = towards.length() > 0.0
	_bullet.lay(model.bullet_after(flown, towards), _BULLET * pixel)
	var place := model.target_after(now)
	_target.lay(place, _TARGET * pixel)
	(%TargetHandle as Handle).place(model.target)
	var wrong := model.wrong_shot()
	_wrong_bullet.visible = model.compares(step) and wrong.hit
	if _wrong_bullet.visible:
		var wrong_time := minf(now, model.wrong_end())
		_wrong_bullet.lay(model.bullet_after(wrong_time, wrong.direction), _BULLET * pixel)


func _lay_shooter(model: BallisticAimModel, step: BallisticAimModel.Step) -> void:
	var towards := model.direction(step)
	if towards.length() == 0.0:
		towards = model.target.normalized() if model.target.length() > 0.0 else Vec2.new(1.0, 0.0)
	var muzzle := Vec2.zero()
	_barrel.lay(towards.scaled(-_BARREL / _barrel.board.pixels_per_unit), muzzle)
	var seconds := BallisticAimModel.ARROW_SECONDS
	var speed_head := towards.scaled(model.speed * seconds)
	_speed.lay(muzzle, speed_head)
	(%SpeedHead as Handle).place(speed_head)
	var fall := model.pull().scaled(seconds)
	_gravity.lay(muzzle, fall)
	(%GravityHead as Handle).place(fall)
	var velocity_head := model.target.plus(model.velocity.scaled(seconds))
	_velocity.lay(model.target, velocity_head)
	(%VelocityHead as Handle).place(velocity_head)
	_velocity.visible = model.moves
	(%VelocityHead as Handle).visible = model.moves


func _lay_ways(model: BallisticAimModel, step: BallisticAimModel.Step) -> void:
	var towards := model.target.normalized()
	_straight.visible = step < BallisticAimModel.Step.ARCS and towards.length() > 0.0
	if _straight.visible:
		_show_way(_straight, model.bullet_after.bind(towards), model.end(step))
	var shots := model.shots()
	for place in _arcs.size():
		_arcs[place].visible = step >= BallisticAimModel.Step.ARCS and place < shots.size()
		if _arcs[place].visible:
			var shot := shots[place]
			_arcs[place].width = 4.0 if place == model.arc_flown() else 2.0
			_show_way(_arcs[place], model.bullet_after.bind(shot.direction), shot.time)
	_target_path.visible = not model.is_fixed()
	if _target_path.visible:
		_show_way(_target_path, model.target_after, model.end(step))


func _show_way(way: FlightPath, place: Callable, seconds: float) -> void:
	var ticks: Array[Vec2] = []
	if seconds < _PIECES * TICK:
		ticks = FlightPath.places_every(TICK, seconds, place)
	way.show_path(FlightPath.places_every(seconds / _PIECES, seconds, place), ticks)


# From the target to where the straight shot comes; then from where is aimed to where it hits.
func _lay_aim(model: BallisticAimModel, step: BallisticAimModel.Step) -> void:
	var hits := step >= BallisticAimModel.Step.ARCS and model.has_shot()
	var falls := model.gravity > 0.0 and model.target.length() > 0.0
	# The least speed has a direction of its own.
	_aim.visible = hits and step != BallisticAimModel.Step.LEAST
	_drop.visible = falls and (step == BallisticAimModel.Step.DROP or _aim.visible)
	# From above, the arrow ends where the name of the target is.
	_target.label = "" if _aim.visible and model.gravity > 0.0 else "P"
	_met.visible = hits and not model.is_fixed()
	if hits:
		var shot := model.shot()
		_aim.role = ROLES[model.arc_flown()]
		_aim.label = "D" + BallisticAimTexts.SUBSCRIPTS[model.arc_flown()]
		_aim.lay(Vec2.zero(), model.aim_point(shot))
		_drop.lay(model.aim_point(shot), shot.target)
		_met.lay(shot.target, _TARGET / _met.board.pixels_per_unit)
	else:
		var fall := Vec2.new(0.0, model.fall_after(model.straight_time()))
		_drop.lay(model.target, model.target.plus(fall))
	_drop.keep_label_from(Vec2.zero())


func _lay_least(model: BallisticAimModel, step: BallisticAimModel.Step) -> void:
	var is_step := step == BallisticAimModel.Step.LEAST
	_envelope.visible = is_step and model.gravity > 0.0
	if _envelope.visible:
		var reach := _ENVELOPE_REACH * model.speed * model.speed / model.gravity
		var edge := func(seconds: float) -> Vec2: return _edge(model, reach * (seconds - 1.0))
		_envelope.show_path(FlightPath.places_every(2.0 / _PIECES, 2.0, edge))
	_least.visible = is_step and model.has_least() and model.least_direction().length() > 0.0
	var towards := model.least_direction()
	_least.lay(Vec2.zero(), towards.scaled(model.least_speed() * BallisticAimModel.ARROW_SECONDS))
	_from_p.measure(Vec2.zero(), model.target, towards)
	_from_up.measure(Vec2.zero(), towards, Vec2.new(0.0, -1.0))
	_from_p.visible = _least.visible and not model.is_upright()
	_from_up.visible = _from_p.visible


# The edge of what can be reached, x pixels beside the shooter.
static func _edge(model: BallisticAimModel, x: float) -> Vec2:
	var square := model.speed * model.speed
	return Vec2.new(x, 0.5 * (model.gravity * x * x / square - square / model.gravity))


func _lay_wrong(model: BallisticAimModel, step: BallisticAimModel.Step) -> void:
	var wrong := model.wrong_shot()
	_wrong_path.visible = model.compares(step) and wrong.hit
	_miss.visible = _wrong_path.visible
	if not _wrong_path.visible:
		return
	_show_way(_wrong_path, model.bullet_after.bind(wrong.direction), model.wrong_end())
	var place := model.bullet_after(model.wrong_end(), wrong.direction)
	var there := model.target_after(model.wrong_end())
	_miss.label = LabText.translate("%s px off") % NumberText.short(wrong.miss.distance, 3)
	_miss.lay(place, there, there.minus(place).normal())


# The card gives way to the target, to what is aimed at, and to the shooter.
func _show_verdict(model: BallisticAimModel, step: BallisticAimModel.Step) -> void:
	_verdict.visible = step >= BallisticAimModel.Step.TIMES
	var sign_text := BallisticAimTexts.verdict_sign(model, step)
	var role := Palette.Role.RIGHT
	if sign_text == "✗":
		role = Palette.Role.WRONG
	elif sign_text == "0":
		role = Palette.Role.QUIET
	_verdict.show_verdict(sign_text, role, BallisticAimTexts.verdict(model, step))
	var board := _verdict.get_parent() as Board
	var places: PackedVector2Array = [
		board.to_screen(Vec2.zero()),
		board.to_screen(model.target),
		board.to_screen(Vec2.from_vector2(_gravity.head)),
		board.to_screen(Vec2.from_vector2(_speed.head)),
	]
	if _aim.visible:
		places.append(board.to_screen(Vec2.from_vector2(_aim.head)))
	if _miss.visible:
		places.append(board.to_screen(Vec2.from_vector2(_miss.from)))
	_verdict.keep_off(places, 24.0)
