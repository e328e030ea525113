class_name MotionTestBoxFlight
extends BoxFlight
## The ball in the box by PhysicsServer2D.body_test_motion: the engine says how far the motion is
## safe and which way the wall faces; position and velocity are kept here.

var _host: Node
var _is_one_shape: bool
var _space: PeerSpace
var _body: CharacterBody2D


func _init(
	host: Node, is_one_shape: bool, at_speed: float, for_seconds: float, at_rate: int
) -> void:
	super(at_speed, for_seconds, at_rate)
	_host = host
	_is_one_shape = is_one_shape
	method = "body_test_motion, " + ("concave shape" if is_one_shape else "segments")
	is_peer = true


func _prepare() -> void:
	_space = PeerSpace.new(_host)
	_space.add_walls(BallInBox.walls(), _is_one_shape)
	_body = CharacterBody2D.new()
	_space.add_ball(_body, BallInBox.ball(speed))


func _fly(count: int) -> void:
	var body := _body.get_rid()
	var ball := BallInBox.ball(speed)
	var velocity := ball.velocity.to_vector2()
	var place := ball.position.to_vector2()
	var parameters := PhysicsTestMotionParameters2D.new()
	var result := PhysicsTestMotionResult2D.new()
	var seconds_a_step := step_seconds
	var start := Time.get_ticks_usec()
	for i in count:
		var motion := velocity * seconds_a_step
		for contact in PeerSpace.MOST_CONTACTS:
			parameters.from = Transform2D(0.0, place)
			parameters.motion = motion
			var is_hit := PhysicsServer2D.body_test_motion(body, parameters, result)
			place += result.get_travel()
			if not is_hit:
				break
			var normal := result.get_collision_normal()
			velocity = velocity.bounce(normal)
			motion = result.get_remainder().bounce(normal)
		_x = place.x
		_y = place.y
	_spent = Time.get_ticks_usec() - start


func _clear() -> void:
	_space.free()
