class_name PlatformFlight
extends RefCounted
## The ball and the surface of a state of the lesson on surfaces that move, as the event world flies
## them: where they are at any moment, and how far that is from the place that the formulas give.

# What is shown behind what the lesson is about, in seconds: after an impact, and of rolling.
const _AFTER_IMPACT := 0.6
const _ROLLING := 2.0
# Without an impact, and of a disc that only slips, so many seconds are shown.
const _WITHOUT := 2.0
# Where a disc and its formula are compared, as a share of the flight: before it leaves its belt.
const _COMPARED := 0.95
# In a press, at this share of the time, but not behind so many bounces; not at one of them.
const _COMPARED_IN_PRESS := 0.7
const _COMPARED_BOUNCES := 50.25
# Behind so many bounces of the press they come too fast to be flown one by one: from there on the
# formula tells where the ball is.
const _FLOWN_BOUNCES := 100.0

var _model: MovingPlatformsModel
var _world: EventWorld


## Of [param model] as it is now.
func _init(model: MovingPlatformsModel) -> void:
	_model = model


## Until when everything moves at [param step] of the explanation, in seconds: before the answer,
## until it begins.
func end(step: MovingPlatformsModel.Step) -> float:
	return _last() if step >= MovingPlatformsModel.Step.BACK else _first_end()


func _first_end() -> float:
	match _model.kind:
		MovingSurface.Kind.BELT:
			var run := _model.run()
			if run.run_case == CarriedRun.Case.ROLLS_LATER:
				return run.roll_time
			return _last()
		MovingSurface.Kind.PLATFORM:
			return _model.turn_time()
	return _model.impact().time if _model.impact().hit else _WITHOUT


func _last() -> float:
	match _model.kind:
		MovingSurface.Kind.BELT:
			return _end_of_run()
		MovingSurface.Kind.PLATFORM:
			var first := _model.turn_time()
			return first + minf(_end_of_run(), first)
		MovingSurface.Kind.PRESS:
			return _model.crush_time()
	if not _model.impact().hit:
		return _WITHOUT
	return _model.impact().time + minf(_AFTER_IMPACT, _model.time_to_next_impact())


func _end_of_run() -> float:
	var run := _model.run()
	return minf(run.leave_time, (run.roll_time if run.rolls() else 0.0) + _ROLLING)


## Where the ball's centre is after so many seconds.
func ball_at(seconds: float) -> Vec2:
	if _is_beyond(seconds):
		return _model.place_at(seconds)
	_fly_to(seconds)
	return _world.position(0)


## How far it has turned then, in radians, clockwise on screen.
func turn_at(seconds: float) -> float:
	if not _model.is_carried():
		return 0.0
	_fly_to(seconds)
	return _world.angle(0)


## The wall, belt, platform or paddle after so many seconds.
func surface_at(seconds: float) -> LineSegment:
	if _model.kind == MovingSurface.Kind.PRESS:
		var wall := _model.first_surface()
		var moved := Vec2.new(_model.surface_speed * seconds, 0.0)
		return LineSegment.new(wall.start.plus(moved), wall.end.plus(moved))
	_fly_to(seconds)
	return _world.segment(0)


## Whether the ball is crushed then; its last state is kept.
func is_crushed(seconds: float) -> bool:
	var is_press := _model.kind == MovingSurface.Kind.PRESS
	return is_press and seconds >= _model.crush_time()


func _is_beyond(seconds: float) -> bool:
	if _model.kind != MovingSurface.Kind.PRESS:
		return false
	return seconds > _model.press_time(_FLOWN_BOUNCES)


# A world that is asked for an earlier moment starts anew.
func _fly_to(seconds: float) -> void:
	if not _world or seconds < _world.time:
		_world = EventWorld.new()
		_fill()
	if seconds > _world.time:
		Refusal.push(_world.advance_to(seconds))


func _fill() -> void:
	var surfaces: Array[LineSegment] = [_model.first_surface()]
	if _model.kind == MovingSurface.Kind.PRESS:
		surfaces.append(_model.far_wall())
	Refusal.push(_world.set_segments(surfaces))
	if _model.is_carried():
		Refusal.push(_world.set_gravity(Vec2.new(0.0, MovingPlatformsModel.GRAVITY)))
		Refusal.push(_world.set_friction(_model.friction))
		Refusal.push(_world.set_bounciness(0.0))
	elif _model.is_impact():
		Refusal.push(_world.set_bounciness(_model.bounciness))
	Refusal.push(_world.set_balls([_model.first_ball()]))
	match _model.kind:
		MovingSurface.Kind.BELT:
			Refusal.push(_world.set_belt_speed(0, _model.surface_speed))
		_:
			Refusal.push(_world.set_segment_motion(0, _motion()))


func _motion() -> SegmentMotion:
	match _model.kind:
		MovingSurface.Kind.PLATFORM:
			var there := _model.turn_time()
			var ways: Array[Vec2] = [Vec2.zero(), Vec2.new(_model.way, 0.0), Vec2.zero()]
			return SegmentMotion.along([0.0, there, 2.0 * there], ways, true)
		MovingSurface.Kind.PADDLE:
			return SegmentMotion.turning(_model.surface_start, _model.turning)
		MovingSurface.Kind.PRESS:
			return SegmentMotion.steady(Vec2.new(_model.surface_speed, 0.0))
	return SegmentMotion.steady(_model.surface_velocity)


## Where a point of the lab is that is there at this moment, in the frame of reference that the
## model has: in that of the surface, it is moved back as the surface has moved.
func seen(point: Vec2, seconds: float) -> Vec2:
	if not _model.from_surface:
		return point.copy()
	match _model.kind:
		MovingSurface.Kind.WALL:
			return point.minus(_model.surface_velocity.scaled(seconds))
		MovingSurface.Kind.BELT:
			return point.minus(_model.along().scaled(_model.surface_speed * seconds))
		MovingSurface.Kind.PLATFORM:
			return point.minus(Vec2.new(_model.platform_way(seconds), 0.0))
		MovingSurface.Kind.PRESS:
			return point.minus(Vec2.new(_model.surface_speed * seconds, 0.0))
	var turned := point.copy()
	turned.rotate_around_radians(_model.surface_start, -_model.turning * seconds)
	return turned


## How a direction of the lab lies in that frame then.
func seen_direction(direction: Vec2, seconds: float) -> Vec2:
	var turned := direction.copy()
	if _model.from_surface and _model.kind == MovingSurface.Kind.PADDLE:
		turned.rotate_radians(-_model.turning * seconds)
	return turned


## How far the ball is from where the formulas have it, in pixels, at a moment near the end.
func miss() -> float:
	var moment := _compared_at()
	return ball_at(moment).distance_to(_model.place_at(moment))


## eps times the condition of that place, in pixels: so far rounding alone may move it.
func rounding() -> float:
	return PlatformRounding.of(_model, _compared_at())


func _compared_at() -> float:
	if _model.kind == MovingSurface.Kind.PRESS:
		return minf(_COMPARED_IN_PRESS * _last(), _model.press_time(_COMPARED_BOUNCES))
	return (_COMPARED if _model.is_carried() else 1.0) * _last()
