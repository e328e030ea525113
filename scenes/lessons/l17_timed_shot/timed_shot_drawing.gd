class_name TimedShotDrawing
extends Node2D
## The drawing of the lesson on the moment to fire: both ways, where they cross, where the target is
## when to fire, the shots that fly, and the timeline.

## Between two dots on the target's way, in seconds.
const TICK := 1.0

# A circle is drawn with so many pieces.
const _PIECES := 72
# The barrel, the bullet, and a target without a radius are drawn so large, in pixels.
const _BARREL := 36.0
const _BULLET := 6.0
const _TARGET := 6.0
# The timeline ends so much later than what happens, and is at least so long, in seconds.
const _BEYOND := 1.25
const _SHORTEST := 4.0
# What lies farther away than so many times muzzle or target is not kept in view.
const _FARTHEST := 1.2
# Room below for the timeline, as a share of what is seen.
const _BELOW := 1.55

@onready var _way: FlightPath = %Way
@onready var _bullet_way: FlightPath = %BulletWay
@onready var _wrong_way: FlightPath = %WrongWay
@onready var _velocity: Arrow = %Velocity
@onready var _leaving: Arrow = %Leaving
@onready var _barrel: GunBarrel = %Barrel
@onready var _cross: BallView = %Cross
@onready var _waiting: TargetMark = %Waiting
@onready var _target: TargetMark = %Target
@onready var _bullet: BallView = %Bullet
@onready var _wrong_bullet: BallView = %WrongBullet
@onready var _miss: DimensionLine = %Miss
@onready var _timeline: ShotTimeline = %Timeline
@onready var _verdict: VerdictCard = %Verdict


## Draws [param model] as far as [param step] has got.
func show_model(model: TimedShotModel, step: TimedShotModel.Step) -> void:
	_lay_ways(model, step)
	_lay_handles(model)
	_lay_crossing(model, step)
	_lay_wrong(model, step)
	_show_timeline(model, step)
	show_motion(model, step)
	_show_verdict(model, step)


## Shows target, barrel and bullets where they are now.
func show_motion(model: TimedShotModel, step: TimedShotModel.Step) -> void:
	var now := clampf(model.time, 0.0, model.end(step))
	var unit := _target.board.pixels_per_unit
	_target.lay(model.target_after(now), _drawn_radius(model))
	var fire := model.fire(step)
	# A barrel that has fired goes on turning.
	var towards := model.bullet_velocity(now).normalized()
	_barrel.lay(model.muzzle.minus(towards.scaled(_BARREL / unit)), model.muzzle)
	var leaving := model.bullet_velocity(now).scaled(TimedShotModel.ARROW_SECONDS)
	_leaving.lay(model.muzzle, model.muzzle.plus(leaving))
	_lay_bullet(_bullet, model, fire, now)
	_wrong_bullet.visible = model.compares(step)
	if _wrong_bullet.visible:
		_lay_bullet(_wrong_bullet, model, model.wrong_fire(), now)
	_timeline.show_now(now)


## What the board must hold, in units of the plane.
func points_to_show(model: TimedShotModel) -> Array[Vec2]:
	var points: Array[Vec2] = [model.muzzle, model.target]
	var most := 1.0
	for point in points:
		most = maxf(most, _FARTHEST * point.length())
	var others: Array[Vec2] = [model.target_after(model.own_fire)]
	if model.kind == TimedShotModel.Kind.CIRCLE:
		var rho := model.circle_radius()
		others.append(model.centre.plus(Vec2.new(rho, rho)))
		others.append(model.centre.minus(Vec2.new(rho, rho)))
	elif model.flight() > 0.0:
		others.append(model.crossing())
	for other in others:
		other.limit_length(most)
		points.append(other)
	for point: Vec2 in points.duplicate():
		points.append(Vec2.new(0.0, _BELOW * point.y))
	return points


# A bullet waits in the muzzle until it is fired.
func _lay_bullet(ball: BallView, model: TimedShotModel, fire: float, now: float) -> void:
	ball.lay(model.bullet_after(now, fire), _BULLET / ball.board.pixels_per_unit)


func _drawn_radius(model: TimedShotModel) -> float:
	return maxf(model.radius, _TARGET / _target.board.pixels_per_unit)


func _lay_ways(model: TimedShotModel, step: TimedShotModel.Step) -> void:
	var last := maxf(_span(model, step), _SHORTEST)
	if model.kind == TimedShotModel.Kind.CIRCLE:
		last = 360.0 / absf(model.circling)
		_way.show_path(
			FlightPath.places_every(last / _PIECES, last, model.target_after),
			FlightPath.places_every(TICK, last - 0.5 * TICK, model.target_after)
		)
	else:
		_way.show_path(
			[model.target, model.target_after(last)],
			FlightPath.places_every(TICK, last, model.target_after, _PIECES)
		)
	var fire := model.fire(step)
	var reach := maxf(model.flight(), TimedShotModel.ARROW_SECONDS * 2.0)
	_bullet_way.show_path([model.muzzle, model.bullet_after(fire + reach, fire)])


