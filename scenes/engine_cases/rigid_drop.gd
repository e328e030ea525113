class_name RigidDrop
extends DropCase
## The dropped ball by RigidBody2D, on a floor of one segment.

var _host: Node
var _space: EngineSpace
var _frames: PhysicsFrames
var _body: RID


func _init(host: Node, with_bounciness: float, at_rate: int) -> void:
	super(with_bounciness, at_rate)
	_host = host
	method = "RigidBody2D"
	is_baseline = true
	needs_frames = true


func _prepare() -> void:
	_frames = PhysicsFrames.new(_host.get_tree())
	await _frames.begin(rate)
	_space = EngineSpace.new(_host)
	_space.set_gravity(DroppedBall.GRAVITY)
	_space.add_walls(DroppedBall.floors(), false)
	var body := _space.add_rigid_ball(DroppedBall.ball(), RigidBody2D.CCD_MODE_DISABLED)
	body.physics_material_override.bounce = bounciness
	_body = body.get_rid()


func _fly(count: int) -> void:
	_spent = await _frames.pass_by(count, _read)


func _clear() -> void:
	_space.free()
	_frames.end()


# Reads from the physics server, because the node is one step behind.
func _read() -> void:
	var state: Transform2D = PhysicsServer2D.body_get_state(
		_body, PhysicsServer2D.BODY_STATE_TRANSFORM
	)
	var velocity: Vector2 = PhysicsServer2D.body_get_state(
		_body, PhysicsServer2D.BODY_STATE_LINEAR_VELOCITY
	)
	_height = -state.origin.y - DroppedBall.RADIUS
	_speed = -velocity.y
