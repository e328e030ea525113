class_name RigidDrop
extends DropCase
## The dropped ball by RigidBody2D, on a floor of one segment. What a frame takes in which nothing
## moves is taken off.

var _host: Node
var _space: PeerSpace
var _body: RID


func _init(host: Node, with_bounciness: float, at_rate: int) -> void:
	super(with_bounciness, at_rate)
	_host = host
	method = "RigidBody2D"
	is_peer = true
	needs_frames = true


func _prepare() -> void:
	pass


func _fly(count: int) -> void:
	var frames := PhysicsFrames.new(_host.get_tree())
	await frames.begin(rate)
	var empty := await frames.empty_step()
	_space = PeerSpace.new(_host)
	_space.set_gravity(DroppedBall.GRAVITY)
	_space.add_walls([LineSegment.new(Vec2.new(-500.0, 0.0), Vec2.new(500.0, 0.0))], false)
	var start := Vec2.new(0.0, -DroppedBall.HEIGHT - DroppedBall.RADIUS)
	var body := _space.add_rigid_ball(
		Ball.new(start, DroppedBall.RADIUS), RigidBody2D.CCD_MODE_DISABLED
	)
	body.physics_material_override.bounce = bounciness
	_body = body.get_rid()
	var spent := await frames.pass_by(count, _read)
	frames.end()
	_spent = maxf(spent - empty * count, 1.0)


func _clear() -> void:
	_space.free()


# What the server knows: the node is a step behind.
func _read() -> void:
	var state: Transform2D = PhysicsServer2D.body_get_state(
		_body, PhysicsServer2D.BODY_STATE_TRANSFORM
	)
	var velocity: Vector2 = PhysicsServer2D.body_get_state(
		_body, PhysicsServer2D.BODY_STATE_LINEAR_VELOCITY
	)
	_height = -state.origin.y - DroppedBall.RADIUS
	_speed = -velocity.y
