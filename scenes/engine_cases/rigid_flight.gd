class_name RigidFlight
extends ShotFlight
## A ball's flight by RigidBody2D, which the engine moves in its own physics frames.

## The names of the methods in tables, by their continuous detection.
const MODES: Dictionary[RigidBody2D.CCDMode, String] = {
	RigidBody2D.CCD_MODE_DISABLED: "RigidBody2D",
	RigidBody2D.CCD_MODE_CAST_RAY: "RigidBody2D, CCD ray",
	RigidBody2D.CCD_MODE_CAST_SHAPE: "RigidBody2D, CCD shape",
}

var _host: Node
var _mode: RigidBody2D.CCDMode
var _space: EngineSpace
var _body: RID
var _frames: PhysicsFrames


func _init(host: Node, mode: RigidBody2D.CCDMode, of_shot: Shot, at_rate: int) -> void:
	super(of_shot, at_rate)
	_host = host
	_mode = mode
	method = MODES[mode]
	is_baseline = true
	needs_frames = true


func _prepare() -> void:
	_frames = PhysicsFrames.new(_host.get_tree())
	await _frames.begin(rate)
	_space = EngineSpace.new(_host)
	_space.add_walls(shot.segments(), false)
	_body = _space.add_rigid_ball(shot.ball, _mode).get_rid()


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
	_x = state.origin.x
	_y = state.origin.y
