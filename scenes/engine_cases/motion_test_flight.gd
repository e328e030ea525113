class_name MotionTestFlight
extends ShotFlight
## A ball's flight by PhysicsServer2D.body_test_motion: the engine returns how far the ball can move
## and the normal of the wall; position and velocity are kept here.

var _host: Node
var _is_one_shape: bool
var _space: EngineSpace
var _body: CharacterBody2D
var _velocity: Vector2
var _place: Vector2


func _init(host: Node, is_one_shape: bool, of_shot: Shot, at_rate: int) -> void:
	super(of_shot, at_rate)
	_host = host
	_is_one_shape = is_one_shape
	method = "body_test_motion, " + ("concave shape" if is_one_shape else "segments")
	is_baseline = true


func _prepare() -> void:
	_space = EngineSpace.new(_host)
	_space.add_walls(shot.segments(), _is_one_shape)
	_body = CharacterBody2D.new()
	_space.add_ball(_body, shot.ball)
	_velocity = shot.ball.velocity.to_vector2()
	_place = shot.ball.position.to_vector2()


func _fly(count: int) -> void:
	var body := _body.get_rid()
	var velocity := _velocity
	var place := _place
	var parameters := PhysicsTestMotionParameters2D.new()
	var met := PhysicsTestMotionResult2D.new()
	var start := Time.get_ticks_usec()
	for i in count:
		var motion := velocity * step_seconds
		for contact in EngineSpace.MOST_CONTACTS:
			parameters.from = Transform2D(0.0, place)
			parameters.motion = motion
			var is_hit := PhysicsServer2D.body_test_motion(body, parameters, met)
			place += met.get_travel()
			if not is_hit:
				break
			var normal := met.get_collision_normal()
			velocity = velocity.bounce(normal)
			motion = met.get_remainder().bounce(normal)
		_x = place.x
		_y = place.y
	_spent = Time.get_ticks_usec() - start
	_velocity = velocity
	_place = place


func _clear() -> void:
	_space.free()
