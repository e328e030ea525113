class_name RigidFlight
extends BallFlight
## A ball's flight by RigidBody2D, which the engine moves in its own physics frames. What a frame
## takes in which nothing moves is taken off.

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
# The places after each step.
var _places: PackedFloat64Array = []


func _init(host: Node, mode: RigidBody2D.CCDMode, of_shot: Shot, at_rate: int) -> void:
	super(of_shot, at_rate)
	_host = host
	_mode = mode
	method = MODES[mode]
	is_peer = true
	needs_frames = true


func _prepare() -> void:
	_places.clear()


func _fly(count: int) -> void:
	var frames := PhysicsFrames.new(_host.get_tree())
	await frames.begin(rate)
	var empty := await frames.empty_step()
	_space = PeerSpace.new(_host)
	_space.add_walls(shot.segments, false)
	_body = _space.add_rigid_ball(shot.ball, _mode).get_rid()
	var spent := await frames.pass_by(count, _read)
	frames.end()
	_spent = maxf(spent - empty * count, 1.0)


# The engine's frames cannot be stopped and gone on with: all in one.
func _path_of(frames: int) -> PackedFloat64Array:
	var steps_per_frame := floori(float(rate) / 60.0)
	_prepare()
	await _fly(frames * steps_per_frame)
	var path: PackedFloat64Array = []
	for frame in frames:
		var at := 2 * ((frame + 1) * steps_per_frame - 1)
		path.append(_places[at])
		path.append(_places[at + 1])
	return path


func _clear() -> void:
	_space.free()


# What the server knows: the node is a step behind.
func _read() -> void:
	var state: Transform2D = PhysicsServer2D.body_get_state(
		_body, PhysicsServer2D.BODY_STATE_TRANSFORM
	)
	_x = state.origin.x
	_y = state.origin.y
	_places.append(_x)
	_places.append(_y)
