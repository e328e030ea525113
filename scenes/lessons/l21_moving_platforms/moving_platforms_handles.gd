class_name MovingPlatformsHandles
extends RefCounted
## What the student drags in the lesson on surfaces that move: the ball, its velocity, the ends of
## the surface, and how fast that moves.

# Speeds are dragged in steps of this, in px/s, and turns in radians per second.
const _STEP := 10.0
const _TURN_STEP := 0.1
# The arrow of a belt, platform or press lies so far beside the surface, in pixels.
const _BESIDE := 34.0
# That of a disc on a belt lies so far above its centre.
const _ABOVE := 36.0

var _model: MovingPlatformsModel
var _ball: Handle
var _velocity: Handle
var _start: Handle
var _end: Handle
var _surface_velocity: Handle
var _far: Handle


## Those of [param lesson], which change [param model].
func _init(lesson: Lesson, model: MovingPlatformsModel) -> void:
	_model = model
	_ball = lesson.get_node("%Ball")
	_velocity = lesson.get_node("%VelocityHead")
	_start = lesson.get_node("%SurfaceStart")
	_end = lesson.get_node("%SurfaceEnd")
	_surface_velocity = lesson.get_node("%SurfaceVelocityHead")
	_far = lesson.get_node("%FarWallHandle")
	lesson.on_handle(_ball, func(to: Vec2) -> String: return _take("ball", [to.x, to.y]))
	lesson.on_handle(_velocity, _drag_velocity)
	lesson.on_handle(_start, _drag_end.bind(0))
	lesson.on_handle(_end, _drag_end.bind(2))
	lesson.on_handle(_surface_velocity, _drag_surface_velocity)
	lesson.on_handle(_far, _drag_far_wall)


## Takes the start of a wall from where the scene has the handles.
func read_scene() -> void:
	_model.ball = _ball.at()
	_model.velocity = _to_velocity(_velocity.at().minus(_ball.at()))
	_model.surface_start = _start.at()
	_model.surface_end = _end.at()
	var middle := _start.at().lerped(_end.at(), 0.5)
	_model.surface_velocity = _to_velocity(_surface_velocity.at().minus(middle))


## Places all of them as the model has them now.
func place() -> void:
	var kind := _model.kind
	var has_ends := kind in [MovingSurface.Kind.WALL, MovingSurface.Kind.BELT]
	has_ends = has_ends or kind == MovingSurface.Kind.PADDLE
	_ball.place(_model.place_at(0.0))
	_velocity.place(velocity_tail().plus(_arrow_of(_model.first_velocity())))
	_start.place(_model.surface_start)
	_end.place(_model.surface_end)
	_surface_velocity.place(surface_tail().plus(_arrow_of(first_surface_velocity())))
	_far.place(_model.far_wall().start.lerped(_model.far_wall().end, 0.5))
	_ball.visible = _model.is_impact() or kind == MovingSurface.Kind.BELT
	_velocity.visible = kind != MovingSurface.Kind.PLATFORM
	_start.visible = has_ends
	_end.visible = has_ends
	_far.visible = kind == MovingSurface.Kind.PRESS


## Where the arrow of the ball's velocity begins: on a belt above the disc, which can be dragged,
## too.
func velocity_tail() -> Vec2:
	var center := _model.place_at(0.0)
	if _model.kind != MovingSurface.Kind.BELT:
		return center
	return center.plus(_model.up().scaled(_ABOVE))


## Where the arrow of the surface's velocity begins: at the tip of a paddle, at the middle of a
## wall, and beside a belt or platform.
func surface_tail() -> Vec2:
	var surface := _model.first_surface()
	if _model.kind == MovingSurface.Kind.PADDLE:
		return surface.end
	var middle := surface.start.lerped(surface.end, 0.5)
	if _model.is_carried():
		return middle.minus(_model.up().scaled(_BESIDE))
	if _model.kind == MovingSurface.Kind.PRESS:
		return surface.end.lerped(surface.start, 0.15)
	return middle


## How fast the surface moves at the start: where the arrow begins.
func first_surface_velocity() -> Vec2:
	match _model.kind:
		MovingSurface.Kind.WALL:
			return _model.surface_velocity.copy()
		MovingSurface.Kind.PADDLE:
			var arm := _model.surface_end.minus(_model.surface_start)
			return _model.moving().velocity_at(arm)
	return _model.along().scaled(_model.surface_speed)


func _arrow_of(velocity: Vec2) -> Vec2:
	return velocity.scaled(_model.arrow_seconds())


func _to_velocity(arrow: Vec2) -> Vec2:
	var wanted := arrow.divided(_model.arrow_seconds())
	return Vec2.new(snappedf(wanted.x, _STEP), snappedf(wanted.y, _STEP))


# The speed along the line that an arrow shows.
func _to_speed(arrow: Vec2) -> float:
	return snappedf(arrow.dot(_model.along()) / _model.arrow_seconds(), _STEP)


func _drag_velocity(head: Vec2) -> String:
	var arrow := head.minus(velocity_tail())
	if _model.is_impact():
		var velocity := _to_velocity(arrow)
		return _take("velocity", [velocity.x, velocity.y])
	return _model.take({"speed": _to_speed(arrow)})


func _drag_end(to: Vec2, at: int) -> String:
	var list: PackedFloat64Array = _model.to_dictionary()["surface"]
	list[at] = to.x
	list[at + 1] = to.y
	return _model.take({"surface": list})


func _drag_surface_velocity(head: Vec2) -> String:
	var arrow := head.minus(surface_tail())
	match _model.kind:
		MovingSurface.Kind.WALL:
			var velocity := _to_velocity(arrow)
			return _take("surface_velocity", [velocity.x, velocity.y])
		MovingSurface.Kind.PADDLE:
			var arm := _model.surface_end.minus(_model.surface_start)
			var across := Vec2.new(-arm.y, arm.x)
			var turn := arrow.dot(across) / arm.length_squared() / _model.arrow_seconds()
			return _model.take({"turning": snappedf(turn, _TURN_STEP)})
	return _model.take({"surface_speed": _to_speed(arrow)})


func _drag_far_wall(to: Vec2) -> String:
	return _model.take({"way": 2.0 * (to.x - MovingSurface.RADIUS)})


func _take(key: String, list: PackedFloat64Array) -> String:
	return _model.take({key: list})
