class_name RigidBoxFlight
extends BoxFlight
## The ball in the box by RigidBody2D, which the engine moves in its own physics frames. What a
## frame takes in which nothing moves is taken off.

## How the ways of continuous detection are named in tables.
const MODES: Dictionary[RigidBody2D.CCDMode, String] = {
	RigidBody2D.CCD_MODE_DISABLED: "RigidBody2D",
	RigidBody2D.CCD_MODE_CAST_RAY: "RigidBody2D, CCD ray",
	RigidBody2D.CCD_MODE_CAST_SHAPE: "RigidBody2D, CCD shape",
}

var _host: Node
var _mode: RigidBody2D.CCDMode
var _space: PeerSpace
var _body: RID


func _init(
	host: Node, mode: RigidBody2D.CCDMode, at_speed: float, for_seconds: float, at_rate: int
) -> void:
	super(at_speed, for_seconds, at_rate)
	_host = host
	_mode = mode
	method = MODES[mode]
	is_peer = true
	needs_frames = true


func _prepare() -> void:
	pass


func _fly(count: int) -> void:
	var frames := PhysicsFrames.new(_host.get_tree())
	await frames.begin(rate)
	var empty := await frames.empty_step()
	_space = PeerSpace.new(_host)
	_space.add_walls(BallInBox.walls(), true)
	_body = _space.add_rigid_ball(BallInBox.ball(speed), _mode).get_rid()
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
	_x = state.origin.x
	_y = state.origin.y
