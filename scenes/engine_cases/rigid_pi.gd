class_name RigidPi
extends PiCase
## Two blocks and a wall by RigidBody2D: two round bodies on a line. A step that changes the
## velocity of the light body counts as an impact.

# The radius of both bodies, in pixels.
const _RADIUS := 10.0
# Pixels per second. A smaller change of velocity is no impact.
const _LEAST_CHANGE := 1e-3

var _host: Node
var _rate: int
var _light: RID
var _speed := 0.0


func _init(host: Node, of_n: int, at_rate: int) -> void:
	super(of_n)
	_host = host
	_rate = at_rate
	method = "RigidBody2D"
	tuning = "%d Hz" % at_rate
	is_baseline = true
	needs_frames = true


func _count_impacts() -> void:
	var frames := PhysicsFrames.new(_host.get_tree())
	await frames.begin(_rate)
	var space := EngineSpace.new(_host)
	space.add_walls([LineSegment.new(Vec2.new(0.0, -50.0), Vec2.new(0.0, 50.0))], false)
	_light = _add(space, TwoBlocks.LIGHT_START + _RADIUS, 0.0, 1.0).get_rid()
	_add(space, TwoBlocks.HEAVY_START + 3.0 * _RADIUS, TwoBlocks.HEAVY_SPEED, mass_ratio())
	_count = 0
	_speed = 0.0
	_spent = await frames.pass_by(roundi(SECONDS * _rate), _read)
	space.free()
	frames.end()


func _add(space: EngineSpace, x: float, speed: float, mass: float) -> RigidBody2D:
	var ball := Ball.new(Vec2.new(x, 0.0), _RADIUS, Vec2.new(speed, 0.0), mass)
	return space.add_rigid_ball(ball, RigidBody2D.CCD_MODE_DISABLED)


func _read() -> void:
	var velocity: Vector2 = PhysicsServer2D.body_get_state(
		_light, PhysicsServer2D.BODY_STATE_LINEAR_VELOCITY
	)
	if absf(velocity.x - _speed) > _LEAST_CHANGE:
		_count += 1
	_speed = velocity.x
