class_name RigidCrowd
extends CrowdFlight
## Many balls by RigidBody2D.

var _host: Node
var _frames: PhysicsFrames
var _space: EngineSpace
var _bodies: Array[RID] = []


func _init(host: Node, of_crowd: Crowd, at_rate: int) -> void:
	super(of_crowd, at_rate)
	_host = host
	method = "RigidBody2D"
	is_baseline = true
	needs_frames = true


func _prepare() -> void:
	_frames = PhysicsFrames.new(_host.get_tree())
	await _frames.begin(rate)
	_space = EngineSpace.new(_host)
	_space.add_walls(crowd.walls(), false)
	_bodies.clear()
	for ball in crowd.balls():
		var body := _space.add_rigid_ball(ball, RigidBody2D.CCD_MODE_DISABLED)
		_bodies.append(body.get_rid())


func _fly(count: int) -> void:
	_spent = await _frames.pass_by(count, _read)


func _clear() -> void:
	_space.free()
	_frames.end()


# Reads from the physics server, because the nodes are one step behind.
func _read() -> void:
	var at := 0
	for body in _bodies:
		var state: Transform2D = PhysicsServer2D.body_get_state(
			body, PhysicsServer2D.BODY_STATE_TRANSFORM
		)
		_places[at] = state.origin.x
		_places[at + 1] = state.origin.y
		at += 2


func _velocities() -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	for body in _bodies:
		var velocity: Vector2 = PhysicsServer2D.body_get_state(
			body, PhysicsServer2D.BODY_STATE_LINEAR_VELOCITY
		)
		found.append(velocity.x)
		found.append(velocity.y)
	return found


func _turn_round() -> void:
	for body in _bodies:
		var velocity: Vector2 = PhysicsServer2D.body_get_state(
			body, PhysicsServer2D.BODY_STATE_LINEAR_VELOCITY
		)
		PhysicsServer2D.body_set_state(body, PhysicsServer2D.BODY_STATE_LINEAR_VELOCITY, -velocity)
