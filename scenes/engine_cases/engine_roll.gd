class_name EngineRoll
extends RefCounted
## A ball that runs along a line as the engine's own RigidBody2D, with friction and spin. The engine
## moves it in the physics frames that come, one after another; each place is kept, so that any of
## them can be asked for again.

## The body has come to the end of the line, or it is not waited for any longer.
signal ended

# So many frames at most.
const _LONGEST := 600

## Seconds until the body was at the end of the line, between two frames by interpolation; INF until
## then.
var end_time := INF

var _space: EngineSpace
var _tree: SceneTree
var _body: RID
var _line: LineSegment
var _places: Array[Vec2] = []
var _waits_for_first := true


## A ball like [param ball], which touches [param line], under [param gravity], downwards in px/s²,
## with the friction µ, in a physics space of its own below [param host], which must be in the tree.
func _init(host: Node, ball: Ball, line: LineSegment, gravity: float, friction: float) -> void:
	_line = line.copy()
	_places = [ball.position.copy()]
	_tree = host.get_tree()
	_space = EngineSpace.new(host)
	_space.set_gravity(gravity)
	var material := PhysicsMaterial.new()
	material.friction = friction
	_space.add_walls([line], false).physics_material_override = material
	var body := _space.add_rigid_ball(ball, RigidBody2D.CCD_MODE_DISABLED)
	body.physics_material_override = material
	body.angular_damp_mode = RigidBody2D.DAMP_MODE_REPLACE
	body.angular_damp = 0.0
	body.lock_rotation = false
	_body = body.get_rid()
	_tree.physics_frame.connect(_keep_place)


## Whether all frames of the run are there.
func has_ended() -> bool:
	return end_time < INF or _places.size() > _LONGEST


## The place of the body after [param seconds], between two frames by interpolation; null while its
## frames are not there, and behind the last one.
func place_at(seconds: float) -> Vec2:
	var frames := seconds * Engine.physics_ticks_per_second
	var before := floori(frames)
	if ceili(frames) >= _places.size():
		return null
	return _places[before].lerped(_places[ceili(frames)], frames - before)


## Frees the body and its space.
func finish() -> void:
	_stop()
	_space.free()


# Each frame begins with this: the body is where the frames before have left it, at first where it
# starts, unless it was added during a frame. Read from the physics server, because the node is one
# step behind.
func _keep_place() -> void:
	var state: Transform2D = PhysicsServer2D.body_get_state(
		_body, PhysicsServer2D.BODY_STATE_TRANSFORM
	)
	var is_at_start := state.origin == _places[0].to_vector2()
	var waits := _waits_for_first and is_at_start
	_waits_for_first = false
	if waits:
		return
	_places.append(Vec2.from_vector2(state.origin))
	var way := _way_of(_places[-1])
	var length := _line.length()
	if way >= length:
		var before := _way_of(_places[-2])
		var share := (length - before) / (way - before)
		end_time = (_places.size() - 2 + share) / Engine.physics_ticks_per_second
	if has_ended():
		_stop()
		ended.emit()


func _way_of(place: Vec2) -> float:
	return place.minus(_line.start).scalar_projection(_line.along())


func _stop() -> void:
	if _tree.physics_frame.is_connected(_keep_place):
		_tree.physics_frame.disconnect(_keep_place)