func _lay_handles(model: TimedShotModel) -> void:
	var seconds := TimedShotModel.ARROW_SECONDS
	var is_circle := model.kind == TimedShotModel.Kind.CIRCLE
	var velocity_head := model.target.plus(model.velocity.scaled(seconds))
	_velocity.visible = not is_circle
	_velocity.lay(model.target, velocity_head)
	(%VelocityHead as Handle).visible = not is_circle
	(%VelocityHead as Handle).place(velocity_head)
	(%Centre as Handle).visible = is_circle
	(%Centre as Handle).place(model.centre)
	(%Muzzle as Handle).place(model.muzzle)
	(%LeavingHead as Handle).place(model.muzzle.plus(model.bullet.scaled(seconds)))
	(%Start as Handle).place(model.target)


func _lay_crossing(model: TimedShotModel, step: TimedShotModel.Step) -> void:
	var is_turning := model.kind == TimedShotModel.Kind.TURNING
	var first := TimedShotModel.Step.WAIT if is_turning else TimedShotModel.Step.CROSS
	_cross.visible = step >= first and model.flight() > 0.0
	if _cross.visible:
		_cross.lay(model.crossing(), 0.7 * _BULLET / _cross.board.pixels_per_unit)
	_waiting.visible = model.flies_right(step)
	if _waiting.visible:
		_waiting.lay(model.target_after(model.shot().fire), _drawn_radius(model))


func _lay_wrong(model: TimedShotModel, step: TimedShotModel.Step) -> void:
	_wrong_way.visible = model.compares(step)
	_miss.visible = _wrong_way.visible
	if not _wrong_way.visible:
		return
	var fire := model.wrong_fire()
	var miss := model.miss_at(fire)
	var nearest := model.bullet_after(fire + miss.moment, fire)
	var there := model.target_after(fire + miss.moment)
	_wrong_way.show_path([model.muzzle, nearest])
	_miss.label = LabText.translate("%s px off") % NumberText.short(miss.distance, 3)
	# Its label is on the side on which the muzzle is not.
	var side := there.minus(nearest).normal()
	if side.dot(model.muzzle.minus(nearest)) > 0.0:
		side = side.negated()
	_miss.lay(nearest, there, side)


# How many seconds the timeline shows: the next whole ones.
func _span(model: TimedShotModel, step: TimedShotModel.Step) -> float:
	var last := maxf(model.own_fire, _SHORTEST)
	if model.has_shot():
		last = maxf(last, model.shot().fire + model.shot().flight)
	if model.compares(step):
		last = maxf(last, model.wrong_fire())
	return ceilf(_BEYOND * last)


func _show_timeline(model: TimedShotModel, step: TimedShotModel.Step) -> void:
	var window: PackedFloat64Array = []
	if step == TimedShotModel.Step.WINDOW and model.has_shot():
		window = model.window()
	var right := model.shot().fire if _knows(model, step) else NAN
	var wrong := model.wrong_fire() if model.compares(step) else NAN
	var own := NAN if model.flies_right(step) else model.own_fire
	_timeline.show_moments(_span(model, step), own, right, wrong, window)


static func _knows(model: TimedShotModel, step: TimedShotModel.Step) -> bool:
	return model.has_shot() and step >= TimedShotModel.Step.WAIT


# The card gives way to muzzle and target, and to where they meet.
func _show_verdict(model: TimedShotModel, step: TimedShotModel.Step) -> void:
	_verdict.visible = step >= TimedShotModel.Step.WAIT
	var sign_text := TimedShotTexts.verdict_sign(model, step)
	var role := Palette.Role.RIGHT
	if sign_text == "✗":
		role = Palette.Role.WRONG
	elif sign_text == "0":
		role = Palette.Role.QUIET
	_verdict.show_verdict(sign_text, role, TimedShotTexts.verdict(model, step))
	var board := _verdict.get_parent() as Board
	var places: PackedVector2Array = []
	for part: Handle in [%Start, %VelocityHead, %Muzzle, %LeavingHead, %Centre]:
		if part.visible:
			places.append(board.to_screen(part.at()))
	for part: Vec2 in [model.crossing(), model.target_after(model.fire(step))]:
		places.append(board.to_screen(part))
	# On a small board it is in the panel.
	if _timeline.get_parent() == board:
		var place := _timeline.get_rect()
		places.append_array([place.position, place.position + Vector2(place.size.x, 0.0)])
	_verdict.keep_off(places, 24.0)
